#include "ui/pipeline/motion/leaf_paths.h"

#include "csg/tree/hash.h"

namespace ui {

std::vector<LeafPath> leaf_paths(const csg::Tree& tree, const csg::Scene& scene) {
    std::vector<std::uint64_t> calls(scene.occurrences.size(), 0);  // Parents stand before their children.
    for (std::size_t i = 0; i < scene.occurrences.size(); ++i) {
        const csg::Occurrence& o = scene.occurrences[i];
        const csg::SourceLocation& where = tree.node(o.node).where;
        const std::uint64_t above = o.parent == csg::kNoOccurrence ? 0 : calls[o.parent];
        calls[i] = csg::mix(csg::mix(csg::mix(above, std::uint64_t{where.file}), std::uint64_t{where.line}),
                            std::uint64_t{where.column});
    }
    std::vector<LeafPath> paths;
    paths.reserve(scene.leaves.size());
    for (const csg::LeafInstance& leaf : scene.leaves) {
        paths.push_back(
            {leaf.occurrence == csg::kNoOccurrence ? 0 : calls[leaf.occurrence], tree.node(leaf.node).hash});
    }
    return paths;
}

}  // namespace ui
