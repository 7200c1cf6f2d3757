#include "goldfeather/parts_scene.h"

#include <optional>
#include <utility>

#include "base/stop.h"
#include "csg/solid/part_order.h"

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
    std::optional<layers::TextureStack> merged;
    for (const csg::PartId i : csg::solid::part_order(input_.scene, &input_.geometry)) {
        if (i >= input_.products.size() || input_.scene.parts[i].hidden) {
            continue;
        }
        base::end_if_asked(stop);
        layers::TextureStack next = draw_part(leaves_, part(input_.products[i]));
        merged = merged ? merge(*merged, next, max_layers) : std::move(next);
    }
    return merged ? std::move(*merged) : draw_part(leaves_, part({}));
}

}  // namespace goldfeather
