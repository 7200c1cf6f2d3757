#include "base/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace base {
namespace {

double radians(double degrees) {
    return degrees * glm::pi<double>() / 180.0;
}

/// Rotation about an axis with exact values at multiples of 90 degrees, so that axis-parallel views are just that.
glm::dmat4 turn_about(double degrees, int axis) {
    const double turned = std::remainder(degrees, 360.0);
    double s = std::sin(radians(turned)), c = std::cos(radians(turned));
    if (std::fmod(turned, 90.0) == 0.0) {
        s = std::round(s);
        c = std::round(c);
    }
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::dmat4 m(1.0);
    m[u][u] = c;
    m[u][v] = s;
    m[v][u] = -s;
    m[v][v] = c;
    return m;
}

/// The eight corners of a box in eye coordinates, one after the other.
template <typename Visit>
void for_each_corner(const glm::dmat4& eye_from_world, const glm::dvec3& lo, const glm::dvec3& hi, Visit&& visit) {
    for (int i = 0; i < 8; ++i) {
        visit(glm::dvec3(eye_from_world *
                         glm::dvec4(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z, 1.0)));
    }
}

}  // namespace

glm::dmat4 Camera::eye_from_world() const {
    const glm::dmat4 turn = turn_about(-rotation.x, 0) * turn_about(-rotation.y, 1) * turn_about(-rotation.z, 2);
    return glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -distance)) * turn *
           glm::translate(glm::dmat4(1.0), -target);
}

glm::dvec3 Camera::eye() const {
    return glm::dvec3(glm::inverse(eye_from_world()) * glm::dvec4(0, 0, 0, 1));
}

Camera camera_between(const glm::dvec3& eye, const glm::dvec3& center) {
    Camera camera;
    const glm::dvec3 d = eye - center;
    const double flat = std::hypot(d.x, d.y);
    camera.target = center;
    camera.distance = glm::length(d);
    const double degrees = 180.0 / glm::pi<double>();
    camera.rotation = {std::atan2(flat, d.z) * degrees, 0.0, flat > 0 ? std::atan2(d.x, -d.y) * degrees : 0.0};
    return camera;
}

void view_all(Camera& camera, const glm::dvec3& lo, const glm::dvec3& hi, bool autocenter) {
    if (!(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z)) {
        camera.distance = Camera{}.distance;
        return;
    }
    const glm::dvec3 center = 0.5 * (lo + hi);
    if (autocenter) {
        camera.target = center;
    }
    const double radius = glm::length(hi - lo) / 2 + glm::length(center - camera.target);
    camera.distance = radius > 0 ? radius / std::sin(radians(camera.fov / 2)) : Camera{}.distance;
}

void view_tight(Camera& camera, const glm::dvec3& lo, const glm::dvec3& hi, double aspect, double margin, bool center) {
    if (!(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z)) {
        camera.distance = Camera{}.distance;
        return;
    }
    if (center) {
        camera.target = 0.5 * (lo + hi);
    }
    camera.distance = 0;
    const glm::dmat4 turned = camera.eye_from_world();
    const double tangent = std::tan(radians(camera.fov / 2)) * (1 - 2 * margin);
    const glm::dvec2 slope(tangent * aspect, tangent);
    const bool flat = camera.projection == Projection::Orthographic;
    // A corner is in the picture where |x - x of the axis| <= slope * (distance - z), without z in an orthographic one.
    glm::dvec2 right(-std::numeric_limits<double>::infinity()), left(right);
    for_each_corner(turned, lo, hi, [&](const glm::dvec3& p) {
        const glm::dvec2 depth = slope * (flat ? 0.0 : p.z);
        right = glm::max(right, glm::dvec2(p) + depth);
        left = glm::max(left, depth - glm::dvec2(p));
    });
    const glm::dvec2 axis = center ? 0.5 * (right - left) : glm::dvec2(0);
    const glm::dvec2 reach = glm::max(right - axis, left + axis) / slope;
    camera.distance = std::max(reach.x, reach.y);
    if (!(camera.distance > 0)) {
        camera.distance = Camera{}.distance;
    }
    camera.target += glm::transpose(glm::dmat3(turned)) * glm::dvec3(axis, 0);
}

View::View(const Camera& camera, glm::ivec2 size, const glm::dvec3& lo, const glm::dvec3& hi, glm::dvec2 jitter)
    : camera_(camera), size_(size), jitter_(jitter), eye_from_world_(camera.eye_from_world()) {
    const double tangent = std::tan(radians(camera.fov / 2));
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for_each_corner(eye_from_world_, lo, hi, [&](const glm::dvec3& p) {
        nearest = std::min(nearest, -p.z);
        farthest = std::max(farthest, -p.z);
    });
    if (!(nearest <= farthest)) {
        nearest = 0.5 * camera.distance;
        farthest = 2 * camera.distance;
    }
    const double extent = std::max(glm::length(hi - lo), 1e-30);
    if (orthographic()) {
        half_height_ = camera.distance * tangent;
        // A margin on both sides keeps every surface strictly inside, where parity is counted.
        const double margin = 1e-3 * std::max(farthest - nearest, 1e-6 * extent) + 1e-12 * std::abs(farthest);
        near_ = nearest - margin;
        far_ = farthest + margin;
    } else {
        half_height_ = tangent;
        // Reversed depth keeps its relative precision however close the near plane is; it matters only for an eye
        // among the solids, whose surfaces are cut there: never as far away as what it looks at.
        const double close = 1e-6 * std::max(extent, farthest);
        near_ = std::max(0.999 * nearest, camera.distance > 0 ? std::min(close, 1e-3 * camera.distance) : close);
        far_ = std::numeric_limits<double>::infinity();
    }
}

glm::dmat4 View::clip_from_world() const {
    const double aspect = static_cast<double>(size_.x) / size_.y;
    glm::dmat4 clip(0.0);
    const double sx = 1 / (half_height_ * aspect), sy = 1 / half_height_;
    const double jx = -2 * jitter_.x / size_.x, jy = -2 * jitter_.y / size_.y;
    clip[0][0] = sx;
    clip[1][1] = sy;
    if (orthographic()) {
        clip[2][2] = 1 / (far_ - near_);
        clip[3] = {jx, jy, far_ / (far_ - near_), 1.0};
    } else {
        clip[2] = {-jx, -jy, 0.0, -1.0};
        clip[3] = {0.0, 0.0, near_, 0.0};
    }
    return clip * eye_from_world_;
}

View::Ray View::ray(double x, double y) const {
    const double scale = 2 * half_height_ / size_.y;
    const double ex = (x + 0.5 + jitter_.x - 0.5 * size_.x) * scale;
    const double ey = (y + 0.5 + jitter_.y - 0.5 * size_.y) * scale;
    const glm::dmat4 world_from_eye = glm::inverse(eye_from_world_);
    if (orthographic()) {
        return {glm::dvec3(world_from_eye * glm::dvec4(ex, ey, 0, 1)),
                glm::dvec3(world_from_eye * glm::dvec4(0, 0, -1, 0))};
    }
    return {glm::dvec3(world_from_eye * glm::dvec4(0, 0, 0, 1)),
            glm::dvec3(world_from_eye * glm::dvec4(ex, ey, -1, 0))};
}

View::PlaneDepth View::plane_depth(const glm::dvec3& normal, double offset) const {
    const ExactPlaneDepth exact = exact_plane_depth(normal, offset);
    return {static_cast<float>(exact.a), static_cast<float>(exact.b), static_cast<float>(exact.c), exact.edge_on};
}

View::ExactPlaneDepth View::exact_plane_depth(const glm::dvec3& normal, double offset) const {
    const glm::dvec3 n = glm::dmat3(eye_from_world_) * normal;
    const double w = offset + glm::dot(n, glm::dvec3(eye_from_world_[3]));  // dot(n, p_eye) = w
    const double scale = 2 * half_height_ / size_.y;
    double a, b, c;
    if (orthographic()) {
        // n.x X + n.y Y - n.z z = w with z the distance; depth = (far - z) / (far - near)
        const double k = 1 / (far_ - near_);
        a = -k * n.x * scale / n.z;
        b = -k * n.y * scale / n.z;
        c = k * (far_ + w / n.z);
    } else {
        // A point at distance t on the pixel's ray is t (X, Y, -1): 1 / t is affine in X and Y.
        const double k = near_ / w;
        a = k * n.x * scale;
        b = k * n.y * scale;
        c = -k * n.z;
    }
    c += a * jitter_.x + b * jitter_.y;
    constexpr double kSteepest = 1e6;  // depth range per pixel; beyond it the plane is edge-on for any picture
    if (!(std::abs(a) < kSteepest && std::abs(b) < kSteepest && std::abs(c) < 1e6 * kSteepest)) {
        return {0, 0, 0, true};
    }
    return {a, b, c, false};
}

double View::distance(double depth) const {
    return orthographic() ? far_ - depth * (far_ - near_) : near_ / depth;
}

double View::depth(double distance) const {
    return orthographic() ? (far_ - distance) / (far_ - near_) : near_ / distance;
}

View::Rectangle View::screen_box(const glm::dvec3& lo, const glm::dvec3& hi) const {
    glm::dvec2 min(std::numeric_limits<double>::infinity()), max(-min);
    bool behind = false;
    const double scale = size_.y / (2 * half_height_);
    for_each_corner(eye_from_world_, lo, hi, [&](const glm::dvec3& p) {
        if (!orthographic() && -p.z < near_) {
            behind = true;
            return;
        }
        const glm::dvec2 at = glm::dvec2(p) * (scale / (orthographic() ? 1.0 : -p.z));
        min = glm::min(min, at);
        max = glm::max(max, at);
    });
    if (behind && !(min.x <= max.x)) {
        return {};  // wholly behind the near plane
    }
    if (behind) {
        return {0, 0, size_.x, size_.y};
    }
    const glm::dvec2 half = 0.5 * glm::dvec2(size_);
    const auto low = glm::clamp(glm::floor(min + half - jitter_) - 1.0, glm::dvec2(0.0), glm::dvec2(size_));
    const auto high = glm::clamp(glm::ceil(max + half - jitter_) + 1.0, glm::dvec2(0.0), glm::dvec2(size_));
    const Rectangle r{static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x),
                      static_cast<int>(high.y)};
    return r.empty() ? Rectangle{} : r;
}

}  // namespace base
