#include "tests/truth/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "csg/solid/part_order.h"

namespace truth {
namespace {

bool before(const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// On which side of the directed edge p→q the ray passes: computed in one direction of the edge for both.
bool left_of(const base::View::Ray& ray, const glm::dvec3& p, const glm::dvec3& q) {
    const bool forward = before(p, q);
    const glm::dvec3 from = (forward ? p : q) - ray.origin, to = (forward ? q : p) - ray.origin;
    return (glm::dot(ray.direction, glm::cross(from, to)) >= 0) == forward;
}

/// Where the ray goes through a triangle, and whether against its normal: into what it bounds.
struct Hit {
    double t;
    bool into;
};

std::optional<Hit> hit(const base::View::Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const bool ab = left_of(ray, a, b), bc = left_of(ray, b, c), ca = left_of(ray, c, a);
    if (ab != bc || bc != ca) {
        return {};
    }
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double slope = glm::dot(normal, ray.direction);
    if (slope == 0) {
        return {};
    }
    return Hit{glm::dot(normal, a - ray.origin) / slope, !ab};
}

/// A leaf that an event is due to.
struct Due {
    csg::LeafId leaf;
    bool complement;  ///< Subtracted.
    bool strongly;    ///< All nodes above it switch as well.
    auto operator<=>(const Due&) const = default;
};

/// S(node) = value(node) ? ∪ S(children) : ∅, complements pushed down to the leaves; of it the leaves that switch.
/// `value(expression)` is the value on the result's side of the event, `switches(expression)` whether it differs.
template <typename Value, typename Switches>
std::vector<Due> attribute(const csg::Scene& scene, const csg::Part& part, Value&& value, Switches&& switches) {
    struct Open {
        std::uint32_t node;
        bool complement, strongly;
    };
    std::vector<Due> due;
    std::vector<Open> open{{part.root, false, true}};
    while (!open.empty()) {
        const Open at = open.back();
        open.pop_back();
        if (value(at.node) == at.complement) {
            continue;
        }
        const csg::Expression& e = scene.expressions[at.node];
        const bool strongly = at.strongly && switches(at.node);
        if (e.kind == csg::ExpressionKind::Leaf && switches(at.node)) {
            due.push_back({e.leaf, at.complement, strongly});
        }
        const auto children = scene.children(e);
        for (std::size_t i = 0; i < children.size(); ++i) {
            open.push_back(
                {children[i], at.complement != (e.kind == csg::ExpressionKind::Difference && i > 0), strongly});
        }
    }
    std::sort(due.begin(), due.end());
    return due;
}

}  // namespace

RayCaster::RayCaster(const csg::Scene& scene, const csg::solid::Geometry& geometry, const base::View& view,
                     std::vector<char> part_enabled)
    : scene_(scene),
      geometry_(geometry),
      view_(view),
      band_(geometry, view),
      part_order_(csg::solid::part_order(scene, &geometry)),
      part_enabled_(std::move(part_enabled)) {
    part_enabled_.resize(scene.parts.size(), 1);
    for (csg::LeafId l = 0; l < geometry.leaves.size(); ++l) {
        const csg::solid::PlacedLeaf& leaf = geometry.leaves[l];
        for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
            Triangle triangle{leaf.points[leaf.triangles[t].x],
                              leaf.points[leaf.triangles[t].y],
                              leaf.points[leaf.triangles[t].z],
                              l,
                              leaf.planes[t].index,
                              {0, 0, view.size().x, view.size().y}};
            glm::dvec2 lo(std::numeric_limits<double>::infinity()), hi(-lo);
            bool cut = false;
            for (const glm::dvec3& p : {triangle.a, triangle.b, triangle.c}) {
                const glm::dvec3 eye = view.eye_from_world() * glm::dvec4(p, 1);
                cut |= !view.orthographic() && -eye.z < view.near_distance();
                const glm::dvec2 at = glm::dvec2(eye) * (view.size().y / (2 * view.half_height())) /
                                          (view.orthographic() ? 1.0 : -eye.z) +
                                      0.5 * glm::dvec2(view.size());
                lo = glm::min(lo, at);
                hi = glm::max(hi, at);
            }
            if (!cut) {
                const auto pixel = [](double v, int size) {
                    return static_cast<int>(std::clamp(v, 0.0, double(size)));
                };
                triangle.box = {pixel(lo.x - 1, view.size().x), pixel(lo.y - 1, view.size().y),
                                pixel(hi.x + 1, view.size().x), pixel(hi.y + 1, view.size().y)};
            }
            triangles_.push_back(triangle);
        }
    }
}

void RayCaster::find_crossings(int x, int y, std::vector<Crossing>& crossings) const {
    const base::View::Ray ray = view_.ray(x, y);
    for (const Triangle& t : triangles_) {
        if (x < t.box.x0 || x >= t.box.x1 || y < t.box.y0 || y >= t.box.y1) {
            continue;
        }
        if (const auto at = hit(ray, t.a, t.b, t.c)) {
            crossings.push_back({at->t, t.leaf, t.plane, at->into ? 1 : -1});
        }
    }
}

std::vector<RayCaster::Event> RayCaster::make_events(std::vector<Crossing> crossings, int x, int y,
                                                     bool& decided) const {
    // Crossings on one plane are one event, whatever the rounding of their distances. Different planes at one depth are
    // nearer than float depth can tell.
    std::map<std::uint32_t, double> plane_distance;
    for (Crossing& c : crossings) {
        c.t = plane_distance.try_emplace(c.plane, c.t).first->second;
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.t, a.plane, a.leaf) < std::tie(b.t, b.plane, b.leaf);
    });
    std::vector<Event> events;
    double lowest = std::numeric_limits<double>::infinity();  // depth falls along the ray
    for (const Crossing& c : crossings) {
        if (!events.empty() && events.back().crossings.back().plane == c.plane) {
            events.back().crossings.push_back(c);
            continue;
        }
        const double error = band_.depth_error(c.plane, x, y, c.t), depth = view_.depth(c.t);
        decided = decided && depth + error < lowest && depth + error < 1;
        lowest = std::min(lowest, depth - error);
        events.push_back({c.t, depth, error, {c}});
    }
    return events;
}

bool RayCaster::holds(csg::LeafId leaf, int winding) const {
    return geometry_.leaves[leaf].solid->closed ? winding != 0 : winding % 2 != 0;
}

void RayCaster::add_surfaces(csg::PartId id, std::span<const Event> events, std::vector<int> windings,
                             std::vector<std::vector<Surface>>& by_event) const {
    const csg::Part& part = scene_.parts[id];
    const auto evaluate = [&](std::vector<char>& values) {
        return csg::evaluate(
            scene_, part, [&](csg::LeafId leaf) { return holds(leaf, windings[leaf]); }, values);
    };
    std::vector<char> values_before, values_after;
    bool was = evaluate(values_before);
    for (std::size_t i = 0; i < events.size(); ++i) {
        Surface surface{events[i].distance, events[i].depth, events[i].error, {}, {}, {}, false};
        for (const Crossing& c : events[i].crossings) {
            windings[c.leaf] += c.winding;
            surface.planes.push_back(c.plane);
        }
        const bool is = evaluate(values_after);
        if (is != was) {
            const std::vector<char>& values = is ? values_after : values_before;
            for (const Due& due : attribute(
                     scene_, part, [&](std::uint32_t e) { return values[e - part.first_expression] != 0; },
                     [&](std::uint32_t e) {
                         return values_before[e - part.first_expression] != values_after[e - part.first_expression];
                     })) {
                surface.leaves.push_back(due.leaf);
                if (due.complement) {
                    surface.reversed.push_back(due.leaf);
                }
                if (due.strongly) {
                    break;
                }
            }
            surface.leaving = was;
            by_event[i].push_back(std::move(surface));
        }
        was = is;
        values_before.swap(values_after);
    }
}

Ray RayCaster::cast(int x, int y) const {
    Ray result;
    result.decided = !band_.near_edge(x, y);
    std::vector<Crossing> crossings;
    find_crossings(x, y, crossings);
    if (crossings.empty()) {
        return result;
    }
    std::erase_if(crossings, [&](const Crossing& c) { return part_enabled_[scene_.leaves[c.leaf].part] == 0; });
    result.hit = true;
    // Winding numbers at the near plane: what undoes that of the surfaces behind it. Open meshes count from the eye,
    // which sees them from outside.
    std::vector<int> windings(scene_.leaves.size(), 0);
    const double near = view_.near_distance();
    for (const Crossing& c : crossings) {
        if (c.t >= near && geometry_.leaves[c.leaf].solid->closed) {
            windings[c.leaf] -= c.winding;
        }
    }
    std::erase_if(crossings, [&](const Crossing& c) { return c.t < near && view_.depth(c.t) > 1.0001; });
    if (!view_.orthographic()) {
        std::erase_if(crossings, [](const Crossing& c) { return c.t <= 0; });
    }
    const std::vector<Event> events = make_events(std::move(crossings), x, y, result.decided);
    std::vector<std::vector<Surface>> by_event(events.size());
    for (const csg::PartId p : part_order_) {
        if (part_enabled_[p] != 0) {
            add_surfaces(p, events, windings, by_event);
        }
    }
    for (auto& surfaces : by_event) {
        std::move(surfaces.begin(), surfaces.end(), std::back_inserter(result.surfaces));
    }
    return result;
}

}  // namespace truth
