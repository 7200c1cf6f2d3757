// Parameters of styles as data, from which the command line and the window build their controls.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace npr {

/// Number: float. Integer: int. Toggle: bool. Color: sRGB in [0, 1] (glm::vec3). Choice: index into the choices (int).
using Value = std::variant<float, int, bool, glm::vec3>;

enum class ParameterKind { Number, Integer, Toggle, Color, Choice };

/// What a parameter is; its values lie in [min, max] where it is a Number or an Integer.
struct Parameter {
    std::string_view name;   ///< For the command line: lower case, words joined by '-'.
    std::string_view label;  ///< For the window.
    ParameterKind kind = ParameterKind::Number;
    Value initial;
    float min = 0;
    float max = 1;
    std::vector<std::string_view> choices{};

    // One maker per kind.
    static Parameter number(std::string_view name, std::string_view label, float initial, float min, float max);
    static Parameter integer(std::string_view name, std::string_view label, int initial, int min, int max);
    static Parameter toggle(std::string_view name, std::string_view label, bool initial);
    static Parameter color(std::string_view name, std::string_view label, const glm::vec3& initial);
    static Parameter choice(std::string_view name, std::string_view label, int initial,
                            std::vector<std::string_view> choices);
};

/// A style's values, in the order of its parameters.
class Parameters {
  public:
    /// All at their defaults. `parameters` must outlive this.
    explicit Parameters(std::span<const Parameter> parameters);

    [[nodiscard]] std::span<const Parameter> list() const { return list_; }
    /// -1 where there is no such parameter.
    [[nodiscard]] int find(std::string_view name) const;

    /// The index must be of a parameter of that kind.
    [[nodiscard]] float number(int i) const { return std::get<float>(at(i)); }
    [[nodiscard]] int integer(int i) const { return std::get<int>(at(i)); }
    [[nodiscard]] bool toggle(int i) const { return std::get<bool>(at(i)); }
    [[nodiscard]] glm::vec3 color(int i) const { return std::get<glm::vec3>(at(i)); }
    [[nodiscard]] int choice(int i) const { return std::get<int>(at(i)); }
    [[nodiscard]] const Value& at(int i) const { return values_[static_cast<std::size_t>(i)]; }

    /// Throws std::invalid_argument, naming the parameter and what it takes, where `value` is of another kind or out of
    /// range.
    void set(int i, const Value& value);
    /// The same from text: a number with a decimal point; on/off, true/false or 1/0; #rgb or #rrggbb; a choice's name.
    /// Throws std::invalid_argument where there is no such parameter (the nearest name is told), too.
    void set(std::string_view name, std::string_view text);

  private:
    std::span<const Parameter> list_;
    std::vector<Value> values_;
};

/// The value as Parameters::set reads it.
[[nodiscard]] std::string text(const Parameter& parameter, const Value& value);

}  // namespace npr
