#include "ui/command_line/compare_drawer.h"

#include <fmt/format.h>

#include "goldfeather/products.h"
#include "layers/texture_stack.h"
#include "ui/pipeline/model.h"

namespace ui {

namespace {

/// Of the scene's only part.
std::vector<goldfeather::Product> products_of(const SolidScene& solid, const goldfeather::EngineInfo& engine) {
    std::vector<csg::Box> boxes;
    for (const auto& leaf : solid.geometry.leaves) {
        boxes.push_back(leaf.box);
    }
    goldfeather::NormalizationStats ignored;
    auto normalized = goldfeather::normalize(solid.scene, solid.scene.parts[0], boxes, {}, ignored);
    if (std::holds_alternative<goldfeather::OverBudget>(normalized)) {
        throw ModelError(fmt::format("the model needs more products than the engine {} takes", engine.name));
    }
    auto* sum = std::get_if<goldfeather::SumOfProducts>(&normalized);
    return sum != nullptr ? std::move(sum->products) : std::vector<goldfeather::Product>{};
}

}  // namespace

Drawer::Drawer(const SolidScene& solid, const goldfeather::EngineInfo& engine) : solid_(solid), info_(engine) {
    if (engine.capabilities.needs_products) {
        products_[0] = products_of(solid, engine);
    }
    if (engine.capabilities.needs_opengl) {
        context_ = gl::create_context(gl::ContextKind::Auto);
    }
    engine_ = goldfeather::make_engine(engine, {.gl = context_ ? &context_->functions() : nullptr});
}

std::shared_ptr<const layers::HostStack> Drawer::layers(const base::View& view) {
    try {
        if (!scene_) {
            scene_ = engine_->prepare({solid_.scene, solid_.geometry, products_});
        }
        goldfeather::WalkStats ignored;
        const layers::Stack stack = scene_->draw(view, most_layers(), ignored);
        return context_ ? layers::in_main_memory(context_->functions(), stack) : stack.host;
    } catch (const goldfeather::EngineObstacle& obstacle) {
        throw ModelError(fmt::format("the engine {} cannot draw the model: {}", info_.name, obstacle.what()));
    }
}

}  // namespace ui
