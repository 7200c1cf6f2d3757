#include "ui/command_line/compare_drawer.h"

#include <fmt/format.h>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/products.h"
#include "ui/pipeline/model.h"

namespace ui {

namespace {

/// Of the scene's only part.
std::vector<goldfeather::Product> products_of(const SolidScene& solid, goldfeather::EngineKind engine) {
    std::vector<csg::Box> boxes;
    for (const auto& leaf : solid.geometry.leaves) {
        boxes.push_back(leaf.box);
    }
    goldfeather::NormalizationStats ignored;
    auto normalized = goldfeather::normalize(solid.scene, solid.scene.parts[0], boxes, {}, ignored);
    if (std::holds_alternative<goldfeather::OverBudget>(normalized)) {
        throw ModelError(
            fmt::format("the model needs more products than the engine {} takes", goldfeather::name(engine)));
    }
    auto* sum = std::get_if<goldfeather::SumOfProducts>(&normalized);
    return sum != nullptr ? std::move(sum->products) : std::vector<goldfeather::Product>{};
}

}  // namespace

Drawer::Drawer(const SolidScene& solid, goldfeather::EngineKind engine) : solid_(solid), engine_(engine) {
    if (engine == goldfeather::EngineKind::ListsCpu) {
        return;
    }
    std::vector<std::vector<goldfeather::Product>> products(1);
    if (goldfeather::needs_products(engine)) {
        products[0] = products_of(solid, engine);
    }
    context_ = gl::create_context(gl::ContextKind::Auto);
    peeler_.emplace(context_->functions());
    model_.emplace(context_->functions(), solid.scene, solid.geometry, std::move(products), engine);
}

layers::HostStack Drawer::layers(const base::View& view) {
    if (!model_) {
        return goldfeather::peel_to_host(solid_.scene, solid_.geometry, view);
    }
    peel::WalkStats stats;
    const layers::TextureStack stack = peeler_->peel(view, *model_, most_layers(), stats);
    if (!stats.fallback.empty()) {
        throw ModelError(
            fmt::format("the engine {} cannot draw the model: {}", goldfeather::name(engine_), stats.fallback));
    }
    return layers::read_back(context_->functions(), stack);
}

}  // namespace ui
