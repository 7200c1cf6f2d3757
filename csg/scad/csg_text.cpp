#include "csg/scad/csg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "csg/scad/node_text.h"

namespace csg::scad {

namespace {

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
            return leaf_text(tree.shape(id));
        case Operation::Mesh:
            return mesh_text(tree.mesh(id));
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
