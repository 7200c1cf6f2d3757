#include "ui/command_line/measure_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "ui/command_line/option_values.h"

namespace ui {

namespace {

constexpr const char* kExpected =
    "expected [x,y,z], a pixel X,Y, edge@X,Y or corner@X,Y, or a shape by its call, LINE[:COLUMN] or +z@LINE[:COLUMN] "
    "(or -z, +x, …)";

/// Takes "#N" off the end.
void take_number(ThingText& thing, std::string& rest) {
    const std::size_t hash = rest.rfind('#');
    if (hash == std::string::npos) {
        return;
    }
    constexpr int kMost = 1'000'000'000;
    thing.number = static_cast<std::size_t>(
        read_integer(fmt::format("{} {}", thing.option, thing.text), rest.substr(hash + 1), 1, kMost));
    rest.resize(hash);
}

/// Takes "edge@", "+z@" off the front.
std::string take_what(std::string& rest) {
    const std::size_t at = rest.find('@');
    if (at == std::string::npos) {
        return "";
    }
    std::string what = rest.substr(0, at);
    rest.erase(0, at + 1);
    return what;
}

std::optional<glm::dvec3> direction_of(const std::string& what) {
    if (what.size() != 2 || (what[0] != '+' && what[0] != '-') || what[1] < 'x' || what[1] > 'z') {
        return std::nullopt;
    }
    glm::dvec3 direction(0);
    direction[what[1] - 'x'] = what[0] == '+' ? 1 : -1;
    return direction;
}

void read_pixel(ThingText& thing, const std::string& text, glm::ivec2 size) {
    const auto n = read_numbers(fmt::format("{} {}", thing.option, thing.text), text, {2}, "a pixel x,y");
    for (int i = 0; i < 2; ++i) {
        const double pixel = n[static_cast<std::size_t>(i)];
        if (pixel != std::floor(pixel) || pixel < 0 || pixel >= size[i]) {
            refuse(thing, fmt::format("pixels are whole numbers, from 0,0 to {},{} in a picture of {} × {} (--imgsize)",
                                      size.x - 1, size.y - 1, size.x, size.y));
        }
        thing.pixel[i] = static_cast<int>(pixel);
    }
}

}  // namespace

void refuse(const ThingText& thing, const std::string& why) {
    throw UsageError(fmt::format("{} {}: {}", thing.option, thing.text, why));
}

const std::vector<std::string>& measure_values() {
    static const std::vector<std::string> kNames{"radius",  "diameter", "length", "distance",
                                                 "minimum", "maximum",  "angle"};
    return kNames;
}

ThingText read_thing(const std::string& option, const std::string& text, glm::ivec2 size) {
    ThingText thing;
    thing.option = option;
    thing.text = text;
    std::string rest = text;
    const std::string what = take_what(rest);
    thing.towards = direction_of(what);
    if (what == "edge") {
        thing.what = ThingText::What::Edge;
    } else if (what == "corner") {
        thing.what = ThingText::What::Corner;
    } else if (!what.empty() && what != "face" && !thing.towards) {
        refuse(thing, kExpected);
    }
    const bool of_picture = thing.what != ThingText::What::Face;
    if (rest.starts_with('[') && rest.ends_with(']') && what.empty()) {
        const auto n = read_numbers(fmt::format("{} {}", option, text), rest.substr(1, rest.size() - 2), {3}, "x,y,z");
        thing.point = {n[0], n[1], n[2]};
        return thing;
    }
    take_number(thing, rest);
    if (rest.find(',') != std::string::npos && !thing.towards) {
        thing.where = ThingText::Where::Pixel;
        read_pixel(thing, rest, size);
        return thing;
    }
    const bool call = !rest.empty() && rest.back() >= '0' && rest.back() <= '9';
    if (!call || of_picture) {
        refuse(thing, kExpected);
    }
    thing.where = ThingText::Where::Source;
    thing.call = rest;
    return thing;
}

MeasureOptions read_measure(const std::vector<std::string>& of, const std::vector<std::string>& between,
                            const std::vector<std::string>& other, const std::string& value, const std::string& format,
                            glm::ivec2 size) {
    MeasureOptions measure;
    for (const std::string& text : of) {
        measure.of.push_back(read_thing("--of", text, size));
    }
    if (between.size() != other.size()) {
        throw UsageError("--between A goes with --and B");
    }
    for (std::size_t i = 0; i < between.size(); ++i) {
        measure.between.emplace_back(read_thing("--between", between[i], size), read_thing("--and", other[i], size));
    }
    if (measure.of.empty() && measure.between.empty()) {
        throw UsageError("there is nothing to measure: name it by --of A, or by --between A --and B");
    }
    if (!value.empty()) {
        std::vector<std::pair<std::string, std::string>> names;
        for (const std::string& name : measure_values()) {
            names.emplace_back(name, name);
        }
        measure.value = read_name<std::string>("--value", value, names);
    }
    measure.json = !format.empty() && read_name<bool>("--format", format, {{"text", false}, {"json", true}});
    return measure;
}

}  // namespace ui
