#include "csg/solid/dxf_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "csg/tree/degrees.h"

namespace csg::solid {
namespace {

/// Group code 70 of a DIMENSION: the kind in its low bits.
enum class DimensionKind { Rotated, Aligned, Angular, Diameter, Radius, ThreePointAngle, Ordinate };
constexpr int kKindBits = 7;
constexpr int kOrdinateX = 64;  ///< Of the flags: the ordinate is that of x.

/// Definition points of a DIMENSION, by their group code; 11, 12 and 16 are places of texts and arcs, which stay
/// where they are relative to the others.
class Points {
  public:
    Points(const DxfEntity& entity, const Import& import) : entity_(entity), import_(import) {}
    [[nodiscard]] glm::dvec2 operator()(int code) const {
        const bool relative = code == 11 || code == 12 || code == 16;
        return (entity_.point(code) - (relative ? glm::dvec2(0.0) : import_.origin)) * import_.scale;
    }

  private:
    const DxfEntity& entity_;
    const Import& import_;
};

double angle_of(const glm::dvec2& v) {
    return atan2_degrees(v.y, v.x);
}

std::optional<double> measure(const DxfEntity& e, const Import& import) {
    const int flags = e.flags();
    const Points at(e, import);
    switch (static_cast<DimensionKind>(flags & kKindBits)) {
        case DimensionKind::Rotated: {  // Projected on a line at an angle.
            const glm::dvec2 v = at(14) - at(13);
            return std::abs(v.x * cos_degrees(e.number(50)) + v.y * sin_degrees(e.number(50)));
        }
        case DimensionKind::Aligned:
            return glm::length(at(14) - at(13));
        case DimensionKind::Angular:
            return std::abs(angle_of(at(10) - at(15)) - angle_of(at(14) - at(13)));
        case DimensionKind::Diameter:
        case DimensionKind::Radius:
            return glm::length(at(15) - at(10));
        case DimensionKind::Ordinate:
            return (flags & kOrdinateX) != 0 ? at(13).x : at(13).y;
        default:
            return std::nullopt;
    }
}

/// The points of lines, by cells as large as OpenSCAD's coarse grid, within which points are one.
class LinePoints {
  public:
    explicit LinePoints(const std::vector<Loop>& lines) {
        for (const Loop& line : lines) {
            for (const glm::dvec2& p : line) {
                cells_.emplace(cell(p), Point{p, &line});
            }
        }
    }
    /// Whether a line other than `line` has a point there.
    [[nodiscard]] bool touched(const glm::dvec2& p, const Loop& line) const {
        const auto [x, y] = cell(p);
        for (long long i = x - 1; i <= x + 1; ++i) {
            for (long long j = y - 1; j <= y + 1; ++j) {
                const auto [from, to] = cells_.equal_range({i, j});
                if (std::any_of(from, to, [&](const auto& entry) {
                        return entry.second.line != &line && is_near(entry.second.at, p);
                    })) {
                    return true;
                }
            }
        }
        return false;
    }

  private:
    static constexpr double kNear = 0x1p-10;
    struct Point {
        glm::dvec2 at;
        const Loop* line;
    };
    static bool is_near(const glm::dvec2& a, const glm::dvec2& b) {
        return std::abs(a.x - b.x) <= kNear && std::abs(a.y - b.y) <= kNear;
    }
    static std::pair<long long, long long> cell(const glm::dvec2& p) {
        const auto whole = [](double x) {
            return static_cast<long long>(std::floor(std::clamp(x / kNear, -1e18, 1e18)));
        };
        return {whole(p.x), whole(p.y)};
    }
    std::multimap<std::pair<long long, long long>, Point> cells_;
};

}  // namespace

Measured<double> dxf_dimension(const DxfFile& file, const Import& import, const std::string& name,
                               std::string_view file_name) {
    const auto found = std::find_if(file.entities.begin(), file.entities.end(), [&](const DxfEntity& e) {
        return e.kind == "DIMENSION" && (import.layer.empty() || e.layer == import.layer) &&
               (name.empty() || e.text == name);
    });
    if (found == file.entities.end()) {
        return {std::nullopt,
                fmt::format("Can't find dimension '{}' in '{}', layer '{}'!", name, file_name, import.layer)};
    }
    if (const auto value = measure(*found, import)) {
        return {value, {}};
    }
    return {std::nullopt,
            fmt::format("Dimension '{}' in '{}', layer '{}' has unsupported type!", name, file_name, import.layer)};
}

Measured<glm::dvec2> dxf_cross(const DxfFile& file, const Import& import, std::string_view file_name,
                               Remarks& remarks) {
    const std::vector<Loop> lines = draw_dxf(file, import, remarks);
    const LinePoints points(lines);
    std::vector<const Loop*> alone;
    for (const Loop& line : lines) {
        if (line.size() == 2 && alone.size() < 2 && !points.touched(line.front(), line) &&
            !points.touched(line.back(), line)) {
            alone.push_back(&line);
        }
    }
    if (alone.size() == 2) {
        const glm::dvec2 a = alone[0]->front(), along = alone[0]->back() - a;
        const glm::dvec2 b = alone[1]->front(), across = alone[1]->back() - b;
        const double area = across.y * along.x - across.x * along.y;
        if (area != 0) {
            return {a + along * ((across.x * (a.y - b.y) - across.y * (a.x - b.x)) / area), {}};
        }
    }
    return {std::nullopt, fmt::format("Can't find cross in '{}', layer '{}'!", file_name, import.layer)};
}

}  // namespace csg::solid
