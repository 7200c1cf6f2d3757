#include "ui/pipeline/editable_model.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "ui/pipeline/model_parts.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

glm::dmat4 HeldPart::motion() const {
    glm::dmat4 moved = glm::translate(glm::dmat4(1.0), by);
    const double angle = glm::length(turn);
    const bool scaled = scale != glm::dvec3(1.0);
    if (!(angle > 0) && !scaled) {
        return moved;
    }
    moved = glm::translate(moved, pivot);
    if (angle > 0) {
        moved = glm::rotate(moved, glm::radians(angle), turn / angle);
    }
    if (scaled) {
        const glm::dmat3 sizes(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z);
        moved = moved * glm::dmat4(axes * sizes * glm::inverse(axes));
    }
    return glm::translate(moved, -pivot);
}

EditableModel::EditableModel(const Model& model, const goldfeather::Budget& budget)
    : budget_(budget),
      model_(model),
      scene_(model_.scene, model_.geometry),
      failures_(model.failures),
      part_boxes_(model.scene.parts.size()),
      over_budget_(model.scene.parts.size()) {
    model_.generation = next_generation();
    for (const csg::solid::PlacedLeaf& leaf : model_.geometry.leaves) {
        boxes_.push_back(leaf.box);
    }
    for (csg::PartId part = 0; part < part_boxes_.size(); ++part) {
        for (const goldfeather::Product& product : model_.products[part]) {
            part_boxes_[part] = csg::enclose(part_boxes_[part], product.box);
        }
        if (model_.products[part].empty()) {
            normalize(part);
        }
    }
}

void EditableModel::normalize(csg::PartId part) {
    ModelStatistics ignored;
    PartProducts made = products_of(model_, model_.scene.parts[part], boxes_, budget_, ignored);
    model_.products[part] = std::move(made.products);
    part_boxes_[part] = made.box;
    over_budget_[part] = std::move(made.over_budget);
}

csg::solid::SceneChange EditableModel::commit() {
    Stopwatch watch;
    csg::solid::SceneChange change = scene_.commit();
    model_.statistics.place_ms = watch.lap();
    if (change.structure) {
        boxes_.resize(model_.geometry.leaves.size());
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            boxes_[i] = model_.geometry.leaves[i].box;
        }
        for (csg::PartId part = 0; part < part_boxes_.size(); ++part) {
            normalize(part);
        }
    } else {
        for (const csg::LeafId leaf : change.leaves) {
            boxes_[leaf] = model_.geometry.leaves[leaf].box;
        }
        for (const csg::PartId part : change.parts) {
            normalize(part);
        }
    }
    model_.box = {};
    model_.over_budget.clear();
    for (csg::PartId part = 0; part < part_boxes_.size(); ++part) {
        model_.box = csg::enclose(model_.box, part_boxes_[part]);
        if (!over_budget_[part].empty()) {
            model_.over_budget = over_budget_[part];
        }
    }
    model_.failures = failures_;
    model_.failures.insert(model_.failures.end(), change.failures.begin(), change.failures.end());
    model_.statistics.normalize_ms = watch.lap();
    return change;
}

}  // namespace ui
