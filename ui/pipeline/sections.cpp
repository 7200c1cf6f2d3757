#include "ui/pipeline/sections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "csg/solid/cut_box.h"
#include "csg/tree/scene_edit.h"
#include "ui/pipeline/editable_model.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

using csg::solid::Plane;

constexpr std::uint8_t kHatchings = 6;  ///< That npr/section_lines.glsl knows.

/// "bolt" names the parts bolt, bolt 2, bolt 3, ….
bool is_named(const std::string& part, const std::string& name) {
    if (!part.starts_with(name)) {
        return false;
    }
    const std::string rest = part.substr(name.size());
    return rest.empty() ||
           (rest.size() > 1 && rest[0] == ' ' && rest.find_first_not_of("0123456789", 1) == std::string::npos);
}

[[noreturn]] void throw_unknown(const csg::Scene& scene, const char* option, const std::string& name) {
    std::vector<std::string> names;
    for (const csg::Part& part : scene.parts) {
        names.push_back(part.name);
    }
    constexpr std::size_t kMostNamed = 12;
    std::vector<std::string> shown = names;
    if (shown.size() > kMostNamed) {
        shown.resize(kMostNamed);
        shown.emplace_back("…");
    }
    throw ModelError(fmt::format("{}: no part \"{}\".{}", option, name,
                                 suggestion(name, names,
                                            fmt::format(" There {} {}; --parts says what is one.",
                                                        shown.size() == 1 ? "is" : "are", fmt::join(shown, ", ")))));
}

/// By part: 1 where sections cut it, but that parts that cut others stay themselves.
std::vector<char> cut_parts(const csg::Scene& scene, const npr::Sections& sections) {
    std::vector<char> cut;
    for (const csg::Part& part : scene.parts) {
        cut.push_back(part.hidden ? 0 : 1);
    }
    for (const std::string& name : sections.uncut) {
        bool known = false;
        for (csg::PartId id = 0; id < cut.size(); ++id) {
            if (is_named(scene.parts[id].name, name)) {
                cut[id] = 0;
                known = true;
            }
        }
        if (!known) {
            throw_unknown(scene, "--uncut", name);
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

/// A half-space or a box, one of which is cut away.
struct Tool {
    std::optional<Plane> half_space;  ///< Points p with dot(normal, p) ≤ offset.
    csg::Box box;
    std::string text;
};

Tool half_space(const npr::PlaneSection& section, const csg::Box& box, const base::Camera& camera) {
    Plane plane{section.normal, section.offset};
    bool beyond = true;
    if (section.away == npr::PlaneSection::Away::Eye) {
        const double side = camera.projection == base::Projection::Perspective
                                ? glm::dot(plane.normal, camera.eye()) - plane.offset
                                : glm::dot(plane.normal, to_eye(box, camera));
        beyond = side >= 0;
    }
    if (beyond) {
        plane = {-plane.normal, -plane.offset};
    }
    return {plane, {}, {}};
}

Tool corner(const npr::CornerSection& section, const csg::Box& box, const base::Camera& camera) {
    const glm::dvec3 middle = box.center(), eye = to_eye(box, camera);
    const bool along_x = std::abs(eye.x) > std::abs(eye.y);
    const bool open[3]{section.axes > 1 || along_x, section.axes > 1 || !along_x, section.axes > 2};
    Tool tool;
    for (int axis = 0; axis < 3; ++axis) {
        const bool up = eye[axis] >= 0;
        constexpr double kEverywhere = std::numeric_limits<double>::infinity();
        tool.box.lo[axis] = open[axis] && up ? middle[axis] : -kEverywhere;
        tool.box.hi[axis] = open[axis] && !up ? middle[axis] : kEverywhere;
    }
    return tool;
}

std::optional<Tool> tool_of(const npr::Section& section, const csg::Box& box, const base::Camera& camera) {
    std::optional<Tool> tool;
    if (const auto* plane = std::get_if<npr::PlaneSection>(&section.cut)) {
        tool = half_space(*plane, box, camera);
    } else if (const auto* region = std::get_if<npr::BoxSection>(&section.cut)) {
        tool = Tool{{}, {region->lo, region->hi}, {}};
    } else if (const auto* before = std::get_if<npr::CornerSection>(&section.cut)) {
        tool = corner(*before, box, camera);
    }
    if (tool) {
        tool->text = section.text;
    }
    return tool;
}

/// Largest and least of dot(normal, p) - offset over the box.
std::pair<double, double> sides(const Plane& plane, const csg::Box& box) {
    const glm::dvec3 half = 0.5 * box.size();
    const double middle = glm::dot(plane.normal, box.center()) - plane.offset;
    const double reach = glm::dot(glm::abs(plane.normal), half);
    return {middle - reach, middle + reach};
}

std::string warning_of(const Tool& tool, const csg::Box& box) {
    bool misses = false, takes_all = false;
    if (tool.half_space) {
        const auto [least, most] = sides(*tool.half_space, box);
        misses = least >= 0;
        takes_all = most <= 0;
    } else {
        misses = !csg::overlap(tool.box, box);
        takes_all = csg::enclose(tool.box, box) == tool.box;
    }
    if (misses) {
        return fmt::format("--section {}: it misses the model and cuts nothing away", tool.text);
    }
    return takes_all ? fmt::format("--section {}: it cuts all of the model away", tool.text) : "";
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
        const std::size_t before = tools.size();
        for (csg::PartId id = 0; id < scene.parts.size(); ++id) {
            if (is_named(scene.parts[id].name, by_part->part)) {
                tools.push_back(id);
                cut[id] = 0;
                scene.parts[id].hidden = true;
            }
        }
        if (tools.size() == before) {
            throw_unknown(scene, "--section part", by_part->part);
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

CutModel cut_away(const std::shared_ptr<const Model>& model, const npr::Sections& sections, const base::Camera& camera,
                  const goldfeather::Budget& budget) {
    if (sections.cuts.empty() || model->empty()) {
        return {model, {}};
    }
    const std::vector<char> cut = cut_parts(model->scene, sections);
    const std::vector<std::uint8_t> hatching = hatchings(*model, cut);
    const auto made = std::make_shared<EditableModel>(*model, budget);
    CutModel result{std::shared_ptr<const Model>(made, &made->model()), {}};
    for (const npr::Section& section : sections.cuts) {
        const std::optional<Tool> tool = tool_of(section, model->box, camera);
        if (!tool) {
            continue;  // By a part: the scene has it.
        }
        if (const std::string warning = warning_of(*tool, model->box); !warning.empty()) {
            result.warnings.push_back(warning);
        }
        for (csg::PartId id = 0; id < cut.size(); ++id) {
            const csg::Part& part = model->scene.parts[id];
            if (cut[id] == 0) {
                continue;
            }
            const csg::Site site{id, csg::kNoOccurrence};
            const csg::solid::AddedLook look{part.color, hatching[id]};
            if (tool->half_space) {
                (void)made->scene().add(site, csg::ExpressionKind::Difference, *tool->half_space, look);
            } else if (csg::overlap(tool->box, model->geometry.box)) {
                (void)made->scene().add(site, csg::ExpressionKind::Difference,
                                        box_solid(tool->box, model->geometry.box), glm::dmat4(1.0), look);
            }
        }
    }
    (void)made->commit();
    return result;
}

}  // namespace ui
