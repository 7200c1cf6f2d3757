// A model that is changed in place: a section moves, a part is dragged or hidden, a cutter is held to it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/solid/editable_scene.h"
#include "ui/pipeline/model.h"

namespace ui {

/// A side of the box that a leaf has in its own coordinates, which a hand has moved outwards.
struct HeldSide {
    int axis = 0;  ///< 0 to 2.
    bool upper = true;
    double by = 0;  ///< World units.
    bool operator==(const HeldSide&) const = default;
};

/// What a hand holds: the leaves at and below an occurrence, and how far they are from where the text puts them.
struct HeldPart {
    csg::OccurrenceId occurrence = csg::kNoOccurrence;  ///< None: nothing is held.
    glm::dvec3 by{0.0};                                 ///< World units.
    /// A turn about the pivot, before it is moved: along the axis, as long as the angle in degrees.
    glm::dvec3 turn{0.0}, pivot{0.0};
    /// Before it is turned: sizes along these directions (the columns, of length 1), from the pivot.
    glm::dmat3 axes{1.0};
    glm::dvec3 scale{1.0};
    std::optional<HeldSide> side{};  ///< What the scale stands for, while nobody knows what the program makes of it.
    /// From where the text puts them to where they are held.
    [[nodiscard]] glm::dmat4 motion() const;
    [[nodiscard]] bool any() const { return occurrence != csg::kNoOccurrence; }
    bool operator==(const HeldPart&) const = default;
};

/// A copy of a model, with a generation of its own. Edit it by `scene()`, `commit()`, and tell every renderer that may
/// hold it what has changed (Renderer::update).
class EditableModel {
  public:
    explicit EditableModel(const Model& model, const goldfeather::Budget& budget = {});

    /// As of the last commit. Of the statistics only the times are those of the commit; counts are of the model before.
    [[nodiscard]] const Model& model() const { return model_; }
    [[nodiscard]] csg::solid::EditableScene& scene() { return scene_; }

    /// Brings the geometry, and products and boxes of the parts that have changed, up to date. Leaves that could not be
    /// placed are among the model's failures until the next commit.
    [[nodiscard]] csg::solid::SceneChange commit();

  private:
    void normalize(csg::PartId part);

    goldfeather::Budget budget_;
    Model model_;
    csg::solid::EditableScene scene_;
    std::vector<std::string> failures_;     ///< Of the model before.
    std::vector<csg::Box> boxes_;           ///< By leaf.
    std::vector<csg::Box> part_boxes_;      ///< By part.
    std::vector<std::string> over_budget_;  ///< By part: why it has no products.
};

}  // namespace ui
