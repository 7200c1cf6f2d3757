#include "ui/pipeline/editing/shape_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <variant>

namespace ui {

namespace {

using csg::scad::ArgumentText;
using csg::scad::ByteRange;
using csg::scad::CallText;

double number_at(const std::string& text, const ByteRange& bytes) {
    return std::strtod(text.substr(bytes.begin, bytes.end - bytes.begin).c_str(), nullptr);
}

/// The argument of that name, or that stands there without one.
const ArgumentText* argument_of(const CallText& call, std::string_view name, std::size_t place) {
    for (const ArgumentText& argument : call.arguments) {
        if (argument.name == name) {
            return &argument;
        }
    }
    const bool there =
        place < call.arguments.size() &&
        std::all_of(call.arguments.begin(), call.arguments.begin() + static_cast<std::ptrdiff_t>(place) + 1,
                    [](const ArgumentText& argument) { return argument.name.empty(); });
    return there ? &call.arguments[place] : nullptr;
}

/// Adds numbers that are what the shape says.
class NumberList {
  public:
    NumberList(const CallText& call, const std::string& text) : call_(call), text_(text) {}

    /// `number`: that the argument must be, where it is written out; `place`: without its name, none: ~0.
    void add(const char* name, std::size_t place, double number, const glm::dvec3& at, const glm::dvec3& along,
             double per_unit) {
        const ArgumentText* const argument = argument_of(call_, name, place);
        if (argument != nullptr && argument->literals.size() == 1 && argument->literals[0].bytes == argument->value) {
            add(name, argument->value, number, at, along, per_unit);
        }
    }
    void add(const char* name, const ByteRange& bytes, double number, const glm::dvec3& at, const glm::dvec3& along,
             double per_unit) {
        if (number > 0 && std::abs(number_at(text_, bytes) - number) <= 1e-9 * number) {
            numbers_.push_back({name, bytes, number, at, along, per_unit});
        }
    }
    [[nodiscard]] std::vector<ShapeNumber> take() { return std::move(numbers_); }

  private:
    const CallText& call_;
    const std::string& text_;
    std::vector<ShapeNumber> numbers_;
};

constexpr std::size_t kNoPlace = ~std::size_t{0};

void add_numbers(const csg::Cube& cube, const CallText& call, NumberList& list) {
    const glm::dvec3 middle = cube.center ? glm::dvec3(0) : 0.5 * cube.size;
    const double per_unit = cube.center ? 2 : 1;
    const ArgumentText* const size = argument_of(call, "size", 0);
    const bool three = size != nullptr && size->literals.size() == 3;
    for (int i = 0; i < (three ? 3 : 1); ++i) {
        glm::dvec3 along(0), at = middle;
        along[i] = 1;
        at[i] += 0.5 * cube.size[i];
        if (three) {
            constexpr std::array kNames{"x", "y", "z"};
            list.add(kNames[static_cast<std::size_t>(i)], size->literals[static_cast<std::size_t>(i)].bytes,
                     cube.size[i], at, along, per_unit);
        } else {
            list.add("size", 0, cube.size.x, at, along, per_unit);
        }
    }
}

void add_numbers(const csg::Sphere& sphere, const CallText& /*call*/, NumberList& list) {
    const glm::dvec3 x(1, 0, 0), at = sphere.radius * x;
    list.add("r", 0, sphere.radius, at, x, 1);
    list.add("d", kNoPlace, 2 * sphere.radius, at, x, 2);
}

void add_numbers(const csg::Cylinder& cylinder, const CallText& /*call*/, NumberList& list) {
    const glm::dvec3 x(1, 0, 0), z(0, 0, 1);
    const double low = cylinder.center ? -0.5 * cylinder.height : 0, high = low + cylinder.height;
    list.add("h", 0, cylinder.height, high * z, z, cylinder.center ? 2 : 1);
    const double mean = 0.5 * (cylinder.radius1 + cylinder.radius2);
    if (cylinder.radius1 == cylinder.radius2) {
        list.add("r", kNoPlace, cylinder.radius1, mean * x + 0.5 * (low + high) * z, x, 1);
        list.add("d", kNoPlace, 2 * cylinder.radius1, mean * x + 0.5 * (low + high) * z, x, 2);
    }
    list.add("r1", 1, cylinder.radius1, cylinder.radius1 * x + low * z, x, 1);
    list.add("d1", kNoPlace, 2 * cylinder.radius1, cylinder.radius1 * x + low * z, x, 2);
    list.add("r2", 2, cylinder.radius2, cylinder.radius2 * x + high * z, x, 1);
    list.add("d2", kNoPlace, 2 * cylinder.radius2, cylinder.radius2 * x + high * z, x, 2);
}

}  // namespace

std::vector<ShapeNumber> shape_numbers(const csg::LeafShape& shape, const CallText& call, const std::string& text) {
    NumberList list(call, text);
    if (const auto* cube = std::get_if<csg::Cube>(&shape)) {
        add_numbers(*cube, call, list);
    } else if (const auto* sphere = std::get_if<csg::Sphere>(&shape)) {
        add_numbers(*sphere, call, list);
    } else if (const auto* cylinder = std::get_if<csg::Cylinder>(&shape)) {
        add_numbers(*cylinder, call, list);
    }
    return list.take();
}

}  // namespace ui
