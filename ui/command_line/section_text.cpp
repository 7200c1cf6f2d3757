#include "ui/command_line/section_text.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "ui/command_line/option_values.h"

namespace ui {

namespace {

constexpr std::string_view kExpected =
    "expected x=1, y>1, z<1, plane([x,y,z],[nx,ny,nz]), box([x,y,z],[x,y,z]), half, quarter, eighth or part:NAME";

std::string without_blanks(std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
    return text;
}

/// The two points of "name([x,y,z],[x,y,z])"; the inner brackets may be missing.
std::pair<glm::dvec3, glm::dvec3> read_points(const std::string& text, const std::string& name,
                                              std::string_view meaning) {
    std::string inner = text.substr(name.size());
    const auto shape_is_right = [&] {
        if (inner.size() < 2 || inner.front() != '(' || inner.back() != ')') {
            return false;
        }
        inner = inner.substr(1, inner.size() - 2);
        return inner.find('[') == std::string::npos ||
               (inner.front() == '[' && inner.back() == ']' && inner.find("],[") != std::string::npos);
    };
    if (!shape_is_right()) {
        throw UsageError(fmt::format("--section {}: expected {}([x,y,z],[x,y,z]), {}", text, name, meaning));
    }
    std::erase_if(inner, [](char c) { return c == '[' || c == ']'; });
    const auto n = read_numbers("--section", inner, {6}, meaning);
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

npr::PlaneSection read_plane(const std::string& text) {
    const auto [point, normal] = read_points(text, "plane", "a point of it and its normal");
    const double length = glm::length(normal);
    if (!(length > 0) || !std::isfinite(length)) {
        throw UsageError(fmt::format("--section {}: the normal has no direction", text));
    }
    npr::PlaneSection plane;
    plane.normal = normal / length;
    plane.offset = glm::dot(plane.normal, point);
    plane.away = npr::PlaneSection::Away::Beyond;
    return plane;
}

npr::BoxSection read_box(const std::string& text) {
    const auto [a, b] = read_points(text, "box", "two opposite corners");
    const npr::BoxSection box{glm::min(a, b), glm::max(a, b)};
    if (box.lo.x >= box.hi.x || box.lo.y >= box.hi.y || box.lo.z >= box.hi.z) {
        throw UsageError(fmt::format("--section {}: the box has no inside", text));
    }
    return box;
}

/// "z=12", "z>12", "z<12".
npr::PlaneSection read_axis(const std::string& text) {
    npr::PlaneSection plane;
    plane.normal = glm::dvec3(0.0);
    plane.normal[text[0] - 'x'] = 1;
    plane.offset = read_numbers("--section", text.substr(2), {1}, fmt::format("where on the {} axis", text[0]))[0];
    plane.away = text[1] == '=' ? npr::PlaneSection::Away::Eye : npr::PlaneSection::Away::Beyond;
    if (text[1] == '<') {
        plane.normal = -plane.normal;
        plane.offset = -plane.offset;
    }
    return plane;
}

bool is_axis(const std::string& text) {
    return text.size() > 2 && text[0] >= 'x' && text[0] <= 'z' &&
           std::string_view("=<>").find(text[1]) != std::string::npos;
}

}  // namespace

npr::Section read_section(const std::string& text) {
    if (text.starts_with("part:")) {
        const std::string name = text.substr(5);
        if (name.empty()) {
            throw UsageError(fmt::format("--section {}: expected part:NAME", text));
        }
        return {npr::PartSection{name}, text};
    }
    const std::string plain = without_blanks(text);
    if (is_axis(plain)) {
        return {read_axis(plain), text};
    }
    if (plain.starts_with("plane")) {
        return {read_plane(plain), text};
    }
    if (plain.starts_with("box")) {
        return {read_box(plain), text};
    }
    for (const auto& [name, axes] : {std::pair("half", 1), std::pair("quarter", 2), std::pair("eighth", 3)}) {
        if (plain == name) {
            return {npr::CornerSection{axes}, text};
        }
    }
    throw UsageError(fmt::format("--section {}: {}", text, kExpected));
}

npr::Sections read_sections(const std::vector<std::string>& cuts, const std::vector<std::string>& uncut,
                            const std::string& hatching) {
    npr::Sections sections;
    for (const std::string& text : cuts) {
        sections.cuts.push_back(read_section(text));
    }
    for (const std::string& names : uncut) {
        const std::vector<std::string> some = names_of(names);
        if (some.empty()) {
            throw UsageError(fmt::format("--uncut {}: expected NAME[,NAME]", names));
        }
        sections.uncut.insert(sections.uncut.end(), some.begin(), some.end());
    }
    if (cuts.empty() && !(uncut.empty() && hatching.empty())) {
        throw UsageError(fmt::format("{} needs a --section", uncut.empty() ? "--hatching" : "--uncut"));
    }
    if (!hatching.empty()) {
        sections.spacing = read_numbers("--hatching", hatching, {1}, "a length")[0];
        if (!(sections.spacing >= 0) || sections.spacing > 1e9) {
            throw UsageError(fmt::format("--hatching {}: a length from 0 to 1e9", hatching));
        }
    }
    return sections;
}

}  // namespace ui
