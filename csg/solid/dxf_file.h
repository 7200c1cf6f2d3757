// What a DXF file holds, before it is drawn or measured. Internal to csg/solid.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "csg/solid/outline.h"
#include "csg/solid/remarks.h"

namespace csg::solid {

struct DxfEntity {
    std::string kind, layer;
    std::map<int, double> numbers;               ///< The last of each code.
    std::vector<std::pair<int, double>> series;  ///< Those that may come several times, in their order.
    std::string block;                           ///< INSERT: the name.
    std::string text;                            ///< DIMENSION: the name.

    [[nodiscard]] double number(int code, double otherwise = 0) const {
        const auto found = numbers.find(code);
        return found == numbers.end() ? otherwise : found->second;
    }
    /// Group 70: bits, which fit into 16; 0 for other numbers.
    [[nodiscard]] int flags() const {
        const double bits = number(70);
        return bits >= 0 && bits < 65536 ? static_cast<int>(bits) : 0;
    }
    [[nodiscard]] glm::dvec2 point(int code) const { return {number(code), number(code + 10)}; }
};

struct DxfFile {
    using Blocks = std::map<std::string, std::vector<DxfEntity>>;
    std::vector<DxfEntity> entities;
    Blocks blocks;
};

[[nodiscard]] DxfFile read_dxf_file(std::string_view text);

/// The lines of the layer that `import` names (of all, where it names none), moved and scaled as it says. A line is
/// open, of at least two points; or closed, with the first point again at its end.
[[nodiscard]] std::vector<Loop> draw_dxf(const DxfFile& file, const Import& import, Remarks& remarks);

}  // namespace csg::solid
