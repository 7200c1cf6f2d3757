// The values that a for goes through.
#pragma once

#include "csg/scad/machine/evaluator.h"

namespace csg::scad {

/// Elements of a list, numbers of a range, characters of a string, keys of an object; any other value once, undef
/// never. Refers to the value it is made from.
class Sequence {
  public:
    /// Warns of a range that is too long, which then counts as empty.
    Sequence(const Value& value, Evaluator& evaluator, const SourceRange& where);
    /// How many values that is; the same warning.
    [[nodiscard]] static std::size_t count(const Value& value, Evaluator& evaluator, const SourceRange& where);
    [[nodiscard]] static std::size_t count(const Range& range, Evaluator& evaluator, const SourceRange& where);
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Value at(std::size_t i) const;

  private:
    const Value& value_;
    std::size_t size_ = 0;
    std::vector<std::string_view> characters_;
};

}  // namespace csg::scad
