// What a map of thickness measures.
#pragma once

#include <cstdint>
#include <optional>

namespace ui {

struct ThicknessRequest {
    enum class What : std::uint8_t {
        Wall,  ///< From a face inwards to where the part ends.
        Gap,   ///< From a face outwards to where a part begins.
    };
    What what = What::Wall;
    bool along_view = false;      ///< Along the ray of the pixel, else along the face's normal.
    std::optional<double> range;  ///< World units: what is thicker looks the same; absent: by the picture.

    bool operator==(const ThicknessRequest&) const = default;
};

}  // namespace ui
