#include "ui/pipeline/sections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/matrix_transform.hpp>

#include "csg/solid/cut_box.h"
#include "csg/tree/scene_edit.h"
#include "ui/pipeline/infinity.h"
#include "ui/pipeline/part_names.h"

namespace ui {

namespace {

using csg::solid::Plane;

constexpr std::uint8_t kHatchings = 6;  ///< That npr/section_lines.glsl knows.

/// By part: 1 where sections cut it, but that parts that cut others stay themselves.
std::vector<char> cut_parts(const csg::Scene& scene, const npr::Sections& sections) {
    std::vector<char> cut;
    for (const csg::Part& part : scene.parts) {
        cut.push_back(part.hidden ? 0 : 1);
    }
    for (const std::string& name : sections.uncut) {
        for (const csg::PartId id : parts_named(scene, "--uncut", name)) {
            cut[id] = 0;
        }
    }
    return cut;
}

/// From the middle of the model to the eye.
glm::dvec3 to_eye(const csg::Box& box, const base::Camera& camera) {
    if (camera.projection == base::Projection::Perspective) {
        return camera.eye() - box.center();
    }
    return glm::transpose(glm::dmat3(camera.eye_from_world())) * glm::dvec3(0, 0, 1);
}

npr::PlaneSection without_eye(npr::PlaneSection section, const csg::Box& box, const base::Camera& camera) {
    if (section.away == npr::PlaneSection::Away::Eye) {
        const double side = camera.projection == base::Projection::Perspective
                                ? glm::dot(section.normal, camera.eye()) - section.offset
                                : glm::dot(section.normal, to_eye(box, camera));
        if (side < 0) {
            section.normal = -section.normal;
            section.offset = -section.offset;
        }
        section.away = npr::PlaneSection::Away::Beyond;
    }
    return section;
}

npr::BoxSection corner(const npr::CornerSection& section, const csg::Box& box, const base::Camera& camera) {
    const glm::dvec3 middle = box.center(), eye = to_eye(box, camera);
    const bool along_x = std::abs(eye.x) > std::abs(eye.y);
    const bool cut[3]{section.axes > 1 || along_x, section.axes > 1 || !along_x, section.axes > 2};
    npr::BoxSection region{glm::dvec3(-kInfinity), glm::dvec3(kInfinity)};
    for (int axis = 0; axis < 3; ++axis) {
        if (cut[axis]) {
            (eye[axis] >= 0 ? region.lo : region.hi)[axis] = middle[axis];
        }
    }
    return region;
}

/// What is cut away: points p with dot(normal, p) ≤ offset.
Plane half_space(const npr::PlaneSection& section) {
    return {-section.normal, -section.offset};
}

/// Largest and least of dot(normal, p) - offset over the box.
std::pair<double, double> sides(const Plane& plane, const csg::Box& box) {
    const glm::dvec3 half = 0.5 * box.size();
    const double middle = glm::dot(plane.normal, box.center()) - plane.offset;
    const double reach = glm::dot(glm::abs(plane.normal), half);
    return {middle - reach, middle + reach};
}

std::string warning_of(const npr::Section& section, const csg::Box& box) {
    bool misses = false, takes_all = false;
    if (const auto* plane = std::get_if<npr::PlaneSection>(&section.cut)) {
        const auto [least, most] = sides(half_space(*plane), box);
        misses = least >= 0;
        takes_all = most <= 0;
    } else if (const auto* region = std::get_if<npr::BoxSection>(&section.cut)) {
        const csg::Box cut{region->lo, region->hi};
        misses = !csg::overlap(cut, box);
        takes_all = csg::enclose(cut, box) == cut;
    }
    if (misses) {
        return fmt::format("--section {}: it misses the model and cuts nothing away", section.text);
    }
    return takes_all ? fmt::format("--section {}: it cuts all of the model away", section.text) : "";
}

/// A box, without reaching farther beyond `scene` than it must.
std::shared_ptr<const csg::solid::Solid> box_solid(const csg::Box& box, const csg::Box& scene) {
    const glm::dvec3 room(0.02 * scene.diagonal());
    const csg::Box reached{glm::max(box.lo, scene.lo - room), glm::min(box.hi, scene.hi + room)};
    return csg::solid::cut_box(reached, {{0, 0, 1}, reached.hi.z + scene.diagonal()}).solid;
}

/// Boxes of the parts, as far as their leaves tell them.
std::vector<csg::Box> part_boxes(const Model& model) {
    std::vector<csg::Box> boxes;
    for (const csg::solid::PlacedLeaf& leaf : model.geometry.leaves) {
        boxes.push_back(leaf.box);
    }
    std::vector<csg::Box> of_parts;
    for (const csg::Part& part : model.scene.parts) {
        of_parts.push_back(csg::bounds(model.scene, part, boxes));
    }
    return of_parts;
}

/// By part: one that no cut part next to it has, as far as there are enough.
std::vector<std::uint8_t> hatchings(const Model& model, const std::vector<char>& cut) {
    const std::vector<csg::Box> boxes = part_boxes(model);
    std::vector<std::uint8_t> chosen(boxes.size(), 1);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        int taken[kHatchings + 1]{};
        for (std::size_t j = 0; j < i; ++j) {
            if (cut[j] != 0 && !csg::intersect(boxes[i], boxes[j]).empty()) {
                ++taken[chosen[j]];
            }
        }
        chosen[i] = static_cast<std::uint8_t>(std::min_element(taken + 1, taken + kHatchings + 1) - taken);
    }
    return chosen;
}

}  // namespace

void cut_by_parts(csg::Scene& scene, const npr::Sections& sections) {
    if (sections.cuts.empty()) {
        return;
    }
    std::vector<char> cut = cut_parts(scene, sections);
    std::vector<csg::PartId> tools;
    for (const npr::Section& section : sections.cuts) {
        const auto* by_part = std::get_if<npr::PartSection>(&section.cut);
        if (by_part == nullptr) {
            continue;
        }
        for (const csg::PartId id : parts_named(scene, "--section part", by_part->part)) {
            tools.push_back(id);
            cut[id] = 0;
            scene.parts[id].hidden = true;
        }
    }
    for (const csg::PartId tool : tools) {
        csg::subtract_part(scene, tool, cut);
    }
}

void set_hatchings(Model& model, const npr::Sections& sections) {
    if (sections.cuts.empty()) {
        return;
    }
    const std::vector<std::uint8_t> hatching = hatchings(model, cut_parts(model.scene, sections));
    for (csg::LeafInstance& leaf : model.scene.leaves) {
        if (leaf.hatching != 0) {
            leaf.hatching = hatching[leaf.part];
        }
    }
}

npr::Sections resolved(npr::Sections sections, const csg::Box& box, const base::Camera& camera) {
    for (npr::Section& section : sections.cuts) {
        if (auto* plane = std::get_if<npr::PlaneSection>(&section.cut)) {
            *plane = without_eye(*plane, box, camera);
        } else if (const auto* before = std::get_if<npr::CornerSection>(&section.cut)) {
            section.cut = corner(*before, box, camera);
        }
    }
    return sections;
}

std::vector<std::string> section_warnings(const Model& model, const npr::Sections& sections) {
    std::vector<std::string> warnings;
    for (const npr::Section& section : sections.cuts) {
        if (std::string warning = warning_of(section, model.box); !model.empty() && !warning.empty()) {
            warnings.push_back(std::move(warning));
        }
    }
    return warnings;
}

const Model& SectionedModel::cut(const std::shared_ptr<const Model>& model, const npr::Sections& sections,
                                 const HeldPart& held) {
    change_ = {};
    const npr::Sections wanted = sections.cuts.empty() || model->empty() ? npr::Sections{} : sections;
    // What was held and is let go is put back where it was: no other model is made for that.
    const bool same = made_ && model == whole_ && wanted.uncut == sections_.uncut && move(wanted, held);
    if (!same) {
        whole_ = model;
        added_.clear();
        made_.reset();
        held_ = {};
        if (!wanted.cuts.empty() || held.any()) {
            make(wanted);
            hold(held);
            (void)made_->commit();
        }
    }
    sections_ = wanted;
    return made_ ? made_->model() : *whole_;
}

void SectionedModel::make(const npr::Sections& sections) {
    const std::vector<char> cut = cut_parts(whole_->scene, sections);
    const std::vector<std::uint8_t> hatching = hatchings(*whole_, cut);
    made_ = std::make_unique<EditableModel>(*whole_);
    for (const npr::Section& section : sections.cuts) {
        add(section, cut, hatching);
    }
}

void SectionedModel::hold(const HeldPart& held) {
    const HeldPart before = std::exchange(held_, held);
    csg::solid::EditableScene& edited = made_->scene();
    if (before.any() && before.occurrence != held.occurrence) {
        edited.move_occurrence(before.occurrence, glm::dmat4(1.0));
    }
    if (held.any()) {
        edited.move_occurrence(held.occurrence, held.motion());
    }
}

void SectionedModel::add(const npr::Section& section, const std::vector<char>& cut,
                         const std::vector<std::uint8_t>& hatching) {
    const auto* const plane = std::get_if<npr::PlaneSection>(&section.cut);
    const auto* const region = std::get_if<npr::BoxSection>(&section.cut);
    const csg::Box& scene = whole_->geometry.box;
    const bool meets = region != nullptr && csg::overlap({region->lo, region->hi}, scene);
    const auto solid = meets ? box_solid({region->lo, region->hi}, scene) : nullptr;
    added_.emplace_back();
    for (csg::PartId id = 0; id < cut.size() && (plane != nullptr || meets); ++id) {
        if (cut[id] == 0) {
            continue;
        }
        const csg::Site site{id, csg::kNoOccurrence};
        const csg::solid::AddedLook look{whole_->scene.parts[id].color, hatching[id]};
        constexpr auto kSubtracted = csg::ExpressionKind::Difference;
        csg::solid::EditableScene& edited = made_->scene();
        added_.back().push_back(plane != nullptr ? edited.add(site, kSubtracted, half_space(*plane), look)
                                                 : edited.add(site, kSubtracted, solid, glm::dmat4(1.0), look));
    }
}

/// False where more is to be done than to move planes and what is held.
bool SectionedModel::move(const npr::Sections& sections, const HeldPart& held) {
    const auto planes = [](const npr::Section& section) {
        return std::holds_alternative<npr::PlaneSection>(section.cut);
    };
    if (sections.cuts.size() != sections_.cuts.size()) {
        return false;
    }
    for (std::size_t i = 0; i < sections.cuts.size(); ++i) {
        const npr::Section &now = sections.cuts[i], &before = sections_.cuts[i];
        if (now.cut != before.cut && !(planes(now) && planes(before))) {
            return false;
        }
    }
    bool any = held != held_;
    if (any) {
        hold(held);
    }
    for (std::size_t i = 0; i < sections.cuts.size(); ++i) {
        if (sections.cuts[i].cut != sections_.cuts[i].cut) {
            for (const csg::solid::AddedId id : added_[i]) {
                made_->scene().move(id, half_space(std::get<npr::PlaneSection>(sections.cuts[i].cut)));
            }
            any = true;
        }
    }
    if (any) {
        change_ = made_->commit();
    }
    return true;
}

}  // namespace ui
