// A style's settings: a struct whose fields are described once, in a table. From the table follow the parameters of the
// command line and the window, the struct filled from their values, and the shaders' uniforms with their declarations.
//
//     struct Settings {
//         float strength{};
//         static const SettingsTable<Settings>& table() {
//             static const SettingsTable<Settings> all{
//                 setting<&Settings::strength>(Parameter::number("strength", "Strength of lines", 0.5F, 0, 1)),
//             };
//             return all;
//         }
//     };
#pragma once

#include <fmt/format.h>

#include <glm/glm.hpp>
#include <initializer_list>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "npr/picture.h"

namespace npr {

/// The name under which the member is declared. C++20 has it in texts for people only: compilers end this function's
/// with "kMember = &npr::Settings::strength]".
template <auto kMember>
consteval std::string_view member_name() {
    std::string_view text = __PRETTY_FUNCTION__;
    text = text.substr(0, text.find_first_of("];", text.find("kMember = ")));
    text = text.substr(text.rfind(':') + 1);
    if (text.empty() || text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789") != std::string_view::npos) {
        throw std::logic_error("no name");  // Does not compile.
    }
    return text;
}

/// One line of a table: a field, and the parameter that gives it its value.
template <auto kMember>
struct Setting {
    std::optional<Parameter> parameter;
};

/// A field that has the value of a parameter: of the same type, or a number of another.
template <auto kMember>
[[nodiscard]] Setting<kMember> setting(Parameter parameter) {
    return {std::move(parameter)};
}
/// A field that is reckoned from others, in `complete`.
template <auto kMember>
[[nodiscard]] Setting<kMember> setting() {
    return {};
}

template <typename T>
[[nodiscard]] consteval std::string_view glsl_type() {
    if constexpr (std::is_same_v<T, float>) {
        return "float";
    } else if constexpr (std::is_same_v<T, bool>) {
        return "bool";
    } else if constexpr (std::is_same_v<T, int>) {
        return "int";
    } else if constexpr (std::is_same_v<T, glm::uint>) {
        return "uint";
    } else if constexpr (std::is_same_v<T, glm::vec2>) {
        return "vec2";
    } else if constexpr (std::is_same_v<T, glm::vec3>) {
        return "vec3";
    } else {
        static_assert(std::is_same_v<T, glm::vec4>, "no uniform of this type yet");
        return "vec4";
    }
}

/// What a uniform may hold.
using Uniform = std::variant<float, bool, int, glm::uint, glm::vec2, glm::vec3, glm::vec4>;

template <typename Settings>
class SettingsTable {
    struct Line {
        template <auto kMember>
        Line(Setting<kMember> setting)  // NOLINT(google-explicit-constructor): a table is a list of settings.
            : uniform(member_name<kMember>()),
              type(glsl_type<std::remove_cvref_t<decltype(std::declval<Settings&>().*kMember)>>()),
              parameter(std::move(setting.parameter)),
              assign([](Settings& s, const Value& value) { assign_to(s.*kMember, value); }),
              value([](const Settings& s) { return Uniform(s.*kMember); }) {}

        std::string uniform;
        std::string_view type;  ///< Of GLSL.
        std::optional<Parameter> parameter;
        void (*assign)(Settings&, const Value&);
        Uniform (*value)(const Settings&);
    };

  public:
    /// In the order of the parameters. Throws std::logic_error where a field cannot hold its parameter's values.
    SettingsTable(std::initializer_list<Line> lines) : lines_(lines) {
        Settings unused;
        for (const Line& line : lines_) {
            declarations_ += fmt::format("uniform {} {};\n", line.type, line.uniform);
            if (line.parameter) {
                line.assign(unused, line.parameter->initial);
                parameters_.push_back(*line.parameter);
            }
        }
    }

    [[nodiscard]] std::span<const Parameter> parameters() const { return parameters_; }
    /// In GLSL: what shaders find as "npr/settings.glsl".
    [[nodiscard]] std::string_view declarations() const { return declarations_; }

    /// `values`: of these parameters. Lengths become pixels.
    [[nodiscard]] Settings settings(const Parameters& values, double pixels_per_millimeter = 1) const {
        if (values.list().data() != parameters_.data()) {
            throw std::logic_error("the parameters are another style's");
        }
        Settings result;
        std::size_t i = 0;
        for (const Line& line : lines_) {
            if (line.parameter) {
                const auto scale = static_cast<float>(pixels_per_millimeter);
                line.assign(result,
                            values.in_millimeters(i) ? Value(std::get<float>(values.at(i)) * scale) : values.at(i));
                ++i;
            }
        }
        return result;
    }
    /// Sets those uniforms that the program (a gl::Program) has.
    template <typename Program>
    void set_uniforms(const Program& program, const Settings& settings) const {
        for (const Line& line : lines_) {
            std::visit([&](const auto& value) { program.set(line.uniform.c_str(), value); }, line.value(settings));
        }
    }

  private:
    template <typename Field>
    static void assign_to(Field& field, const Value& value) {
        std::visit(
            [&field](const auto& v) {
                using From = std::remove_cvref_t<decltype(v)>;
                if constexpr (std::is_same_v<From, Field> ||
                              (std::is_arithmetic_v<From> && std::is_arithmetic_v<Field>)) {
                    field = static_cast<Field>(v);
                } else {
                    throw std::logic_error("a setting is of another type than its parameter");
                }
            },
            value);
    }

    std::vector<Line> lines_;
    std::vector<Parameter> parameters_;
    std::string declarations_;
};

/// The settings of a picture's model of transparency.
template <typename Settings>
[[nodiscard]] Settings transparency_settings(const Picture& picture) {
    const SettingsTable<Settings>& table = Settings::table();
    const Parameters& given = picture.transparency_parameters;
    const bool own = !given.list().empty() && given.list().data() == table.parameters().data();
    return table.settings(own ? given : Parameters(table.parameters()));
}

/// The settings for a picture of this style. What is reckoned from others, or from the picture, is done by
/// `void complete(const Picture&)` where the struct has one.
template <typename Settings>
[[nodiscard]] Settings settings_of(const Picture& picture) {
    Settings settings = Settings::table().settings(picture.parameters, picture.pixels_per_millimeter());
    if constexpr (requires { settings.complete(picture); }) {
        settings.complete(picture);
    }
    return settings;
}

}  // namespace npr
