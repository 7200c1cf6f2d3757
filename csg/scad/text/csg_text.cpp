#include "csg/scad/text/csg_text.h"

#include <algorithm>
#include <vector>

#include "csg/scad/text/node_text.h"

namespace csg::scad {

namespace {

/// Trees may be deep beyond what anybody reads; their text must not grow with the square of that.
std::size_t indentation(std::size_t depth) {
    constexpr std::size_t kMost = 1000;
    return std::min(depth, kMost);
}

}  // namespace

void write_csg(const Tree& tree, const std::function<void(std::string_view)>& sink) {
    if (tree.root() == kNoNode) {
        return;
    }
    constexpr std::size_t kPiece = std::size_t{1} << 16;
    std::string text;
    struct Open {
        NodeId node;
        std::size_t next;
    };
    std::vector<Open> open{{tree.root(), 0}};  // The root itself is not printed.
    while (!open.empty()) {
        if (text.size() >= kPiece) {
            sink(text);
            text.clear();
        }
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
        const csg::Modifiers& modifiers = tree.node(child).modifiers;
        text += modifiers.background ? "%" : "";
        text += modifiers.highlight ? "#" : "";
        text.append(indentation(open.size() - 1), '\t');
        append_node_text(tree, child, text);
        if (tree.children(child).empty()) {
            text += ";\n";
        } else {
            text += " {\n";
            open.push_back({child, 0});
        }
    }
    sink(text);
}

std::string csg_text(const Tree& tree) {
    std::string text;
    write_csg(tree, [&text](std::string_view piece) { text += piece; });
    return text;
}

}  // namespace csg::scad
