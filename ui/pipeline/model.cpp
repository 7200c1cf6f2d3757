#include "ui/pipeline/model.h"

#include <algorithm>
#include <atomic>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/stop.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

namespace {

constexpr double kPreviewThickness = 1, kFlat = 0x1p-10;  // Of outlines by themselves, in world units.

std::string place_of(const csg::Tree& tree, const csg::SourceLocation& where) {
    if (!where.known() || where.file >= tree.files().size()) {
        return "";
    }
    return fmt::format("{}:{}:{}: ", tree.files()[where.file], where.line, where.column);
}

std::uint64_t next_generation() {
    static std::atomic<std::uint64_t> count{0};
    return ++count;
}

/// The part's products; none for an empty part, nor for one over the budget.
std::vector<goldfeather::Product> products_of(Model& model, const csg::Part& part, std::span<const csg::Box> boxes,
                                              const goldfeather::Budget& budget, ModelStatistics& sum) {
    goldfeather::NormalizationStats stats;
    auto normalized = goldfeather::normalize(model.scene, part, boxes, budget, stats);
    if (const auto* over = std::get_if<goldfeather::OverBudget>(&normalized)) {
        const auto& where = model.scene.leaves[part.first_leaf].where;
        model.over_budget = fmt::format(
            "{}the part that begins here needs more than {} products ({} were made); "
            "differences and intersections of large unions multiply",
            place_of(*model.tree, where), budget.products, over->products);
        model.box = csg::enclose(model.box, csg::bounds(model.scene, part, boxes));
        return {};
    }
    sum.products_unpruned = std::min(1e18, sum.products_unpruned + stats.products_unpruned);
    sum.products += stats.products;
    sum.literals += stats.literals;
    sum.pruned_products += stats.pruned_products;
    sum.pruned_literals += stats.pruned_literals;
    auto* found = std::get_if<goldfeather::SumOfProducts>(&normalized);
    return found ? std::move(found->products) : std::vector<goldfeather::Product>{};
}

void throw_failures(const std::vector<std::string>& failures) {
    if (!failures.empty()) {
        throw ModelError(fmt::format("{}", fmt::join(failures, "\n")));
    }
}

}  // namespace

std::shared_ptr<const Model> ModelBuilder::build(std::shared_ptr<const csg::Tree> tree, const std::stop_token& stop,
                                                 std::shared_ptr<const csg::scad::LoadedProgram> program) {
    auto model = std::make_shared<Model>();
    model->tree = std::move(tree);
    model->program = std::move(program);
    model->generation = next_generation();
    Stopwatch watch;
    ModelStatistics& statistics = model->statistics;
    const bool result = showing_ == csg::Showing::Result;
    model->flat = result && csg::is_flat(*model->tree);
    model->scene = csg::make_scene(*model->tree, showing_, parts_);
    model->geometry = csg::solid::place(*model->tree, model->scene, solids_, result ? kFlat : kPreviewThickness, stop);
    solids_.trim();
    statistics.place_ms = watch.lap();

    std::vector<csg::Box> boxes;
    for (const auto& leaf : model->geometry.leaves) {
        boxes.push_back(leaf.box);
        statistics.triangles += leaf.triangles.size();
    }
    for (const csg::Part& part : model->scene.parts) {
        base::end_if_asked(stop);
        model->products.push_back(products_of(*model, part, boxes, budget_, statistics));
        for (const goldfeather::Product& product : model->products.back()) {
            model->box = csg::enclose(model->box, product.box);
        }
    }
    statistics.normalize_ms = watch.lap();
    statistics.leaves = model->scene.leaves.size();
    statistics.parts = model->scene.parts.size();
    statistics.planes = model->geometry.planes.planes().size();
    model->warnings = model->geometry.warnings;
    model->failures = model->geometry.failures;
    return model;
}

std::shared_ptr<const csg::solid::Outline> ModelBuilder::outline(const Model& model, const std::stop_token& stop) {
    csg::solid::Remarks remarks;
    auto outline = solids_.outline(*model.tree, remarks, stop);
    // To put the objects together may fail, too.
    std::erase_if(remarks.failures, [&](const std::string& failure) {
        return std::find(model.failures.begin(), model.failures.end(), failure) != model.failures.end();
    });
    throw_failures(remarks.failures);
    if (!outline || outline->empty()) {
        throw ModelError("the model is empty: there is nothing to export");
    }
    return outline;
}

void need_whole(const Model& model) {
    throw_failures(model.failures);
}

goldfeather::EngineConditions engine_conditions(const Model& model, bool software_renderer, int layers) {
    std::vector<csg::Box> boxes;
    boxes.reserve(model.geometry.leaves.size());
    for (const csg::solid::PlacedLeaf& leaf : model.geometry.leaves) {
        boxes.push_back(leaf.box);
    }
    return {software_renderer, !model.over_budget.empty(), goldfeather::estimated_depth(boxes, model.geometry.box),
            layers};
}

}  // namespace ui
