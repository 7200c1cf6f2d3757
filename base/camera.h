// Cameras in OpenSCAD's two notations, and views: a camera, a picture's size and the bounds of what is seen.
#pragma once

#include <glm/glm.hpp>

namespace base {

enum class Projection { Perspective, Orthographic };

/// OpenSCAD's camera ($vpt, $vpr, $vpd, $vpf): looks at `target` from `distance` away, turned by `rotation`.
struct Camera {
    glm::dvec3 target{0.0};                ///< World coordinates; $vpt.
    glm::dvec3 rotation{55.0, 0.0, 25.0};  ///< Degrees about x, y, z; $vpr. (0, 0, 0) looks down -z, +y is up.
    double distance = 140.0;               ///< From eye to target; $vpd.
    double fov = 22.5;                     ///< Vertical field of view in degrees; $vpf.
    Projection projection = Projection::Perspective;

    bool operator==(const Camera&) const = default;

    /// World to eye coordinates: the eye at the origin, looking down -z, +y up. A rigid motion.
    [[nodiscard]] glm::dmat4 eye_from_world() const;
    [[nodiscard]] glm::dvec3 eye() const;  ///< World coordinates.
};

/// The camera of `--camera eyex,eyey,eyez,centerx,centery,centerz`: +z is up in the picture.
[[nodiscard]] Camera camera_between(const glm::dvec3& eye, const glm::dvec3& center);

/// Moves `camera` so far away that the sphere about the box fits (OpenSCAD's --viewall); with `autocenter` it looks at
/// the center of the box as well. An empty box (lo > hi) gives the default distance.
void view_all(Camera& camera, const glm::dvec3& lo, const glm::dvec3& hi, bool autocenter);

/// The same, as near as leaves a margin at each side of a picture of that shape (width / height): that share of its
/// width and height. `center`: it looks where both sides are as far away; else its target stays. Of the box's corners.
void view_tight(Camera& camera, const glm::dvec3& lo, const glm::dvec3& hi, double aspect, double margin, bool center);

/// A camera's picture of a bounded scene.
///
/// Depth is reversed: 1 at the near plane; perspective `near / distance` (the far plane is at infinity), orthographic
/// linear and above 0 at the far plane. Pixels are counted from the lower left corner; the sample of pixel (x, y) is at
/// (x + 0.5, y + 0.5) + jitter.
class View {
  public:
    /// `lo`, `hi`: the box that encloses everything (world coordinates). `jitter`: offset of the sample from the
    /// pixel's center, in pixels.
    View(const Camera& camera, glm::ivec2 size, const glm::dvec3& lo, const glm::dvec3& hi,
         glm::dvec2 jitter = glm::dvec2(0.0));

    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] const Camera& camera() const { return camera_; }
    /// Offset of the sample from the pixel's center, in pixels.
    [[nodiscard]] glm::dvec2 jitter() const { return jitter_; }
    [[nodiscard]] bool orthographic() const { return camera_.projection == Projection::Orthographic; }
    /// Distances from the eye's plane, along the axis of view.
    [[nodiscard]] double near_distance() const { return near_; }
    [[nodiscard]] double far_distance() const { return far_; }
    [[nodiscard]] const glm::dmat4& eye_from_world() const { return eye_from_world_; }
    /// World to clip coordinates (OpenGL, depth zero to one reversed), jitter included.
    [[nodiscard]] glm::dmat4 clip_from_world() const;
    /// Half the height of the picture: the tangent of half the field of view (perspective), or world units
    /// (orthographic).
    [[nodiscard]] double half_height() const { return half_height_; }

    /// The ray through the sample of pixel (x, y): points origin + t * direction, where t is the distance from the
    /// eye's plane along the axis of view (orthographic: from the near plane's position, t = near_distance() there).
    struct Ray {
        glm::dvec3 origin;
        glm::dvec3 direction;
    };
    [[nodiscard]] Ray ray(double x, double y) const;

    /// Depth of the plane dot(normal, p) = offset (world coordinates) as an affine function of the pixel:
    /// depth = a * (x - width / 2) + b * (y - height / 2) + c, with (x, y) as in gl_FragCoord; jitter included.
    /// A plane seen edge-on has no such function: `edge_on` is set.
    struct PlaneDepth {
        float a = 0, b = 0, c = 0;
        bool edge_on = false;
    };
    [[nodiscard]] PlaneDepth plane_depth(const glm::dvec3& normal, double offset) const;
    /// The same before it is rounded.
    struct ExactPlaneDepth {
        double a = 0, b = 0, c = 0;
        bool edge_on = false;
    };
    [[nodiscard]] ExactPlaneDepth exact_plane_depth(const glm::dvec3& normal, double offset) const;

    /// Depth to distance from the eye's plane along the axis of view, and back.
    [[nodiscard]] double distance(double depth) const;
    [[nodiscard]] double depth(double distance) const;

    /// Screen rectangle (pixels, lower left inclusive to upper right exclusive, clamped to the picture) that holds the
    /// projection of a box; {0, 0, 0, 0} where it is not in the picture. One pixel of margin is included.
    struct Rectangle {
        int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
        [[nodiscard]] bool empty() const { return x0 >= x1 || y0 >= y1; }
    };
    [[nodiscard]] Rectangle screen_box(const glm::dvec3& lo, const glm::dvec3& hi) const;

  private:
    Camera camera_;
    glm::ivec2 size_;
    glm::dvec2 jitter_;
    glm::dmat4 eye_from_world_;
    double near_ = 0, far_ = 0, half_height_ = 0;
};

}  // namespace base
