#include "ui/command_line/pick.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

std::string materials_text(const csg::Scene& scene, const std::vector<csg::PartId>& parts) {
    std::vector<std::string_view> names;
    for (const csg::PartId part : parts) {
        names.push_back(scene.parts[part].name);
    }
    return names.empty() ? "outside" : fmt::format("{}", fmt::join(names, " and "));
}

std::string color_text(const csg::Rgba& color) {
    return color.given() ? csg::color_name(color) : "no color";
}

Json materials_json(const csg::Scene& scene, const std::vector<csg::PartId>& parts) {
    Json names = Json::array();
    for (const csg::PartId part : parts) {
        names.push_back(scene.parts[part].name);
    }
    return names;
}

Json color_json(const csg::Rgba& color) {
    return color.given() ? Json(csg::color_name(color)) : Json(nullptr);
}

}  // namespace

std::string pick_text(const PickReport& report) {
    const csg::Scene& scene = report.model.scene;
    const std::size_t count = report.surfaces.size();
    std::string out =
        fmt::format("Behind pixel {},{} of {} × {}: {}\n", report.at.x, report.at.y, report.size.x, report.size.y,
                    count == 0 ? "nothing" : fmt::format("{} surface{}", count, count == 1 ? "" : "s"));
    const double scale = report.model.geometry.box.empty() ? 1 : report.model.geometry.box.diagonal();
    for (const PickedSurface& s : report.surfaces) {
        const csg::LeafInstance& leaf = scene.leaves[s.surface.leaf];
        const csg::Part& part = scene.parts[s.part];
        const std::vector<CallStep> steps = steps_to(report.model, s.occurrence);
        out += fmt::format("\n{:<3}{} away, at [{}, {}, {}]\n", s.layer + 1, number_text(s.distance, scale),
                           number_text(s.point.x, scale), number_text(s.point.y, scale), number_text(s.point.z, scale));
        out += fmt::format("   {} {} (leaf {}, {}), {}\n", s.surface.reversed ? "cut by" : "face of",
                           shape_of(leaf, steps), s.surface.leaf, s.surface.reversed ? "subtracts" : "adds",
                           color_text(leaf.color));
        out += fmt::format(
            "   part {}{}{}: from {} into {}\n", part.name,
            part.kind == csg::PartKind::Solid ? "" : fmt::format(" ({})", csg::name(part.kind)),
            part.color.given() && part.color != leaf.color ? fmt::format(", {}", csg::color_name(part.color)) : "",
            materials_text(scene, s.in_front), materials_text(scene, s.behind));
        out += calls_text(report.model, report.sources, steps);
    }
    return out;
}

Json pick_json(const PickReport& report) {
    const csg::Scene& scene = report.model.scene;
    Json surfaces = Json::array();
    for (const PickedSurface& s : report.surfaces) {
        const csg::LeafInstance& leaf = scene.leaves[s.surface.leaf];
        const csg::Part& part = scene.parts[s.part];
        const std::vector<CallStep> steps = steps_to(report.model, s.occurrence);
        Json calls = Json::array();
        for (const CallStep& step : steps) {
            calls.push_back(call_json(report.model, report.sources, step));
        }
        surfaces.push_back(
            {{"layer", s.layer + 1},
             {"distance", s.distance},
             {"point", to_json(s.point)},
             {"normal", to_json(s.normal)},
             {"leaf", s.surface.leaf},
             {"shape", shape_of(leaf, steps)},
             {"operation", s.surface.reversed ? "subtracts" : "adds"},
             {"leaving", s.surface.leaving},
             {"color", color_json(leaf.color)},
             {"part",
              {{"id", s.part}, {"name", part.name}, {"kind", csg::name(part.kind)}, {"color", color_json(part.color)}}},
             {"in_front", materials_json(scene, s.in_front)},
             {"behind", materials_json(scene, s.behind)},
             {"calls", calls}});
    }
    return {{"pixel", {report.at.x, report.at.y}},
            {"size", {report.size.x, report.size.y}},
            {"camera", to_json(report.camera)},
            {"surfaces", surfaces}};
}

}  // namespace ui
