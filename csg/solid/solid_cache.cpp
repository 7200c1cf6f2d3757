#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "base/stop.h"
#include "csg/solid/located.h"
#include "csg/solid/misplaced.h"
#include "csg/solid/node_geometry.h"
#include "csg/solid/placed.h"
#include "csg/solid/text_outline.h"
#include "csg/tree/out_of_memory.h"

namespace csg::solid {

namespace {

/// Of an object that is part of another, what was told of that is not told again.
template <typename Made>
void tell(const Tree& tree, NodeId node, const Made& made, Remarks& remarks, const NodeGeometry* told = nullptr) {
    const auto add = [&](const std::vector<std::string>& texts, const std::vector<std::string>* known,
                         std::vector<std::string>& all) {
        for (const std::string& text : texts) {
            if (known == nullptr || std::find(known->begin(), known->end(), text) == known->end()) {
                all.push_back(located(tree, tree.node(node).where, text));
            }
        }
    };
    add(made.warnings, told != nullptr ? &told->warnings : nullptr, remarks.warnings);
    add(made.failures, told != nullptr ? &told->failures : nullptr, remarks.failures);
}

void tell_misplaced(const Tree& tree, NodeId node, const NodeGeometry& made, Remarks& remarks) {
    if (made.misplaced.empty()) {
        return;
    }
    std::vector<NodeId> counted;
    for (const NodeId child : tree.children(node)) {
        if (!tree.node(child).modifiers.background) {
            counted.push_back(child);
        }
    }
    for (const ChildRemark& remark : made.misplaced) {
        remarks.warnings.push_back(located(tree, tree.node(counted[remark.child]).where, remark.text));
    }
}

/// What make() gives; where that takes too much memory, it is told which node asked for it.
template <typename Make>
auto of_node(const Tree& tree, NodeId node, const Make& make) -> decltype(make()) {
    try {
        return make();
    } catch (const OutOfMemory&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw OutOfMemory(located(tree, tree.node(node).where, "this object"));
    } catch (const std::length_error&) {
        throw OutOfMemory(located(tree, tree.node(node).where, "this object"));
    }
}

}  // namespace

/// Of one content: as geometry, as a mesh, or both.
///
/// Two contents are told apart by their hashes alone, for what is below a node stands in a tree that may be gone by the
/// time another asks, and keeping all trees to compare with would cost more than the meshes. Hashes have 64 bits that
/// all depend on all of the content (csg/tree/hash.h): among a million contents that a session holds at a time, two
/// that differ have one hash with a probability of 3e-8.
struct SolidCache::Entry {
    std::unique_ptr<const NodeGeometry> geometry;
    std::shared_ptr<const Solid> solid;
    std::uint32_t used = 0;
};

SolidCache::SolidCache(std::shared_ptr<const MeshOperations> operations)
    : operations_(std::move(operations)), fonts_(std::make_unique<FontLibrary>()) {}
SolidCache::~SolidCache() = default;

Tools SolidCache::tools(const std::stop_token& stop) {
    return {operations_.get(), *fonts_, [this, &stop](const LeafShape& shape) { return get(shape, stop); }, stop};
}

std::shared_ptr<const Solid> SolidCache::get(const LeafShape& shape, const std::stop_token& stop) {
    base::end_if_asked(stop);
    Entry& entry = entries_[content_hash(shape)];
    entry.used = generation_;
    if (!entry.solid) {
        entry.solid = make_solid(shape);
    }
    return entry.solid;
}

std::shared_ptr<const Solid> SolidCache::get(const Tree& tree, NodeId node, const std::vector<Dimension>& by_node,
                                             Remarks& remarks, const std::stop_token& stop) {
    if (tree.node(node).operation == Operation::Leaf && by_node[node] == Dimension::Solid) {
        const LeafShape& shape = tree.shape(node);
        if (!std::holds_alternative<std::shared_ptr<const Import>>(shape) &&
            !std::holds_alternative<std::shared_ptr<const Surface>>(shape)) {
            auto solid = of_node(tree, node, [&] { return get(shape, stop); });
            tell(tree, node, *solid, remarks);
            return solid;
        }
    }
    const NodeGeometry& made = geometry(tree, node, by_node, remarks, stop);
    Entry& entry = entries_[tree.node(node).hash];
    if (!entry.solid) {
        entry.solid = of_node(tree, node, [&] { return as_solid(made, tools(stop)); });
    }
    tell(tree, node, *entry.solid, remarks, &made);
    return entry.solid;
}

/// All nodes below are visited, children first: their geometry is kept as long as this node's is, and remarks are told
/// with the places they have in this tree.
const NodeGeometry& SolidCache::geometry(const Tree& tree, NodeId top, const std::vector<Dimension>& by_node,
                                         Remarks& remarks, const std::stop_token& stop) {
    std::vector<NodeId> nodes{top};
    std::unordered_set<NodeId> seen{top};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const NodeId child : tree.children(nodes[i])) {
            if (!tree.node(child).modifiers.background && seen.insert(child).second) {
                nodes.push_back(child);
            }
        }
    }
    std::sort(nodes.begin(), nodes.end());
    std::vector<const NodeGeometry*> children;
    for (const NodeId id : nodes) {
        base::end_if_asked(stop);
        Entry& known = entries_[tree.node(id).hash];
        known.used = generation_;
        if (!known.geometry) {
            children.clear();
            for (const NodeId child : tree.children(id)) {
                if (!tree.node(child).modifiers.background) {
                    children.push_back(entries_[tree.node(child).hash].geometry.get());
                }
            }
            known.geometry = of_node(tree, id, [&] {
                return std::make_unique<NodeGeometry>(make_geometry(tree, id, by_node[id], children, tools(stop)));
            });
        }
        tell_misplaced(tree, id, *known.geometry, remarks);
        tell(tree, id, *known.geometry, remarks);
    }
    return *entries_[tree.node(top).hash].geometry;
}

std::shared_ptr<const Outline> SolidCache::outline(const Tree& tree, Remarks& remarks, const std::stop_token& stop) {
    return tree.root() == kNoNode ? nullptr : geometry(tree, tree.root(), dimensions(tree), remarks, stop).outline;
}

void SolidCache::tell_left_out(const Tree& tree, const Scene& scene, const std::vector<Dimension>& by_node,
                               Remarks& remarks, const std::stop_token& stop) {
    std::unordered_map<OccurrenceId, MisplacedOutlines> among;
    for (const LeftOut& left_out : scene.left_out) {
        const bool empty = geometry(tree, left_out.node, by_node, remarks, stop).outline->empty();
        const auto at = among.try_emplace(left_out.parent, tree, scene.occurrences[left_out.parent].node).first;
        for (const char* text : at->second.next(empty)) {
            remarks.warnings.push_back(located(tree, tree.node(left_out.node).where, text));
        }
    }
}

SolidCache::Size SolidCache::size() const {
    Size size;
    std::unordered_set<const Solid*> counted;  // An entry may hold what another one does.
    const auto count = [&](const std::shared_ptr<const Solid>& solid) {
        if (solid && counted.insert(solid.get()).second) {
            size.bytes += solid->points.size() * sizeof(glm::dvec3) + solid->triangles.size() * sizeof(glm::uvec3);
        }
    };
    for (const auto& [key, entry] : entries_) {
        ++size.entries;
        count(entry.solid);
        if (!entry.geometry) {
            continue;
        }
        for (const Piece& piece : entry.geometry->pieces) {
            count(piece.solid);
        }
        if (entry.geometry->outline) {
            size.bytes += entry.geometry->outline->corners() * sizeof(glm::dvec2);
        }
    }
    return size;
}

void SolidCache::trim() {
    std::erase_if(entries_, [this](const auto& entry) { return entry.second.used != generation_; });
    ++generation_;
}

}  // namespace csg::solid
