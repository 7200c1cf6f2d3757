#include "csg/tree/tree.h"

#include <algorithm>
#include <utility>

#include "csg/tree/hash.h"

namespace csg {
namespace {

std::uint64_t hash_of(const glm::dmat4& m) {
    std::uint64_t h = 0x3a7;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            h = mix(h, m[column][row]);
        }
    }
    return h;
}

std::uint64_t hash_of(const Rgba& c) {
    std::uint64_t h = 0xc01;
    for (const float v : {c.r, c.g, c.b, c.a}) {
        h = mix(h, double{v});
    }
    return h;
}

std::uint64_t sharing_hash(const Node& n) {
    return mix(mix(n.hash, std::uint64_t{n.where.line} << 32 | n.where.column), std::uint64_t{n.where.file});
}

}  // namespace

std::uint32_t TreeBuilder::file(const std::string& name) {
    auto& files = tree_.files_;
    const auto found = std::find(files.begin(), files.end(), name);
    if (found != files.end()) {
        return static_cast<std::uint32_t>(found - files.begin());
    }
    files.push_back(name);
    return static_cast<std::uint32_t>(files.size() - 1);
}

template <typename T>
NodeId TreeBuilder::keep(Node node, std::span<const NodeId> children, std::vector<T>& payloads, T payload) {
    node.payload = static_cast<std::uint32_t>(payloads.size());
    payloads.push_back(std::move(payload));
    const NodeId id = add(node, children);
    if (tree_.nodes_[id].payload != node.payload) {
        payloads.pop_back();  // an equal node from the same place existed
    }
    return id;
}

NodeId TreeBuilder::leaf(LeafShape shape, SourceLocation where, Modifiers modifiers) {
    Node n{Operation::Leaf, modifiers, where};
    n.hash = content_hash(shape);
    return keep(n, {}, tree_.shapes_, std::move(shape));
}

NodeId TreeBuilder::combine(Operation operation, std::span<const NodeId> children, SourceLocation where,
                            Modifiers modifiers) {
    Node n{operation, modifiers, where};
    n.hash = 0x09;
    return add(n, children);
}

NodeId TreeBuilder::transform(const glm::dmat4& matrix, std::span<const NodeId> children, SourceLocation where,
                              Modifiers modifiers) {
    Node n{Operation::Transform, modifiers, where};
    n.hash = hash_of(matrix);
    return keep(n, children, tree_.matrices_, matrix);
}

NodeId TreeBuilder::color(const Rgba& color, std::span<const NodeId> children, SourceLocation where,
                          Modifiers modifiers) {
    Node n{Operation::Color, modifiers, where};
    n.hash = hash_of(color);
    return keep(n, children, tree_.colors_, color);
}

NodeId TreeBuilder::mesh(const MeshOperation& operation, std::span<const NodeId> children, SourceLocation where,
                         Modifiers modifiers) {
    Node n{Operation::Mesh, modifiers, where};
    n.hash = content_hash(operation);
    return keep(n, children, tree_.meshes_, operation);
}

bool TreeBuilder::same_content(const Node& a, const Node& b) const {
    if (a.operation != b.operation || a.modifiers != b.modifiers) {
        return false;
    }
    switch (a.operation) {
        case Operation::Transform:
            return tree_.matrices_[a.payload] == tree_.matrices_[b.payload];
        case Operation::Color:
            return tree_.colors_[a.payload] == tree_.colors_[b.payload];
        case Operation::Leaf:
            return same_shape(tree_.shapes_[a.payload], tree_.shapes_[b.payload]);
        case Operation::Mesh:
            return tree_.meshes_[a.payload] == tree_.meshes_[b.payload];
        default:
            return true;
    }
}

NodeId TreeBuilder::add(Node node, std::span<const NodeId> children) {
    Tree& t = tree_;
    std::uint64_t h = mix(node.hash, static_cast<std::uint64_t>(node.operation));
    h = mix(h, std::uint64_t{node.modifiers.background} | std::uint64_t{node.modifiers.highlight} << 1 |
                   std::uint64_t{node.modifiers.root} << 2);
    for (const NodeId child : children) {
        h = mix(h, t.nodes_[child].hash);
    }
    node.hash = h;
    node.child_count = static_cast<std::uint32_t>(children.size());

    if (buckets_.size() < 2 * (t.nodes_.size() + 1)) {
        grow();
    }
    const std::size_t mask = buckets_.size() - 1;
    std::size_t slot = sharing_hash(node) & mask;
    for (; buckets_[slot] != kNoNode; slot = (slot + 1) & mask) {
        const NodeId id = buckets_[slot];
        const Node& other = t.nodes_[id];
        if (other.hash == node.hash && other.where == node.where && std::ranges::equal(t.children(id), children) &&
            same_content(other, node)) {
            return id;
        }
    }
    node.first_child = static_cast<std::uint32_t>(t.child_ids_.size());
    t.child_ids_.insert(t.child_ids_.end(), children.begin(), children.end());
    t.nodes_.push_back(node);
    const auto id = static_cast<NodeId>(t.nodes_.size() - 1);
    buckets_[slot] = id;
    return id;
}

void TreeBuilder::grow() {
    buckets_.assign(std::max<std::size_t>(64, buckets_.size() * 2), kNoNode);
    const std::size_t mask = buckets_.size() - 1;
    for (NodeId id = 0; id < tree_.nodes_.size(); ++id) {
        std::size_t slot = sharing_hash(tree_.nodes_[id]) & mask;
        while (buckets_[slot] != kNoNode) {
            slot = (slot + 1) & mask;
        }
        buckets_[slot] = id;
    }
}

const Statement* Tree::statement(NodeId id) const {
    const auto found = std::ranges::lower_bound(statements_, nodes_[id].where, {}, &Statement::where);
    return found != statements_.end() && found->where == nodes_[id].where ? &*found : nullptr;
}

Tree TreeBuilder::finish(NodeId root, std::vector<Statement> statements) {
    std::ranges::sort(statements, {}, &Statement::where);
    tree_.statements_ = std::move(statements);
    tree_.root_ = root;
    buckets_.clear();
    return std::exchange(tree_, Tree{});
}

}  // namespace csg
