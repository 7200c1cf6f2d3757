#include "goldfeather/parts_scene.h"

#include <optional>
#include <utility>

#include "base/stop.h"

namespace goldfeather {

PartsScene::PartsScene(const gl::Functions& gl, const EngineInput& input) : input_(input), leaves_(gl, input.geometry) {
    boxes_.reserve(input.geometry.leaves.size());
    wound_.reserve(input.geometry.leaves.size());
    open_.reserve(input.geometry.leaves.size());
    for (const csg::solid::PlacedLeaf& leaf : input.geometry.leaves) {
        boxes_.push_back(leaf.box);
        wound_.push_back(leaf.solid->winds() ? 1 : 0);
        open_.push_back(leaf.solid->closed ? 0 : 1);
    }
}

layers::TextureStack PartsScene::draw(const DrawPart& draw_part, peel::Merge& merge, int max_layers,
                                      const std::stop_token& stop) {
    if (input_.products.empty()) {
        return draw_part(leaves_, part({}));
    }
    // Highlighted parts come before all others, and each kind in order of the parts' ids.
    std::optional<layers::TextureStack> plain, highlighted;
    for (std::size_t i = 0; i < input_.products.size(); ++i) {
        std::optional<layers::TextureStack>& kind =
            input_.scene.parts[i].kind == csg::PartKind::Highlight ? highlighted : plain;
        base::end_if_asked(stop);
        layers::TextureStack next = draw_part(leaves_, part(input_.products[i]));
        kind = kind ? merge(*kind, next, max_layers) : std::move(next);
    }
    if (plain && highlighted) {
        return merge(*highlighted, *plain, max_layers);
    }
    return std::move(plain ? *plain : *highlighted);
}

}  // namespace goldfeather
