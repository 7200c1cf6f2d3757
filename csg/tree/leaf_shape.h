// The parameters of a leaf of the CSG tree, as the language gives them; csg/solid turns them into closed meshes and
// outlines.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace csg {

/// OpenSCAD's $fn, $fa (degrees) and $fs (model units): how finely a curved leaf is tessellated. $fe (model units), the
/// most that an edge may be off the arc that it stands for, takes the place of $fa and $fs where it is above zero; it
/// is absent unless the experiment discretization-by-error is enabled.
struct Fineness {
    double fn = 0;
    double fa = 12;
    double fs = 2;
    std::optional<double> fe = {};
    bool operator==(const Fineness&) const = default;
};

/// A box from the origin, or about it.
struct Cube {
    glm::dvec3 size{1.0};
    bool center = false;
    bool operator==(const Cube&) const = default;
};

/// A sphere about the origin.
struct Sphere {
    double radius = 1;
    Fineness fineness;
    bool operator==(const Sphere&) const = default;
};

/// A truncated cone along +z: `radius1` below, `radius2` above.
struct Cylinder {
    double height = 1;
    double radius1 = 1;
    double radius2 = 1;
    bool center = false;
    Fineness fineness;
    bool operator==(const Cylinder&) const = default;
};

/// A mesh given by hand. Faces are loops of point indices, clockwise seen from outside (OpenSCAD's orientation).
struct Polyhedron {
    std::vector<glm::dvec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    unsigned convexity = 1;  ///< Kept for the .csg text only; never believed.
    bool operator==(const Polyhedron&) const = default;
};

/// A rectangle from the origin, or about it.
struct Square {
    glm::dvec2 size{1.0};
    bool center = false;
    bool operator==(const Square&) const = default;
};

/// A disc about the origin.
struct Circle {
    double radius = 1;
    Fineness fineness;
    bool operator==(const Circle&) const = default;
};

/// Outlines given by hand, even-odd.
struct Polygon {
    std::vector<glm::dvec2> points;
    std::vector<std::vector<std::uint32_t>> paths;
    bool has_paths = false;  ///< Without paths the points in their order are the one path.
    unsigned convexity = 1;  ///< Kept for the .csg text only.
    bool operator==(const Polygon&) const = default;
};

/// A line of text. Empty strings leave the choice to the program that draws it.
struct Text {
    std::string text;
    double size = 10;  ///< About the height of a capital letter, in model units.
    double spacing = 1;
    std::string font, direction = "ltr", language = "en", script, halign = "default", valign = "default";
    Fineness fineness;
    std::vector<std::string> font_files;  ///< Of `use <font.ttf>`.
    bool operator==(const Text&) const = default;
};

/// A file that is there when the tree is made; its time tells one state of it from another.
struct FileStamp {
    std::string path;   ///< To open it; empty where none was named.
    std::string shown;  ///< As the .csg text names it.
    std::int64_t modified = 0;
    std::uint64_t bytes = 0;
    bool operator==(const FileStamp&) const = default;
};

/// A mesh (stl, off, obj, amf, 3mf) or outlines (dxf, svg) from a file; which of them, its name tells.
struct Import {
    FileStamp file;
    std::string layer, id;
    glm::dvec2 origin{0.0};
    double scale = 1;
    double dpi = 72;  ///< For svg; OpenSCAD's default.
    bool center = false;
    unsigned convexity = 1;
    Fineness fineness;
    bool operator==(const Import&) const = default;
};

/// A height map from a table of numbers or a picture (png).
struct Surface {
    FileStamp file;
    bool center = false;
    bool invert = false;
    bool operator==(const Surface&) const = default;
};

/// Shapes of any size are shared, not copied.
using LeafShape = std::variant<Cube, Sphere, Cylinder, std::shared_ptr<const Polyhedron>, Square, Circle,
                               std::shared_ptr<const Polygon>, std::shared_ptr<const Text>,
                               std::shared_ptr<const Import>, std::shared_ptr<const Surface>>;

/// A hash of kind and parameters; equal shapes have equal hashes in every run.
[[nodiscard]] std::uint64_t content_hash(const LeafShape& shape);

/// Whether kind and parameters are equal: those of shared shapes, not where they are kept.
[[nodiscard]] bool same_shape(const LeafShape& a, const LeafShape& b);

/// As those of hash.h.
[[nodiscard]] std::uint64_t mix(std::uint64_t seed, const Fineness& fineness);

/// Outlines in the plane, or a solid.
[[nodiscard]] bool is_flat(const LeafShape& shape);

}  // namespace csg
