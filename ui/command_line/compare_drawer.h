// Stacks of layers for csgscope compare, by any engine.
#pragma once

#include <memory>
#include <optional>

#include "gl/context.h"
#include "goldfeather/choice.h"
#include "peel/peeler.h"
#include "ui/pipeline/comparison/solid_scene.h"

namespace ui {

/// The solid with the engine that draws it from all views.
class Drawer {
  public:
    /// `solid` must outlive the drawer. Makes a context where the engine needs one. Throws ModelError where the model
    /// has too many products for the engine, gl::Error where there is no OpenGL.
    Drawer(const SolidScene& solid, goldfeather::EngineKind engine);

    /// The first most_layers() layers. Throws ModelError, with the reason, where the engine cannot draw them.
    [[nodiscard]] layers::HostStack layers(const base::View& view);

    /// How many layers the engine finds; peel::kAllLayers: all.
    [[nodiscard]] int most_layers() const { return engine_ == goldfeather::EngineKind::Scs ? 1 : peel::kAllLayers; }

  private:
    const SolidScene& solid_;
    goldfeather::EngineKind engine_;
    // Only for the engines on OpenGL. The context goes last.
    std::unique_ptr<gl::Context> context_;
    std::optional<peel::Peeler> peeler_;
    std::optional<peel::PeelModel> model_;
};

}  // namespace ui
