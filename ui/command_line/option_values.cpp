#include "ui/command_line/option_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ui {

std::vector<double> read_numbers(std::string_view option, std::string_view text,
                                 std::initializer_list<std::size_t> counts, std::string_view meaning) {
    std::vector<double> numbers;
    bool good = true;
    for (const char *at = text.data(), *end = at + text.size(); good;) {
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        good = error == std::errc{} && std::isfinite(value) && (next == end || *next == ',');
        numbers.push_back(value);
        if (!good || next == end) {
            break;
        }
        at = next + 1;
    }
    if (!good || std::find(counts.begin(), counts.end(), numbers.size()) == counts.end()) {
        throw UsageError(fmt::format("{} {}: expected {}", option, text, meaning));
    }
    return numbers;
}

std::vector<std::string> names_of(std::string_view text) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (end == begin) {
            return {};
        }
        names.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

glm::ivec2 read_size(std::string_view text, std::initializer_list<std::size_t> counts, int least, int most) {
    const auto n = read_numbers("--imgsize", text, counts, "width,height");
    for (const double side : n) {
        if (side != std::floor(side) || side < least || side > most) {
            throw UsageError(fmt::format("--imgsize {}: a side is a whole number from {} to {}", text, least, most));
        }
    }
    return {static_cast<int>(n.front()), static_cast<int>(n.back())};
}

int read_integer(std::string_view option, std::string_view text, int lowest, int highest) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < lowest || value > highest) {
        throw UsageError(fmt::format("{} {}: expected a whole number from {} to {}", option, text, lowest, highest));
    }
    return value;
}

base::Camera read_camera(std::string_view text, bool any_distance) {
    const auto n = read_numbers("--camera", text, {6, 7},
                                "6 numbers eye_x,y,z,center_x,y,z or 7 numbers translate_x,y,z,rot_x,y,z,distance");
    if (n.size() == 6) {
        if (n[0] == n[3] && n[1] == n[4] && n[2] == n[5]) {
            throw UsageError(fmt::format("--camera {}: the eye and the center are the same point", text));
        }
        return base::camera_between({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
    }
    if (n[6] < 0 || (n[6] == 0 && !any_distance)) {
        throw UsageError(fmt::format("--camera {}: the distance must be above 0 (or 0, with --viewall)", text));
    }
    base::Camera camera;
    camera.target = {n[0], n[1], n[2]};
    camera.rotation = {n[3], n[4], n[5]};
    camera.distance = n[6] > 0 ? n[6] : camera.distance;
    return camera;
}

}  // namespace ui
