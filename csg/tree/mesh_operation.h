// Operations that make one mesh or outline of their children, with their parameters as the language gives them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>

#include "csg/tree/leaf_shape.h"

namespace csg {

/// Sweeps outlines along a direction.
struct LinearExtrude {
    double height = 100;  ///< Along `direction`; nothing where it is not positive.
    glm::dvec3 direction{0, 0, 1};
    bool has_direction = false;   ///< For the .csg text.
    bool center = false;          ///< About z = 0.
    std::optional<double> twist;  ///< Degrees; the top is turned clockwise seen from above.
    std::optional<unsigned> slices, segments;
    glm::dvec2 scale{1.0};  ///< Of the top.
    unsigned convexity = 1;
    Fineness fineness;
    bool operator==(const LinearExtrude&) const = default;
};

/// Turns outlines about the z axis: their y becomes z.
struct RotateExtrude {
    double angle = 360;  ///< Degrees, at most a turn either way.
    double start = 180;
    unsigned convexity = 2;
    Fineness fineness;
    bool operator==(const RotateExtrude&) const = default;
};

/// Moves outlines outwards, or inwards where the distance is negative.
struct Offset {
    enum class Corner : std::uint8_t { Round, Miter, Chamfer };
    Corner corner = Corner::Round;
    double distance = 1;
    Fineness fineness;
    bool operator==(const Offset&) const = default;
};

/// Outlines without their holes.
struct Fill {
    bool operator==(const Fill&) const = default;
};

/// The shadow of solids on the plane z = 0, or their cut by it.
struct Projection {
    bool cut = false;
    int convexity = 0;
    bool operator==(const Projection&) const = default;
};

struct Hull {
    bool operator==(const Hull&) const = default;
};

struct Minkowski {
    int convexity = 0;
    bool operator==(const Minkowski&) const = default;
};

/// Scales to given dimensions; a dimension of 0 stays, or follows the others where `automatic`.
struct Resize {
    glm::dvec3 size{0.0};
    std::array<bool, 3> automatic{};
    int convexity = 0;
    bool operator==(const Resize&) const = default;
};

/// render(): for pictures no more than a group.
struct Render {
    int convexity = 1;
    bool operator==(const Render&) const = default;
};

/// A roof over outlines, rising at 45 degrees from their edges.
struct Roof {
    std::string method = "voronoi";  ///< Or "straight".
    unsigned convexity = 1;
    Fineness fineness;
    bool operator==(const Roof&) const = default;
};

using MeshOperation =
    std::variant<LinearExtrude, RotateExtrude, Offset, Fill, Projection, Hull, Minkowski, Resize, Render, Roof>;

/// A hash of kind and parameters; equal operations have equal hashes in every run.
[[nodiscard]] std::uint64_t content_hash(const MeshOperation& operation);

}  // namespace csg
