// Stacks of layers for csgscope compare, by any engine.
#pragma once

#include <memory>
#include <vector>

#include "gl/context.h"
#include "goldfeather/engines.h"
#include "layers/host_stack.h"
#include "ui/pipeline/comparison/solid_scene.h"

namespace ui {

/// The solid with the engine that draws it from all views.
class Drawer {
  public:
    /// `solid` must outlive the drawer. Makes a context where the engine needs one. Throws ModelError where the model
    /// has too many products for the engine, gl::Error where there is no OpenGL.
    Drawer(const SolidScene& solid, const goldfeather::EngineInfo& engine);

    /// The first most_layers() layers. Throws ModelError, with the reason, where the engine cannot draw them.
    [[nodiscard]] std::shared_ptr<const layers::HostStack> layers(const base::View& view);

    /// How many layers the engine finds; goldfeather::kAllLayers: all.
    [[nodiscard]] int most_layers() const { return info_.capabilities.most_layers; }

  private:
    const SolidScene& solid_;
    const goldfeather::EngineInfo& info_;
    std::vector<std::vector<goldfeather::Product>> products_{1};
    std::unique_ptr<gl::Context> context_;  ///< Goes last; null where the engine needs none.
    std::unique_ptr<goldfeather::Engine> engine_;
    std::unique_ptr<goldfeather::PreparedScene> scene_;
};

}  // namespace ui
