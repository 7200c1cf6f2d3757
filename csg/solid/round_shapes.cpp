// The shapes below a leaf that are round, where the matrices above them keep them so.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <fmt/format.h>

#include "csg/solid/surface_form.h"
#include "csg/tree/degrees.h"

namespace csg::solid {
namespace {

constexpr double kEqual = 1e-9;  ///< Of lengths and cosines: what matrices of rotations differ by is far below.

bool equal(double a, double b) {
    return std::abs(a - b) <= kEqual * std::max(std::abs(a), std::abs(b));
}

bool upright(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(glm::dot(a, b)) <= kEqual * glm::length(a) * glm::length(b);
}

glm::dvec3 times(const glm::dmat4& m, const glm::dvec3& p) {
    return glm::dvec3(m * glm::dvec4(p, 1));
}

/// What a matrix does to the plane across an axis and to the axis.
struct Placement {
    explicit Placement(const glm::dmat4& m) : x(m[0]), y(m[1]), z(m[2]) {}
    [[nodiscard]] bool keeps_circles() const { return equal(glm::length(x), glm::length(y)) && upright(x, y); }
    [[nodiscard]] bool keeps_axis() const { return upright(z, x) && upright(z, y); }
    [[nodiscard]] bool keeps_spheres() const {
        return keeps_circles() && keeps_axis() && equal(glm::length(x), glm::length(z));
    }
    /// The half-axes of the ellipse that the unit circle becomes.
    [[nodiscard]] glm::dvec2 ellipse() const {
        const double xx = glm::dot(x, x), yy = glm::dot(y, y), xy = glm::dot(x, y);
        const double middle = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
        return {std::sqrt(middle + half), std::sqrt(std::max(middle - half, 0.0))};
    }
    glm::dvec3 x, y, z;
};

std::string uneven_circle(const Placement& placed, double radius) {
    if (!placed.keeps_circles()) {
        const glm::dvec2 axes = placed.ellipse() * radius;
        return fmt::format("scaled unevenly: an ellipse of the half-axes {:.6g} and {:.6g} has no radius", axes.x,
                           axes.y);
    }
    return "sheared: it is not round about its axis";
}

/// A mantle about z from z1 to z2, as a matrix places it.
struct Mantle {
    double radius1 = 0, radius2 = 0, z1 = 0, z2 = 0;
    int segments = 0;
};

class Collector {
  public:
    Collector(const Tree& tree, std::string& uneven) : tree_(tree), uneven_(uneven) {}

    /// All below `node`, whose coordinates `to_world` moves.
    void collect(NodeId node, const glm::dmat4& to_world) {
        stack_ = {{node, to_world}};
        while (!stack_.empty() && shapes_.size() < kMost) {
            const auto [id, matrix] = stack_.back();
            stack_.pop_back();
            look(id, matrix);
        }
    }
    [[nodiscard]] std::vector<RoundShape> take() { return std::move(shapes_); }

  private:
    static constexpr std::size_t kMost = 4096;

    void look(NodeId id, const glm::dmat4& matrix) {
        switch (tree_.node(id).operation) {
            case Operation::Leaf:
                return look(tree_.shape(id), matrix);
            case Operation::Transform:
                return below(id, matrix * tree_.matrix(id));
            case Operation::Mesh:
                return look(tree_.mesh(id), id, matrix);
            default:
                return below(id, matrix);
        }
    }
    void below(NodeId id, const glm::dmat4& matrix) {
        const auto children = tree_.children(id);
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            stack_.emplace_back(*child, matrix);
        }
    }
    void look(const LeafShape& shape, const glm::dmat4& matrix) {
        if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
            const double z1 = cylinder->center ? -cylinder->height / 2 : 0;
            add({cylinder->radius1, cylinder->radius2, z1, z1 + cylinder->height,
                 circle_segments(std::max(cylinder->radius1, cylinder->radius2), cylinder->fineness)},
                matrix);
        } else if (const auto* sphere = std::get_if<Sphere>(&shape)) {
            add_sphere(sphere->radius, circle_segments(sphere->radius, sphere->fineness), matrix);
        } else if (const auto* circle = std::get_if<Circle>(&shape)) {
            add_circle(circle->radius, circle_segments(circle->radius, circle->fineness), matrix);
        }
    }
    void look(const MeshOperation& mesh, NodeId id, const glm::dmat4& matrix) {
        if (const auto* extruded = std::get_if<LinearExtrude>(&mesh)) {
            sweep(id, matrix, extruded, nullptr);
        } else if (const auto* turned = std::get_if<RotateExtrude>(&mesh)) {
            sweep(id, matrix, nullptr, turned);
        } else if (std::holds_alternative<Hull>(mesh) || std::holds_alternative<Fill>(mesh) ||
                   std::holds_alternative<Render>(mesh)) {
            below(id, matrix);
        }
    }
    /// The circles below an extrusion.
    void sweep(NodeId id, const glm::dmat4& matrix, const LinearExtrude* extruded, const RotateExtrude* turned) {
        Collector circles(tree_, uneven_);
        circles.extruded_ = extruded;
        circles.turned_ = turned;
        circles.sweep_ = matrix;
        for (const NodeId child : tree_.children(id)) {
            circles.collect(child, glm::dmat4(1.0));
        }
        std::move(circles.shapes_.begin(), circles.shapes_.end(), std::back_inserter(shapes_));
    }

    void add(const Mantle& mantle, const glm::dmat4& matrix) {
        const Placement placed(matrix);
        const double most = std::max(mantle.radius1, mantle.radius2);
        if (!placed.keeps_circles() || !placed.keeps_axis()) {
            uneven_ = uneven_circle(placed, most);
            return;
        }
        const double scale = glm::length(placed.x), slope = mantle.radius2 - mantle.radius1;
        RoundShape shape;
        SurfaceForm& form = shape.form;
        form.segments = mantle.segments;
        form.direction = glm::normalize(placed.z);
        shape.step = 2 * most * scale * std::sin(std::numbers::pi / mantle.segments);
        if (slope == 0) {
            form.kind = FormKind::Cylinder;
            form.radius = most * scale;
            form.point = times(matrix, {0, 0, (mantle.z1 + mantle.z2) / 2});
        } else {
            const double height = mantle.z2 - mantle.z1;
            form.kind = FormKind::Cone;
            form.half_angle = std::atan2(std::abs(slope) * scale, height * glm::length(placed.z));
            form.point = times(matrix, {0, 0, mantle.z1 - mantle.radius1 * height / slope});
            form.direction = slope > 0 ? form.direction : -form.direction;
        }
        shapes_.push_back(shape);
    }
    void add_sphere(double radius, int segments, const glm::dmat4& matrix) {
        const Placement placed(matrix);
        if (!placed.keeps_spheres()) {
            uneven_ = "scaled unevenly: an ellipsoid has no radius";
            return;
        }
        RoundShape shape;
        shape.form.kind = FormKind::Sphere;
        shape.form.radius = radius * glm::length(placed.x);
        shape.form.point = times(matrix, glm::dvec3(0));
        shape.form.direction = glm::normalize(placed.z);
        shape.form.segments = segments;
        shape.step =
            2 * std::numbers::sqrt2 * shape.form.radius * std::sin(std::numbers::pi / std::max(segments - 1, 3));
        shapes_.push_back(shape);
    }
    /// A disc: extruded, or by itself, which is drawn as a slab.
    void add_circle(double radius, int segments, const glm::dmat4& matrix) {
        if (turned_ != nullptr) {
            return add_ring(radius, segments, matrix);
        }
        if (extruded_ == nullptr) {
            return add({radius, radius, -0.5, 0.5, segments}, matrix);
        }
        const glm::dvec3 center = times(matrix, glm::dvec3(0));
        const bool central = glm::length(glm::dvec2(center)) <= kEqual * radius;
        const bool tapered = extruded_->scale != glm::dvec2(1.0), twisted = extruded_->twist.value_or(0) != 0;
        if (!upright(extruded_->direction, {1, 0, 0}) || !upright(extruded_->direction, {0, 1, 0})) {
            uneven_ = "extruded askew: it is not round about its axis";
        } else if (extruded_->scale.x != extruded_->scale.y) {
            uneven_ = "tapered unevenly: it has no radius";
        } else if ((tapered || twisted) && !central) {
            uneven_ = "extruded with a twist or a taper away from its middle: it has no axis";
        } else {
            const double z1 = extruded_->center ? -extruded_->height / 2 : 0;
            add({radius, radius * extruded_->scale.x, z1, z1 + extruded_->height, segments}, sweep_ * matrix);
        }
    }
    /// In the plane of rotate_extrude(), whose y is the axis.
    void add_ring(double radius, int segments, const glm::dmat4& matrix) {
        const Placement in_plane(matrix), placed(sweep_);
        if (!in_plane.keeps_circles() || !placed.keeps_spheres()) {
            uneven_ = "scaled unevenly: it has no radius";
            return;
        }
        const double scale = glm::length(placed.x);
        const glm::dvec3 center = times(matrix, glm::dvec3(0));
        RoundShape shape;
        SurfaceForm& form = shape.form;
        form.radius = radius * glm::length(in_plane.x) * scale;
        form.ring_radius = std::abs(center.x) * scale;
        form.kind = form.ring_radius <= kEqual * form.radius ? FormKind::Sphere : FormKind::Torus;
        form.point = times(sweep_, {0, 0, center.y});
        form.direction = glm::normalize(placed.z);
        form.segments = segments;
        // A facet is a chord of the tube by one of the ring, which may be as coarse as a triangle's side.
        shape.step = 2 * (form.ring_radius + form.radius);
        shapes_.push_back(shape);
    }

    const Tree& tree_;
    std::string& uneven_;
    std::vector<std::pair<NodeId, glm::dmat4>> stack_;
    std::vector<RoundShape> shapes_;
    const LinearExtrude* extruded_ = nullptr;  ///< Of what is collected, where that lies in the plane.
    const RotateExtrude* turned_ = nullptr;
    glm::dmat4 sweep_{1.0};
};

}  // namespace

std::vector<RoundShape> round_shapes(const Tree& tree, const LeafInstance& leaf, std::string& uneven) {
    Collector collector(tree, uneven);
    if (leaf.node != kNoNode) {  // Sections have none.
        collector.collect(leaf.node, leaf.to_world);
    }
    return collector.take();
}

}  // namespace csg::solid
