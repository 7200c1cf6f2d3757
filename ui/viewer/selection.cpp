#include "ui/viewer/selection.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace ui {

SelectedSurface selected_surface(const Model& model, const csg::scad::SourceSet& sources, const PickedSurface& picked) {
    const csg::LeafInstance& leaf = model.scene.leaves[picked.surface.leaf];
    const std::vector<CallStep> steps = steps_to(model, picked.occurrence);
    SelectedSurface selected;
    selected.surface = picked;
    selected.title = fmt::format("{}{}, part {}", shape_of(leaf, steps), picked.surface.reversed ? ", which cuts" : "",
                                 model.scene.parts[picked.part].name);
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        SelectedCall& call = selected.calls.emplace_back();
        const csg::SourceLocation& where = step->node.where;
        const std::filesystem::path file(model.tree->files()[where.file]);
        call.call = call_text(model, sources, *step);
        call.place = fmt::format("{}:{}", file.filename().string(), where.line);
        const csg::Operation operation = step->node.operation;
        if (step->statement != nullptr &&
            (operation == csg::Operation::Difference || operation == csg::Operation::Intersection)) {
            call.explained = CallAt{step->statement->name, file.string(), where.line, where.column};
        }
        if (auto place = call_place(model, sources, *step)) {
            call.text = {std::move(place->text), place->range};
        }
    }
    return selected;
}

void Selection::take(std::vector<SelectedSurface> surfaces, const glm::dvec2& at) {
    constexpr double kSamePlace = 4;  // Pixels: a hand is not steadier.
    const bool again =
        !surfaces_.empty() && glm::distance(at, at_) <= kSamePlace && surfaces.size() == surfaces_.size();
    surfaces_ = std::move(surfaces);
    index_ = again ? (index_ + 1) % surfaces_.size() : 0;
    at_ = again ? at_ : at;
}

void Selection::step(int by) {
    if (!surfaces_.empty()) {
        const auto count = static_cast<std::ptrdiff_t>(surfaces_.size());
        const auto wanted = (static_cast<std::ptrdiff_t>(index_) + by) % count;
        index_ = static_cast<std::size_t>(wanted < 0 ? wanted + count : wanted);
    }
}

}  // namespace ui
