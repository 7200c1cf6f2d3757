#include "ui/pipeline/editing/text_edit.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace ui {

std::string edited(const std::string& text, std::vector<TextEdit> edits) {
    std::sort(edits.begin(), edits.end(),
              [](const TextEdit& a, const TextEdit& b) { return a.bytes.begin < b.bytes.begin; });
    std::string result;
    std::size_t at = 0;
    for (const TextEdit& edit : edits) {
        result.append(text, at, edit.bytes.begin - at);
        result += edit.text;
        at = edit.bytes.end;
    }
    return result.append(text, at);
}

std::string short_number(double value, double tolerance) {
    for (int digits = 0; digits <= 17; ++digits) {
        std::string text = fmt::format("{:.{}f}", value, digits);
        if (std::abs(std::strtod(text.c_str(), nullptr) - value) <= tolerance) {
            return text.find_first_not_of("-0.") == std::string::npos ? "0" : text;
        }
    }
    return fmt::format("{}", value);
}

std::string short_vector(const glm::dvec3& v, double tolerance) {
    return fmt::format("[{}, {}, {}]", short_number(v.x, tolerance), short_number(v.y, tolerance),
                       short_number(v.z, tolerance));
}

}  // namespace ui
