#include "ui/pipeline/inspection/layer_measures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/camera.h"
#include "base/stop.h"
#include "goldfeather/lists_cpu/lists_cpu.h"
#include "ui/pipeline/inspection/moments.h"

namespace ui {

namespace {

constexpr int kFirstSide = 256, kMostSide = 2048, kRows = 64;

/// Of one ray and one part: how long it runs inside, and what area of faces it stands for.
struct Passage {
    std::size_t part;
    double length = 0, area = 0;
};
using Passages = std::vector<Passage>;  ///< By part.

Passage& of(Passages& passages, std::size_t part) {
    const auto at = std::lower_bound(passages.begin(), passages.end(), part,
                                     [](const Passage& p, std::size_t id) { return p.part < id; });
    return at != passages.end() && at->part == part ? *at : *passages.insert(at, {part});
}

/// The axis that the faces of a plane are counted along: the one that it is across the most.
int axis_of(const glm::dvec3& normal) {
    const glm::dvec3 n = glm::abs(normal);
    const double most = std::max({n.x, n.y, n.z}) - 1e-9;
    return n.x >= most ? 0 : n.y >= most ? 1 : 2;
}

/// What rays along one axis tell, by part; the last is all of them together.
class AxisMeasures {
  public:
    AxisMeasures(const Model& model, const csg::Box& box, int axis)
        : sums(model.scene.parts.size() + 1),
          model_(model),
          box_(box),
          axis_(axis),
          inside_(sums.size(), 0),
          entered_(sums.size(), 0) {}

    /// `spacing`: of the rays.
    void look(const goldfeather::ListsModel& lists, double spacing, const std::stop_token& stop) {
        static constexpr std::array<glm::dvec3, 3> kRotations{glm::dvec3(90, 0, 90), glm::dvec3(90, 0, 0),
                                                              glm::dvec3(0, 0, 0)};
        base::Camera camera;
        camera.projection = base::Projection::Orthographic;
        camera.rotation = kRotations[static_cast<std::size_t>(axis_)];
        camera.distance = 0.5 * kRows * spacing / std::tan(glm::radians(0.5 * camera.fov));
        const glm::dmat3 to_world = glm::transpose(glm::dmat3(camera.eye_from_world()));
        const glm::dvec3 right = to_world[0], up = to_world[1], size = box_.size();
        const int columns = 1 + static_cast<int>(std::ceil(glm::dot(glm::abs(right), size) / spacing - 1e-9));
        const int rows = 1 + static_cast<int>(std::ceil(glm::dot(glm::abs(up), size) / spacing - 1e-9));
        spacing_ = spacing;
        below_.assign(static_cast<std::size_t>(columns), {});
        for (int row = 0; row < rows; row += kRows) {
            base::end_if_asked(stop);
            // Rays lie in the middle of squares that the box is cut into from its lower left corner.
            const double lift = (row + 0.5 * kRows) * spacing - 0.5 * glm::dot(glm::abs(up), size);
            const double aside = 0.5 * columns * spacing - 0.5 * glm::dot(glm::abs(right), size);
            camera.target = box_.center() + lift * up + aside * right;
            const base::View view(camera, {columns, kRows}, model_.geometry.box.lo, model_.geometry.box.hi);
            goldfeather::ListsStats ignored;
            peel_lists(lists, view, 0, 0, stack_, ignored, stop);
            for (int y = 0; y < kRows; ++y) {
                look_at_row(view, y);
            }
        }
    }

    std::vector<MomentSums> sums;

  private:
    void look_at_row(const base::View& view, int y) {
        Passages left;
        for (int x = 0; x < stack_.size.x; ++x) {
            Passages here = passages(view, x, y);
            Passages& before = below_[static_cast<std::size_t>(x)];
            differ(here, left);
            differ(here, before);
            left = here;
            before = std::move(here);
        }
        differ(left, {});
    }

    /// Half of what two neighbors differ by may lie between them.
    void differ(const Passages& a, const Passages& b) {
        const double half = 0.5 * spacing_ * spacing_;
        auto i = a.begin(), j = b.begin();
        while (i != a.end() || j != b.end()) {
            const bool first = j == b.end() || (i != a.end() && i->part <= j->part);
            const bool second = i == a.end() || (j != b.end() && j->part <= i->part);
            const Passage none{first ? i->part : j->part};
            const Passage &p = first ? *i : none, &q = second ? *j : none;
            sums[none.part].volume_error += half * std::abs(p.length - q.length);
            sums[none.part].area_error += half * std::abs(p.area - q.area);
            i += first ? 1 : 0;
            j += second ? 1 : 0;
        }
    }

    Passages passages(const base::View& view, int x, int y) {
        Passages result;
        const base::View::Ray ray = view.ray(x, y);
        const auto count =
            static_cast<int>(stack_.counts[static_cast<std::size_t>(y) * static_cast<std::size_t>(stack_.size.x) +
                                           static_cast<std::size_t>(x)]);
        const std::size_t all = sums.size() - 1;
        int parts_inside = 0;
        for (int begin = 0, end = 0; begin < count; begin = end) {
            const float depth = stack_.at(begin, x, y).depth;
            const int before = parts_inside;
            for (; end < count && stack_.at(end, x, y).depth == depth; ++end) {
                const layers::Surface s = stack_.at(end, x, y);
                const csg::PartId part = model_.scene.leaves[s.leaf].part;
                if (!is_measured(part) || (inside_[part] != 0) != s.leaving) {
                    continue;
                }
                inside_[part] = s.leaving ? 0 : 1;
                parts_inside += s.leaving ? -1 : 1;
                pass(result, part, ray, s, view, s.leaving);
                touched_.push_back(part);
            }
            if ((before > 0) != (parts_inside > 0)) {
                pass(result, all, ray, stack_.at(begin, x, y), view, parts_inside == 0);
            }
        }
        for (const csg::PartId part : touched_) {
            inside_[part] = 0;  // Rays may end within an open mesh.
        }
        touched_.clear();
        return result;
    }

    [[nodiscard]] bool is_measured(csg::PartId part) const {
        const csg::PartKind kind = model_.scene.parts[part].kind;
        return kind == csg::PartKind::Solid || kind == csg::PartKind::Translucent;
    }

    void pass(Passages& result, std::size_t part, const base::View::Ray& ray, const layers::Surface& surface,
              const base::View& view, bool leaving) {
        const csg::solid::Plane& plane = model_.geometry.planes.planes()[surface.plane];
        const double slope = glm::dot(plane.normal, ray.direction), seen = view.distance(surface.depth);
        const double exact = slope == 0 ? seen : (plane.offset - glm::dot(plane.normal, ray.origin)) / slope;
        const double at = std::abs(exact - seen) <= 1e-5 * (std::abs(seen) + spacing_) ? exact : seen;
        Passage& passage = of(result, part);
        MomentSums& sum = sums[part];
        const double square = spacing_ * spacing_;
        sum.box = csg::enclose(sum.box, ray.origin + at * ray.direction);
        if (axis_of(plane.normal) == axis_) {
            sum.area += square / std::abs(slope);
            passage.area += 1 / std::abs(slope);
        }
        if (!leaving) {
            entered_[part] = at;
            return;
        }
        passage.length += at - entered_[part];
        sum.add_segment(ray.origin - box_.center() + entered_[part] * ray.direction, ray.direction, at - entered_[part],
                        spacing_);
    }

    const Model& model_;
    const csg::Box& box_;
    int axis_;
    double spacing_ = 0;
    layers::HostStack stack_;
    std::vector<Passages> below_;
    std::vector<char> inside_;
    std::vector<double> entered_;
    std::vector<csg::PartId> touched_;
};

/// Volumes and moments along the axis where the least may lie between the rays; areas from all.
SolidMeasures together(const std::array<MomentSums, 3>& axes, const glm::dvec3& center) {
    SolidMeasures result;
    const MomentSums& best = *std::min_element(axes.begin(), axes.end(), [](const MomentSums& a, const MomentSums& b) {
        return a.volume_error < b.volume_error;
    });
    for (const MomentSums& sums : axes) {
        result.area.value += sums.area;
        result.area.error += sums.area_error;
        result.box = csg::enclose(result.box, sums.box);
    }
    result.volume = {best.volume, best.volume_error};
    if (!(best.volume > 0)) {
        return result;
    }
    const glm::dvec3 centroid = best.first / best.volume;
    result.centroid = center + centroid;
    const double radius = 0.5 * result.box.diagonal();
    result.centroid_error = radius * best.volume_error / best.volume;
    result.moments = principal_moments(best, centroid);
    result.moments_error = radius * radius * best.volume_error;
    return result;
}

}  // namespace

LayerMeasures measure_by_layers(const Model& model, double precision, const std::stop_token& stop) {
    LayerMeasures result;
    result.parts.resize(model.scene.parts.size());
    const csg::Box box = model.box;
    const glm::dvec3 size = box.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (box.empty() || !(longest > 0)) {
        return result;
    }
    const goldfeather::ListsModel lists(model.scene, model.geometry);
    for (int side = kFirstSide; side <= kMostSide; side *= 2) {
        std::array axes{AxisMeasures(model, box, 0), AxisMeasures(model, box, 1), AxisMeasures(model, box, 2)};
        for (AxisMeasures& axis : axes) {
            axis.look(lists, longest / side, stop);
        }
        const auto of_part = [&](std::size_t part) {
            return together({axes[0].sums[part], axes[1].sums[part], axes[2].sums[part]}, box.center());
        };
        for (std::size_t part = 0; part < result.parts.size(); ++part) {
            result.parts[part] = of_part(part);
        }
        result.all = of_part(result.parts.size());
        result.spacing = longest / side;
        const auto good = [&](const BoundedValue& m) { return m.error <= precision * m.value; };
        if (good(result.all.volume) && good(result.all.area)) {
            break;
        }
    }
    return result;
}

}  // namespace ui
