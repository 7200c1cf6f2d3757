// Models with parts of them cut away (npr/section.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/camera.h"
#include "npr/section.h"
#include "ui/pipeline/editable_model.h"

namespace ui {

/// Cuts the parts of a scene that is not yet placed by the parts that sections name, and hides these. Throws ModelError
/// with the nearest names where there is no such part, here or among those that stay whole.
void cut_by_parts(csg::Scene& scene, const npr::Sections& sections);

/// Gives each part that was cut so a hatching other than those of the parts next to it, once they are placed.
void set_hatchings(Model& model, const npr::Sections& sections);

/// The same sections, of which no camera and no model need be known any more: the sides of planes are told, corners are
/// boxes. `box`: of the model. What is that already stays as it is.
[[nodiscard]] npr::Sections resolved(npr::Sections sections, const csg::Box& box, const base::Camera& camera);

/// Sections that miss the model, or leave nothing of it; they are resolved.
[[nodiscard]] std::vector<std::string> section_warnings(const Model& model, const npr::Sections& sections);

/// A model and what sections by planes and boxes leave of it: each part but those that stay whole, less a half-space or
/// a box, whose faces have the part's color and a hatching other than that of the parts next to it. What a hand holds
/// lies where it is held.
class SectionedModel {
  public:
    /// `sections` are resolved. The model itself where they cut nothing and nothing is held; it stays valid until the
    /// next call. Where only planes, or what is held, have moved since the last call, so do their leaves
    /// (Renderer::update is to be told `change`).
    const Model& cut(const std::shared_ptr<const Model>& model, const npr::Sections& sections,
                     const HeldPart& held = {});

    /// Of the last call; empty where nothing has, or where all is another model.
    [[nodiscard]] const csg::solid::SceneChange& change() const { return change_; }

  private:
    void make(const npr::Sections& sections);
    void add(const npr::Section& section, const std::vector<char>& cut, const std::vector<std::uint8_t>& hatching);
    bool move(const npr::Sections& sections, const HeldPart& held);
    void hold(const HeldPart& held);

    std::shared_ptr<const Model> whole_;
    npr::Sections sections_;
    HeldPart held_;
    std::unique_ptr<EditableModel> made_;
    std::vector<std::vector<csg::solid::AddedId>> added_;  ///< By section.
    csg::solid::SceneChange change_;
};

}  // namespace ui
