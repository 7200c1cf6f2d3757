// Random outlines: on a small grid, a little off it, or of any numbers at all.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "csg/solid/extrude.h"
#include "csg/solid/indexed_outline.h"
#include "csg/solid/triangulate_region.h"
#include "tests/outlines/even_odd.h"

namespace {

using namespace csg::solid;

/// Small outlines have all the degeneracies that large ones have; some are large all the same.
constexpr std::size_t kMostCorners = 40, kFewCorners = 11;

void fail(const char* what) {
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

/// A byte is a corner of a 16 by 16 grid; 255 ends a loop. Every fourth corner may be off by a little.
std::vector<Loop> on_grid(const std::uint8_t* data, std::size_t size, double noise) {
    std::vector<Loop> loops(1);
    const std::size_t most = size > 100 ? kMostCorners : kFewCorners;
    for (std::size_t i = 0; i < std::min(size, most); ++i) {
        if (data[i] == 255) {
            loops.emplace_back();
        } else {
            loops.back().emplace_back(data[i] % 16 + (i % 4 == 0 ? noise : 0), data[i] / 16 - (i % 3 == 0 ? noise : 0));
        }
    }
    return loops;
}

std::vector<Loop> of_any_numbers(const std::uint8_t* data, std::size_t size) {
    std::vector<Loop> loops(1);
    for (std::size_t at = 0; at + 16 <= std::min(size, 16 * kMostCorners); at += 16) {
        glm::dvec2 p;
        std::memcpy(&p.x, data + at, 8);
        std::memcpy(&p.y, data + at + 8, 8);
        if (std::isnan(p.x)) {
            loops.emplace_back();
        } else {
            loops.back().push_back(p);
        }
    }
    return loops;
}

/// What holds whatever the numbers are; of the solid, which takes the most time, where `extruded`.
void check(const Outline& outline, bool extruded) {
    if (!is_region(outline)) {
        fail("the outline breaks the rule");
    }
    const IndexedOutline indexed = index_corners(outline);
    double sum = 0, all = 0;
    for (const glm::uvec3& t : triangulate_region(indexed)) {
        const double area = turn(indexed.points[t.x], indexed.points[t.y], indexed.points[t.z]) / 2;
        sum += area;
        all += std::abs(area);
    }
    // What is left beside slivers is rounding, by the size of the whole.
    const double size = bounds_of(outline.loops).diagonal();
    if (std::isfinite(all) && std::abs(sum - outline.area()) > 1e-6 * all + 1e-13 * size * size) {
        fail("triangles do not fill the outline");
    }
    if (!extruded) {
        return;
    }
    csg::LinearExtrude how;
    how.height = 1;
    const auto solid = linear_extrude(outline, how);
    if (!solid->triangles.empty() && !solid->closed) {
        fail("the solid is not closed");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 4) {
        return 0;
    }
    const int kind = data[0] % 4;
    const bool extruded = data[0] % 16 < 4;
    if (kind < 2) {
        const double noise = kind == 0 ? 0 : std::ldexp(data[1] - 128.0, -20 - data[2] % 32);
        const std::vector<Loop> loops = on_grid(data + 3, size - 3, noise);
        const Outline outline = clean(loops, FillRule::EvenOdd);
        check(outline, extruded);
        if (std::abs(outline.area() - outlines::even_odd_moments(loops).area) > 1e-6) {
            fail("the area is not that of the even-odd rule");
        }
        return 0;
    }
    const std::vector<Loop> loops = of_any_numbers(data + 3, size - 3);
    try {
        const Outline outline = clean(loops, kind == 2 ? FillRule::EvenOdd : FillRule::NonZero);
        check(outline, extruded);
        if (data[1] % 4 != 0) {
            return 0;
        }
        glm::dmat4 matrix(1.0);
        matrix[0][1] = data[1] / 16.0;
        matrix[3][0] = std::ldexp(1.0, data[2] % 64);
        check(transform(outline, matrix), extruded);
        csg::Offset offset_by;
        offset_by.distance = std::ldexp(data[1] - 128.0, data[2] % 32 - 16);
        offset_by.corner = csg::Offset::Corner::Chamfer;
        check(offset(outline, offset_by), extruded);
    } catch (const OutlineError&) {
        // Beyond what can be worked with: an answer, too.
    }
    return 0;
}
