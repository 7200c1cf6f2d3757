#include "goldfeather/parts_scene.h"

#include <optional>
#include <utility>

#include "base/stop.h"

namespace goldfeather {

PartsScene::PartsScene(const gl::Functions& gl, const EngineInput& input) : input_(input), leaves_(gl, input.geometry) {
    const std::size_t leaves = input.geometry.leaves.size();
    boxes_.resize(leaves);
    wound_.resize(leaves);
    open_.resize(leaves);
    for (csg::LeafId id = 0; id < leaves; ++id) {
        note(id);
    }
}

void PartsScene::note(csg::LeafId id) {
    const csg::solid::PlacedLeaf& leaf = input_.geometry.leaves[id];
    boxes_[id] = leaf.box;
    wound_[id] = leaf.solid->winds() ? 1 : 0;
    open_[id] = leaf.solid->closed ? 0 : 1;
}

bool PartsScene::update(const csg::solid::SceneChange& change) {
    if (change.structure) {
        return false;
    }
    leaves_.update(change);
    for (const csg::LeafId id : change.leaves) {
        note(id);
    }
    return true;
}

layers::TextureStack PartsScene::draw(const DrawPart& draw_part, peel::Merge& merge, int max_layers,
                                      const std::stop_token& stop) {
    // Highlighted parts come before all others, and each kind in order of the parts' ids.
    std::optional<layers::TextureStack> plain, highlighted;
    for (std::size_t i = 0; i < input_.products.size(); ++i) {
        if (input_.scene.parts[i].hidden) {
            continue;
        }
        std::optional<layers::TextureStack>& kind =
            input_.scene.parts[i].kind == csg::PartKind::Highlight ? highlighted : plain;
        base::end_if_asked(stop);
        layers::TextureStack next = draw_part(leaves_, part(input_.products[i]));
        kind = kind ? merge(*kind, next, max_layers) : std::move(next);
    }
    if (plain && highlighted) {
        return merge(*highlighted, *plain, max_layers);
    }
    if (!plain && !highlighted) {
        return draw_part(leaves_, part({}));
    }
    return std::move(plain ? *plain : *highlighted);
}

}  // namespace goldfeather
