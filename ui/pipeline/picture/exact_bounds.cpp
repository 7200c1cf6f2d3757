#include "ui/pipeline/picture/exact_bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "base/stop.h"
#include "goldfeather/lists_cpu/lists_cpu.h"
#include "ui/pipeline/comparison/solid_scene.h"

namespace ui {

namespace {

/// Pixels along the longer side of the first picture, and of the others: odd, so that a sample lies in the middle.
constexpr int kFirstView = 513, kNextView = 33;
constexpr double kClose = 0x1p-20;  // Of the diagonal.
constexpr double kSteep = 128;      // Slopes beside a corner that are recognized.

/// A direction along an axis to look from, and what is right and up in that picture.
struct Side {
    glm::dvec3 rotation;  ///< Of the camera.
    int axis;
    double sign;  ///< 1: looked at from above, along the axis downwards.
    int right, up;
    double right_sign;
};
constexpr Side kViewSides[]{
    {{90, 0, 90}, 0, 1, 1, 2, 1}, {{90, 0, 270}, 0, -1, 1, 2, -1}, {{90, 0, 180}, 1, 1, 0, 2, -1},
    {{90, 0, 0}, 1, -1, 0, 2, 1}, {{0, 0, 0}, 2, 1, 0, 1, 1},      {{180, 0, 0}, 2, -1, 0, 1, 1},
};

/// A rectangle across the direction of view, in the coordinates of the picture (right, up).
struct Window {
    glm::dvec2 center, size;
};

struct Sighting {
    glm::dvec2 at;  ///< In the window's coordinates.
    double height;  ///< Along the direction that is looked from.
};

class Lookout {
  public:
    Lookout(const SolidScene& solid, const csg::Box& box, const std::stop_token& stop)
        : solid_(solid), lists_(solid.scene, solid.geometry), box_(box), stop_(stop) {}

    /// The largest sign * coordinate of the result along the side's axis.
    [[nodiscard]] std::optional<double> height(const Side& side) {
        const double up_sign = side.rotation.x == 180 ? -1 : 1;
        const glm::dvec3 size = box_.size(), center = box_.center();
        Window window{{side.right_sign * center[side.right], up_sign * center[side.up]},
                      {size[side.right], size[side.up]}};
        const double close = kClose * glm::length(size);
        const double highest = side.sign * (side.sign > 0 ? box_.hi : box_.lo)[side.axis];
        std::optional<double> best;
        for (int pixels = kFirstView;; pixels = kNextView) {
            const auto seen = look(side, up_sign, window, pixels);
            if (seen && (!best || seen->height > *best)) {
                best = seen->height;
                window.center = seen->at;
            }
            if (!best || *best > highest - close || pixel_ < close) {
                break;
            }
            window.size = glm::dvec2(4 * pixel_);  // Two pixels either way: the highest point about the sample.
        }
        return best ? std::optional(sharp_tip(side, up_sign, *best, close)) : std::nullopt;
    }

  private:
    /// The highest sample of a picture.
    [[nodiscard]] std::optional<Sighting> look(const Side& side, double up_sign, const Window& window, int pixels) {
        const double longer = std::max({window.size.x, window.size.y, 1e-300});
        pixel_ = longer / pixels;
        const glm::ivec2 count =
            glm::clamp(glm::ivec2(glm::ceil(window.size / pixel_)), glm::ivec2(1), glm::ivec2(pixels));
        base::Camera camera;
        camera.projection = base::Projection::Orthographic;
        camera.rotation = side.rotation;
        camera.target = box_.center();
        camera.target[side.right] = side.right_sign * window.center.x;
        camera.target[side.up] = up_sign * window.center.y;
        camera.distance = box_.diagonal();  // Before the box, however little of it is seen.
        camera.fov = std::atan(0.5 * count.y * pixel_ / camera.distance) * 360 / std::acos(-1.0);
        const base::View view(camera, count, box_.lo, box_.hi);
        layers::HostStack layers;
        goldfeather::ListsStats ignored;
        goldfeather::peel_lists(lists_, view, 1, 0, layers, ignored, stop_);

        // Reversed depth: the largest is the nearest. Ties go to the first pixel.
        const std::vector<float>& depth = layers.planes[0].depth;
        const auto nearest = std::max_element(depth.begin(), depth.end());
        if (!(*nearest > 0)) {
            return std::nullopt;
        }
        const auto index = static_cast<int>(nearest - depth.begin());
        const glm::dvec2 pixel(index % count.x, index / count.x);
        return Sighting{window.center + (pixel + 0.5 - 0.5 * glm::dvec2(count)) * pixel_,
                        side.sign * camera.eye()[side.axis] - view.distance(*nearest)};
    }

    /// Samples pass by tips that are sharp: the highest corner of a leaf above `height` that is on the result, or
    /// `height`, as exact as can be told.
    [[nodiscard]] double sharp_tip(const Side& side, double up_sign, double height, double close) {
        constexpr std::size_t kMostCorners = 32;
        std::vector<glm::dvec3> corners;  // Mirrored, so that the highest come first in the order of their coordinates.
        const double bound = side.sign * (side.sign > 0 ? box_.hi : box_.lo)[side.axis] + close;
        for (const csg::solid::PlacedLeaf& leaf : solid_.geometry.leaves) {
            base::end_if_asked(stop_);
            for (const glm::dvec3& point : leaf.points) {
                const double corner = side.sign * point[side.axis];
                if (corner > height + close && corner < bound) {
                    corners.emplace_back(-corner, side.right_sign * point[side.right], up_sign * point[side.up]);
                }
            }
        }
        const auto before = [](const glm::dvec3& a, const glm::dvec3& b) {
            return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        };
        std::sort(corners.begin(), corners.end(), before);
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        corners.resize(std::min(corners.size(), kMostCorners));
        constexpr int kSide = 9;
        for (const glm::dvec3& corner : corners) {
            const auto seen = look(side, up_sign, {{corner.y, corner.z}, glm::dvec2(4 * close)}, kSide);
            if (seen && seen->height > -corner.x - kSteep * close) {
                return -corner.x;
            }
        }
        return snapped(side, height, close);
    }

    /// The coordinate of the leaves' corner that is meant, where one is as near as can be told.
    [[nodiscard]] double snapped(const Side& side, double height, double close) const {
        double nearest = height, least = close;
        for (const csg::solid::PlacedLeaf& leaf : solid_.geometry.leaves) {
            base::end_if_asked(stop_);
            for (const glm::dvec3& point : leaf.points) {
                const double corner = side.sign * point[side.axis];
                if (std::abs(corner - height) < least) {
                    nearest = corner;
                    least = std::abs(corner - height);
                }
            }
        }
        return nearest;
    }

    const SolidScene& solid_;
    goldfeather::ListsModel lists_;
    csg::Box box_;
    const std::stop_token& stop_;
    double pixel_ = 0;  ///< Side of a pixel in the last picture, world units.
};

}  // namespace

csg::Box exact_bounds(const Model& model, const std::stop_token& stop) {
    const SolidScene solid = solid_scene(model.scene, model.geometry);
    csg::Box box;
    for (const csg::Part& part : solid.scene.parts) {
        std::vector<csg::Box> leaves;
        for (const auto& leaf : solid.geometry.leaves) {
            leaves.push_back(leaf.box);
        }
        box = csg::bounds(solid.scene, part, leaves);
    }
    if (box.empty()) {
        return {};
    }
    if (model.flat) {
        box.lo.z = box.hi.z = 0;  // Outlines have no thickness of their own.
        return box;
    }
    Lookout lookout(solid, box, stop);
    csg::Box exact = box;
    const glm::dvec3 size = box.size();
    for (const Side& side : kViewSides) {
        // An open polyhedron that lies in a plane shows itself to two sides; the leaves' box is its own.
        if (size[(side.axis + 1) % 3] == 0 || size[(side.axis + 2) % 3] == 0) {
            continue;
        }
        const auto height = lookout.height(side);
        if (!height) {
            return {};
        }
        (side.sign > 0 ? exact.hi : exact.lo)[side.axis] = side.sign * *height;
    }
    return exact;
}

}  // namespace ui
