// What csgscope measure is to tell, as its options name it.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ui {

/// A thing of a model: [WHAT@]WHERE[#N].
struct ThingText {
    enum class Where { Point, Pixel, Source };
    enum class What { Face, Edge, Corner };
    std::string option, text;  ///< As given, for messages.
    Where where = Where::Point;
    What what = What::Face;
    glm::dvec3 point{0.0};
    glm::ivec2 pixel{0};                ///< Counted from the upper left corner.
    std::string call;                   ///< A place as call_at takes it.
    std::optional<glm::dvec3> towards;  ///< That face of the shape called there.
    std::size_t number = 0;             ///< Which surface behind the pixel, or shape from the call, from 1 on; 0: none.
};

struct MeasureOptions {
    std::vector<ThingText> of;
    std::vector<std::pair<ThingText, ThingText>> between;
    std::string value;  ///< Of those of measure_values(), the only one to print; empty: all.
    bool json = false;
};

/// "radius", "diameter", …
[[nodiscard]] const std::vector<std::string>& measure_values();

/// Throws UsageError.
[[noreturn]] void refuse(const ThingText& thing, const std::string& why);

/// `size`: of the picture that pixels are counted in. Throws UsageError.
[[nodiscard]] ThingText read_thing(const std::string& option, const std::string& text, glm::ivec2 size);

/// The texts behind --of, --between, --and, --value and --format. Throws UsageError.
[[nodiscard]] MeasureOptions read_measure(const std::vector<std::string>& of, const std::vector<std::string>& between,
                                          const std::vector<std::string>& other, const std::string& value,
                                          const std::string& format, glm::ivec2 size);

}  // namespace ui
