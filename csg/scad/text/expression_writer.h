// Writes expressions as source text without recursion. Internal to the texts of trees.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "csg/scad/syntax/ast.h"

namespace csg::scad {

class ExpressionWriter {
  public:
    ExpressionWriter(const Program& program, std::string& out) : p_(program), out_(out) {}

    void expression(ExprId id);
    /// "name = value, value": without parentheses. Parameters without default are bare names.
    void arguments(std::span<const Argument> arguments);

  private:
    /// What is still to be written: text that outlives the writer, or an expression.
    using Piece = std::variant<std::string_view, ExprId>;

    void run();
    void write(ExprId id);
    void literal(const Expr& e);
    void later(Piece piece) { gathered_.push_back(piece); }
    void later_arguments(std::span<const Argument> arguments);
    void later_call(std::string_view name, std::span<const Argument> arguments);
    void later_element(const Expr& e);
    void later_body(ExprId id);

    const Program& p_;
    std::string& out_;
    std::vector<Piece> stack_;     ///< The next piece last.
    std::vector<Piece> gathered_;  ///< Pieces of the expression being written, in order.
};

}  // namespace csg::scad
