#include "ui/command_line/thin_places.h"

#include <cmath>

#include <fmt/format.h>

#include "ui/pipeline/call_chain.h"

namespace ui {

namespace {

std::string call(const Model& model, const csg::scad::SourceSet& sources, csg::OccurrenceId occurrence) {
    const std::vector<CallStep> steps = steps_to(model, occurrence);
    return steps.empty() ? "a leaf"
                         : fmt::format("{} {}", call_text(model, sources, steps.back()),
                                       place_of(model, steps.back().node.where));
}

}  // namespace

std::string thin_places_text(const Model& model, const csg::scad::SourceSet& sources, const ThicknessMap& map) {
    if (map.places.empty()) {
        return "no two opposite faces are to be seen\n";
    }
    std::string text;
    for (const ThinPlace& place : map.places) {
        const auto number = [](double value) { return fmt::format("{:.6g}", std::abs(value) < 1e-9 ? 0.0 : value); };
        const glm::dvec3& p = place.point;
        text += fmt::format("{} mm at [{}, {}, {}], part {}: {} and {}\n", number(place.value), number(p.x),
                            number(p.y), number(p.z), model.scene.parts[place.part].name,
                            call(model, sources, place.occurrence), call(model, sources, place.other_occurrence));
    }
    return text;
}

}  // namespace ui
