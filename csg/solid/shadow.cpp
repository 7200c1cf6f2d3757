// projection(): the shadow of solids on the plane z = 0.
#include <algorithm>
#include <cmath>

#include "csg/solid/node_geometry.h"
#include "csg/solid/plane_table.h"

namespace csg::solid {
namespace {

/// A triangle from above: clockwise where it looks down.
struct Seen {
    Loop loop;
    double area;  ///< Twice, signed.
    std::uint32_t plane = 0;
};

/// Those that are not seen from the side, with their planes.
std::vector<Seen> seen_from_above(const Mesh& mesh) {
    std::vector<std::pair<Seen, glm::uvec3>> all;
    double largest = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        Loop loop{glm::dvec2(mesh.points[t.x]), glm::dvec2(mesh.points[t.y]), glm::dvec2(mesh.points[t.z])};
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 most = glm::abs(mesh.points[t[k]]);
            largest = std::max({largest, most.x, most.y, most.z});
        }
        if (const double area = area2(loop); area != 0) {
            all.push_back({{std::move(loop), area}, t});
        }
    }
    // The widest first, whose planes are known best.
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return std::abs(a.first.area) > std::abs(b.first.area); });
    PlaneTable planes(coincidence_tolerance(largest));
    std::vector<Seen> result;
    for (auto& [seen, t] : all) {
        seen.plane = planes.add(mesh.points[t.x], mesh.points[t.y], mesh.points[t.z]).index;
        result.push_back(std::move(seen));
    }
    std::stable_sort(result.begin(), result.end(), [](const Seen& a, const Seen& b) { return a.plane < b.plane; });
    return result;
}

Outline shadow_of(const Mesh& mesh) {
    // Where a line passes a surface that looks up, the winding number differs by one above and below it: one of them is
    // inside. Surfaces in one plane that look up and down undo each other, as of two shells the one of which is turned.
    std::vector<Seen> triangles = seen_from_above(mesh);
    std::vector<Loop> up;
    std::vector<std::shared_ptr<const Outline>> outlines;
    for (auto first = triangles.begin(), last = first; first != triangles.end(); first = last) {
        last = std::find_if(first, triangles.end(), [&](const Seen& s) { return s.plane != first->plane; });
        const auto looks_up = [](const Seen& s) { return s.area > 0; };
        const auto ups = std::count_if(first, last, looks_up);
        if (ups == 0) {
            continue;
        }
        std::vector<Loop> both;
        for (auto t = first; t != last; ++t) {
            (ups == last - first ? up : both).push_back(std::move(t->loop));
        }
        if (!both.empty()) {
            outlines.push_back(std::make_shared<Outline>(clean(both, FillRule::NonZero)));
        }
    }
    outlines.push_back(std::make_shared<Outline>(clean(up, FillRule::NonZero)));
    return combine(BooleanKind::Union, outlines);
}

}  // namespace

Outline shadow(std::span<const Mesh> meshes) {
    std::vector<std::shared_ptr<const Outline>> outlines;
    for (const Mesh& mesh : meshes) {
        outlines.push_back(std::make_shared<Outline>(shadow_of(mesh)));
    }
    return combine(BooleanKind::Union, outlines);
}

}  // namespace csg::solid
