// The built-in modules of the language.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "csg/scad/machine/evaluator.h"

namespace csg::scad {

/// One instantiation of a built-in module.
struct ModuleContext {
    Evaluator& evaluator;
    const Instantiation& instantiation;
    const Frame* frame;  ///< Where the instantiation stands.
    csg::Modifiers modifiers;

    [[nodiscard]] std::string_view name() const { return evaluator.name(instantiation.name); }
    [[nodiscard]] const SourceRange& where() const { return instantiation.where; }
    [[nodiscard]] SourceLocation location() const { return evaluator.location(instantiation.where); }
    void warn(std::string text) const { evaluator.warn(instantiation.where, std::move(text)); }
    /// The nodes of the children.
    [[nodiscard]] Nodes children() const;
    /// Warns where a module that makes a shape has children.
    void expect_no_children() const;
};

struct ModuleEntry {
    std::string_view name;
    BuiltinModule run;
};

[[nodiscard]] std::span<const ModuleEntry> control_modules();
[[nodiscard]] std::span<const ModuleEntry> shape_modules();
[[nodiscard]] std::span<const ModuleEntry> flat_modules();
[[nodiscard]] std::span<const ModuleEntry> mesh_modules();
[[nodiscard]] std::span<const ModuleEntry> file_modules();
[[nodiscard]] std::span<const ModuleEntry> transform_modules();

/// Null where there is none of that name.
[[nodiscard]] BuiltinModule find_builtin_module(std::string_view name);

/// Arguments of a built-in module, matched to its parameters. `$` arguments are bound as long as it lives.
class ModuleArguments {
  public:
    /// `positional` parameters may stand without a name, in this order; `named` only with theirs. Both lists must
    /// outlive it.
    ModuleArguments(const ModuleContext& context, std::span<const std::string_view> positional,
                    std::span<const std::string_view> named = {});

    /// undef where it is not given. `parameter` is one of those named above.
    [[nodiscard]] const Value& operator[](std::string_view parameter) const { return values_[index_of(parameter)]; }
    [[nodiscard]] bool given(std::string_view parameter) const { return (given_ >> index_of(parameter) & 1U) != 0; }
    /// Nothing where it is not given, or no number.
    [[nodiscard]] std::optional<double> number(std::string_view parameter) const;

  private:
    static constexpr std::size_t kMost = 15;  ///< Parameters of a module.
    [[nodiscard]] std::size_t index_of(std::string_view parameter) const;

    Evaluator::DynamicMark mark_;
    std::span<const std::string_view> positional_, named_;
    std::array<Value, kMost + 1> values_;  ///< The last is for names that there are not.
    std::uint32_t given_ = 0;
};

// What modules share.

void add_leaf(const ModuleContext& c, LeafShape shape, Nodes& out);

/// Only `true` itself: other values that count as true elsewhere do not here.
[[nodiscard]] bool is_true(const Value& value);

[[nodiscard]] bool is_positive(double x);

/// A number of at least 1; others count as `otherwise`.
[[nodiscard]] unsigned whole(const std::optional<double>& number, unsigned otherwise);

/// A radius given as such or as a diameter, which counts first.
[[nodiscard]] std::optional<double> radius(const ModuleContext& c, const ModuleArguments& arguments, std::string_view r,
                                           std::string_view d);

/// Two numbers.
[[nodiscard]] bool to_vec2(const Value& value, glm::dvec2& out);

/// Three numbers. `[x, y]` stands for `[x, y, z_if_missing]` unless that is NaN; where x or y is no number it gives the
/// third alone and passes for good, as in OpenSCAD.
[[nodiscard]] bool to_vec3(const Value& value, glm::dvec3& out, double z_if_missing);

}  // namespace csg::scad
