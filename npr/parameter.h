// Parameters of styles as data, from which the command line and the window build their controls.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace npr {

/// Number: float. Integer: int. Toggle: bool. Color: sRGB in [0, 1] (glm::vec3). Choice: index into the choices (int).
using Value = std::variant<float, int, bool, glm::vec3>;

enum class ParameterKind { Number, Integer, Toggle, Color, Choice };

/// What a parameter is; its values lie in [min, max] where it is a Number or an Integer. A length is a Number whose
/// values may be any up to kLongest, in pixels or in millimeters; [min, max] is then the range of controls, in pixels.
struct Parameter {
    std::string_view name;   ///< For the command line: lower case, words joined by '-'.
    std::string_view label;  ///< For the window.
    ParameterKind kind = ParameterKind::Number;
    Value initial;
    float min = 0;
    float max = 1;
    std::vector<std::string_view> choices{};
    bool is_length = false;

    static constexpr float kLongest = 1000;

    // One maker per kind.
    static Parameter number(std::string_view name, std::string_view label, float initial, float min, float max);
    static Parameter length(std::string_view name, std::string_view label, float initial, float min, float max);
    static Parameter integer(std::string_view name, std::string_view label, int initial, int min, int max);
    static Parameter toggle(std::string_view name, std::string_view label, bool initial);
    static Parameter color(std::string_view name, std::string_view label, const glm::vec3& initial);
    static Parameter choice(std::string_view name, std::string_view label, int initial,
                            std::vector<std::string_view> choices);
};

/// A style's values, in the order of its parameters.
class Parameters {
  public:
    /// Of a style that has none.
    Parameters() = default;
    /// All at their defaults. `parameters` must outlive this.
    explicit Parameters(std::span<const Parameter> parameters);

    [[nodiscard]] std::span<const Parameter> list() const { return {first_, values_.size()}; }
    /// The index of the parameter; none where there is no such.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    /// Value i.
    [[nodiscard]] const Value& at(std::size_t i) const { return values_[i]; }
    /// Whether it is a length in millimeters, not in pixels.
    [[nodiscard]] bool in_millimeters(std::size_t i) const { return millimeters_[i]; }

    /// Throws std::invalid_argument, naming the parameter and what it takes, where `value` is of another kind or out of
    /// range. Lengths are in pixels.
    void set(std::size_t i, const Value& value);
    /// Throws std::invalid_argument where there is no such parameter (the nearest name is told), too.
    void set(std::string_view name, const Value& value) { set(index(name), value); }
    /// The same from text: a number with a decimal point, of lengths also with px or mm behind it; on/off, true/false
    /// or 1/0; #rgb or #rrggbb; a choice's name.
    void read(std::string_view name, std::string_view text);

    /// The same values of the same list of parameters.
    bool operator==(const Parameters&) const = default;

  private:
    [[nodiscard]] std::size_t index(std::string_view name) const;

    const Parameter* first_ = nullptr;
    std::vector<Value> values_;
    std::vector<bool> millimeters_;
};

/// The value as Parameters::read takes it; colors are rounded to bytes.
[[nodiscard]] std::string text(const Parameter& parameter, const Value& value);

}  // namespace npr
