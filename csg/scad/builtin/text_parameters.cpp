#include "csg/scad/builtin/text_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "csg/scad/builtin/writing_system.h"

namespace csg::scad {

namespace {

/// `em` is the true size of a font; a `size` is taken as points at 100 dots per inch.
constexpr double kSizePerEm = 72.0 / 100.0;

}  // namespace

Text read_text_parameters(std::string_view caller, const std::function<const Value&(std::string_view)>& parameter,
                          const std::function<void(std::string)>& warn) {
    const auto has_type = [&](const Value& value, std::string_view name, ValueType type) {
        if (value.type() == type) {
            return true;
        }
        if (!value.is_undef()) {
            warn(fmt::format("{}(..., {}={}) Invalid type: expected {}, found {}", caller, name, value.echo_text(),
                             type_name(type), type_name(value.type())));
        }
        return false;
    };
    const auto read_number = [&](std::string_view name, double& number) {
        const Value& value = parameter(name);
        if (has_type(value, name, ValueType::Number)) {
            number = value.number();
            return true;
        }
        return false;
    };
    const auto read_string = [&](std::string_view name, std::string& text) {
        const Value& value = parameter(name);
        if (has_type(value, name, ValueType::String)) {
            text = value.string();
        }
    };
    Text text;
    text.direction.clear();
    const bool sized = read_number("size", text.size);
    if (double em = 0; read_number("em", em)) {
        if (sized) {
            warn(fmt::format("{}: \"size\" ignored when \"em\" is set", caller));
        }
        text.size = em * kSizePerEm;
    }
    read_string("text", text.text);
    read_number("spacing", text.spacing);
    read_string("font", text.font);
    read_string("direction", text.direction);
    read_string("language", text.language);
    read_string("script", text.script);
    read_string("halign", text.halign);
    read_string("valign", text.valign);
    text.script = text.script.empty() ? script_of_text(text.text) : script_tag(text.script);
    static constexpr std::array<std::string_view, 4> kDirections{"ltr", "rtl", "ttb", "btt"};
    if (std::find(kDirections.begin(), kDirections.end(), text.direction) == kDirections.end()) {
        text.direction = is_right_to_left(text.script) ? "rtl" : "ltr";
    }
    return text;
}

}  // namespace csg::scad
