#include "csg/scad/builtin/builtin_modules.h"

#include <algorithm>
#include <cmath>

namespace csg::scad {

BuiltinModule find_builtin_module(std::string_view name) {
    for (const auto& table :
         {control_modules(), shape_modules(), flat_modules(), transform_modules(), mesh_modules(), file_modules()}) {
        const auto found =
            std::find_if(table.begin(), table.end(), [&](const ModuleEntry& e) { return e.name == name; });
        if (found != table.end()) {
            return found->run;
        }
    }
    return nullptr;
}

Nodes ModuleContext::children() const {
    Nodes nodes;
    evaluator.children_of(instantiation, frame, nodes);
    return nodes;
}

void ModuleContext::expect_no_children() const {
    const BlockId children = instantiation.children;
    if (children != kNone && evaluator.program().blocks[children].instantiations.count != 0) {
        warn(fmt::format("module {}() does not support child modules", name()));
    }
}

ModuleArguments::ModuleArguments(const ModuleContext& context, std::span<const std::string_view> positional,
                                 std::span<const std::string_view> named)
    : mark_(context.evaluator), positional_(positional), named_(named) {
    Evaluator& evaluator = context.evaluator;
    std::uint32_t by_name = 0;
    std::uint32_t by_position = 0;
    std::size_t position = 0;
    bool too_many = false;
    struct Dynamic {
        const Argument* argument;
        Value value;
    };
    std::vector<Dynamic> dynamics;  // Bound when all arguments have been worked out.
    for (const Argument& a : evaluator.program().arguments_of(context.instantiation)) {
        Value value = evaluator.statement_value(a.value, context.frame);
        if (a.name == kNoSymbol) {
            while (position < positional.size() && (by_name >> position & 1U) != 0) {
                ++position;
            }
            if (position < positional.size()) {
                by_position |= 1U << position;
                values_[position++] = std::move(value);
            } else if (!too_many) {
                too_many = true;
                context.warn("Too many unnamed arguments supplied");
            }
            continue;
        }
        const std::string& argument_name = evaluator.name(a.name);
        if (const std::size_t i = index_of(argument_name); i < kMost) {
            if ((by_name >> i & 1U) != 0) {
                context.warn(fmt::format("argument \"{}\" supplied more than once", argument_name));
            } else if ((by_position >> i & 1U) != 0) {
                context.warn(fmt::format("argument \"{}\" overrides positional argument", argument_name));
            }
            by_name |= 1U << i;
            values_[i] = std::move(value);
        } else if (evaluator.dynamic_name(a.name)) {
            if (std::any_of(dynamics.begin(), dynamics.end(),
                            [&](const Dynamic& d) { return d.argument->name == a.name; })) {
                context.warn(fmt::format("argument \"{}\" supplied more than once", argument_name));
            }
            dynamics.push_back({&a, std::move(value)});
        } else {
            context.warn(fmt::format("variable \"{}\" not specified as parameter", argument_name));
        }
    }
    given_ = by_name | by_position;
    for (Dynamic& d : dynamics) {
        evaluator.bind_dynamic(*d.argument, std::move(d.value));
    }
}

std::size_t ModuleArguments::index_of(std::string_view parameter) const {
    for (std::size_t i = 0; i < positional_.size(); ++i) {
        if (positional_[i] == parameter) {
            return i;
        }
    }
    for (std::size_t i = 0; i < named_.size(); ++i) {
        if (named_[i] == parameter) {
            return positional_.size() + i;
        }
    }
    return kMost;
}

std::optional<double> ModuleArguments::number(std::string_view parameter) const {
    const Value& value = (*this)[parameter];
    return value.is_number() ? std::optional(value.number()) : std::nullopt;
}

void add_leaf(const ModuleContext& c, LeafShape shape, Nodes& out) {
    out.push_back(c.evaluator.builder().leaf(std::move(shape), c.location(), c.modifiers));
}

bool is_true(const Value& value) {
    return value.is_bool() && value.boolean();
}

bool is_positive(double x) {
    return x > 0 && std::isfinite(x);
}

unsigned whole(const std::optional<double>& number, unsigned otherwise) {
    return number && *number >= 1 && *number < 4294967296.0 ? static_cast<unsigned>(*number) : otherwise;
}

std::optional<double> radius(const ModuleContext& c, const ModuleArguments& arguments, std::string_view r,
                             std::string_view d) {
    const auto as_radius = arguments.number(r);
    const auto as_diameter = arguments.number(d);
    if (as_radius && as_diameter) {
        c.warn(fmt::format("Ignoring radius variable \"{}\" as diameter \"{}\" is defined too.", r, d));
    }
    return as_diameter ? std::optional(*as_diameter / 2) : as_radius;
}

bool to_vec2(const Value& value, glm::dvec2& out) {
    const auto elements = value.is_vector() ? value.elements() : std::span<const Value>();
    if (elements.size() != 2 || !elements[0].is_number() || !elements[1].is_number()) {
        return false;
    }
    out = {elements[0].number(), elements[1].number()};
    return true;
}

bool to_vec3(const Value& value, glm::dvec3& out, double z_if_missing) {
    const auto elements = value.is_vector() ? value.elements() : std::span<const Value>();
    const bool two = elements.size() == 2 && !std::isnan(z_if_missing);
    const bool numbers = std::all_of(elements.begin(), elements.end(), [](const Value& e) { return e.is_number(); });
    if (two && !numbers) {
        out.z = z_if_missing;
        return true;
    }
    if ((elements.size() != 3 && !two) || !numbers) {
        return false;
    }
    out = {elements[0].number(), elements[1].number(), two ? z_if_missing : elements[2].number()};
    return true;
}

}  // namespace csg::scad
