#include "ui/pipeline/model.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/stop.h"
#include "ui/pipeline/model_parts.h"
#include "ui/pipeline/sections.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

namespace {

constexpr double kPreviewThickness = 1, kFlat = 0x1p-10;  // Of outlines by themselves, in world units.

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
    cut_by_parts(model->scene, sections_);
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
        PartProducts made = products_of(*model, part, boxes, budget_, statistics);
        model->box = csg::enclose(model->box, made.box);
        model->products.push_back(std::move(made.products));
        if (!made.over_budget.empty()) {
            model->over_budget = std::move(made.over_budget);
        }
    }
    set_hatchings(*model, sections_);
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
