// Scenes for engines that draw one part at a time, from sums of products.
#pragma once

#include <functional>
#include <vector>

#include "goldfeather/engine.h"
#include "goldfeather/goldfeather/part_products.h"
#include "goldfeather/leaf_buffers.h"
#include "layers/texture_stack.h"
#include "peel/merge.h"

namespace goldfeather {

class PartsScene {
  public:
    /// Throws EngineObstacle where OpenGL has no room for the leaves.
    PartsScene(const gl::Functions& gl, const EngineInput& input);

    /// Draws one part; one without products is empty everywhere.
    using DrawPart = std::function<layers::TextureStack(LeafBuffers& leaves, const PartProducts& part)>;
    /// The stacks of all parts merged by depth. Throws base::Stopped where `stop` asked for it.
    [[nodiscard]] layers::TextureStack draw(const DrawPart& draw_part, peel::Merge& merge, int max_layers,
                                            const std::stop_token& stop);

    /// See PreparedScene.
    [[nodiscard]] bool update(const csg::solid::SceneChange& change);

    [[nodiscard]] const EngineInput& input() const { return input_; }
    [[nodiscard]] LeafBuffers& leaves() { return leaves_; }
    /// With the scene's leaves.
    [[nodiscard]] PartProducts part(std::span<const Product> products) const {
        return {products, boxes_, wound_, open_};
    }

  private:
    void note(csg::LeafId id);

    EngineInput input_;
    LeafBuffers leaves_;
    std::vector<csg::Box> boxes_;
    std::vector<char> wound_, open_;  ///< By LeafId: Solid::winds(); not Solid::closed.
};

}  // namespace goldfeather
