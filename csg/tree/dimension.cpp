#include "csg/tree/dimension.h"

namespace csg {
namespace {

Dimension of_children(const Tree& tree, NodeId id, const std::vector<Dimension>& known) {
    for (const NodeId child : tree.children(id)) {
        if (!tree.node(child).modifiers.background && known[child] != Dimension::None) {
            return known[child];
        }
    }
    return Dimension::None;
}

template <typename... Ts>
bool is_one_of(const MeshOperation& operation) {
    return (std::holds_alternative<Ts>(operation) || ...);
}

}  // namespace

std::vector<Dimension> dimensions(const Tree& tree) {
    std::vector<Dimension> result(tree.size(), Dimension::None);
    for (NodeId id = 0; id < tree.size(); ++id) {  // Children stand before parents.
        const Operation operation = tree.node(id).operation;
        if (operation == Operation::Leaf) {
            result[id] = is_flat(tree.shape(id)) ? Dimension::Flat : Dimension::Solid;
        } else if (operation == Operation::Mesh && is_one_of<LinearExtrude, RotateExtrude, Roof>(tree.mesh(id))) {
            result[id] = Dimension::Solid;
        } else if (operation == Operation::Mesh && is_one_of<Offset, Fill, Projection>(tree.mesh(id))) {
            result[id] = Dimension::Flat;
        } else {
            result[id] = of_children(tree, id, result);
        }
    }
    return result;
}

}  // namespace csg
