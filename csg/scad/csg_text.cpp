#include "csg/scad/csg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace csg::scad {

namespace {

/// As C++ streams print it: six significant digits.
std::string number(double value) {
    return fmt::format("{:g}", value);
}

std::string vector(const glm::dvec3& v) {
    return fmt::format("[{:g}, {:g}, {:g}]", v.x, v.y, v.z);
}

std::string fineness(const Fineness& f) {
    return fmt::format("$fn = {:g}, $fa = {:g}, $fs = {:g}", f.fn, f.fa, f.fs);
}

struct ShapeText {
    std::string operator()(const Cube& c) const {
        return fmt::format("cube(size = {}, center = {})", vector(c.size), c.center);
    }
    std::string operator()(const Sphere& s) const {
        return fmt::format("sphere({}, r = {})", fineness(s.fineness), number(s.radius));
    }
    std::string operator()(const Cylinder& c) const {
        return fmt::format("cylinder({}, h = {}, r1 = {}, r2 = {}, center = {})", fineness(c.fineness),
                           number(c.height), number(c.radius1), number(c.radius2), c.center);
    }
    std::string operator()(const std::shared_ptr<const Polyhedron>& p) const {
        std::string points, faces;
        for (const glm::dvec3& point : p->points) {
            points += (points.empty() ? "" : ", ") + vector(point);
        }
        for (const auto& face : p->faces) {
            faces += fmt::format("{}[{}]", faces.empty() ? "" : ", ", fmt::join(face, ", "));
        }
        return fmt::format("polyhedron(points = [{}], faces = [{}], convexity = {})", points, faces, p->convexity);
    }
};

std::string matrix(const glm::dmat4& m) {
    std::string rows;
    for (int row = 0; row < 4; ++row) {
        rows +=
            fmt::format("{}[{:g}, {:g}, {:g}, {:g}]", row == 0 ? "" : ", ", m[0][row], m[1][row], m[2][row], m[3][row]);
    }
    return fmt::format("multmatrix([{}])", rows);
}

std::string head(const Tree& tree, NodeId id) {
    switch (tree.node(id).operation) {
        case Operation::Group:
            return "group()";
        case Operation::Union:
            return "union()";
        case Operation::Difference:
            return "difference()";
        case Operation::Intersection:
            return "intersection()";
        case Operation::Transform:
            return matrix(tree.matrix(id));
        case Operation::Color: {
            const Rgba& c = tree.color(id);
            return fmt::format("color([{:g}, {:g}, {:g}, {:g}])", c.r, c.g, c.b, c.a);
        }
        case Operation::Leaf:
            return std::visit(ShapeText{}, tree.shape(id));
    }
    return {};
}

/// Trees may be deep beyond what anybody reads; their text must not grow with the square of that.
std::size_t indentation(std::size_t depth) {
    constexpr std::size_t kMost = 1000;
    return std::min(depth, kMost);
}

}  // namespace

std::string csg_text(const Tree& tree) {
    std::string text;
    if (tree.root() == kNoNode) {
        return text;
    }
    struct Open {
        NodeId node;
        std::size_t next;
    };
    std::vector<Open> open{{tree.root(), 0}};  // The root itself is not printed.
    while (!open.empty()) {
        Open& top = open.back();
        const auto children = tree.children(top.node);
        if (top.next == children.size()) {
            open.pop_back();
            if (!open.empty()) {
                text.append(indentation(open.size() - 1), '\t');
                text += "}\n";
            }
            continue;
        }
        const NodeId child = children[top.next++];
        const Modifiers& modifiers = tree.node(child).modifiers;
        text += modifiers.background ? "%" : "";
        text += modifiers.highlight ? "#" : "";
        text.append(indentation(open.size() - 1), '\t');
        text += head(tree, child);
        if (tree.children(child).empty()) {
            text += ";\n";
        } else {
            text += " {\n";
            open.push_back({child, 0});
        }
    }
    return text;
}

}  // namespace csg::scad
