#include "ui/command_line/pick.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

constexpr std::size_t kWidestCall = 48;  ///< Characters of a call that are shown.

/// A step of the way down to a leaf.
struct Step {
    const csg::Node& node;
    const csg::Statement* statement;  ///< Null where no call is known.
    std::uint32_t child, children;    ///< Which child of the step before, of how many.
};

/// From the root's children down; the root itself is nothing that was written.
std::vector<Step> steps_to(const Model& model, csg::OccurrenceId occurrence) {
    std::vector<Step> steps;
    for (const csg::OccurrenceId id : csg::path_to(model.scene, occurrence)) {
        const csg::Occurrence& o = model.scene.occurrences[id];
        const csg::Node& node = model.tree->node(o.node);
        if (node.where.known()) {
            const auto& parent = model.scene.occurrences[o.parent];
            steps.push_back({node, model.tree->statement(o.node), o.child, model.tree->node(parent.node).child_count});
        }
    }
    return steps;
}

std::string_view name_of(csg::Operation operation) {
    static constexpr std::string_view kNames[]{"group",     "union", "difference", "intersection",
                                               "transform", "color", "leaf",       "mesh"};
    return kNames[static_cast<std::size_t>(operation)];
}

std::string_view name_of(const Step& step) {
    return step.statement != nullptr ? std::string_view(step.statement->name) : name_of(step.node.operation);
}

std::string_view shape_of(const csg::LeafInstance& leaf, const std::vector<Step>& steps) {
    return leaf.hatching != 0 ? "section" : steps.empty() ? "leaf" : name_of(steps.back());
}

bool is_loop(const Step& step) {
    const std::string_view name = name_of(step);
    return name == "for" || name == "intersection_for";
}

std::string place_of(const Model& model, const csg::SourceLocation& where) {
    return fmt::format("{}:{}:{}", model.tree->files()[where.file], where.line, where.column);
}

/// The text that holds the step's call; null where it is not known.
const csg::scad::SourceFile* source_of(const PickReport& report, const Step& step) {
    if (step.statement == nullptr) {
        return nullptr;
    }
    const std::string& name = report.model.tree->files()[step.node.where.file];
    for (std::uint32_t i = 0; i < report.sources.size(); ++i) {
        if (report.sources[i].name() == name) {
            return &report.sources[i];
        }
    }
    return nullptr;
}

/// Of its call, in the text of `source`.
csg::scad::ByteRange bytes_of(const Step& step, const csg::scad::SourceFile& source) {
    const csg::Statement& s = *step.statement;
    return {source.offset(s.where.line, s.where.column), source.offset(s.end_line, s.end_column)};
}

/// The call as it is written, on one line and not too long.
std::string call_text(const PickReport& report, const Step& step) {
    const csg::Modifiers& modifiers = step.node.modifiers;
    std::string text = modifiers.background ? "%" : modifiers.highlight ? "#" : modifiers.root ? "!" : "";
    if (step.statement == nullptr) {
        return text + std::string(name_of(step));
    }
    const csg::scad::SourceFile* const source = source_of(report, step);
    if (source == nullptr) {
        return text + step.statement->name;
    }
    const csg::scad::ByteRange bytes = bytes_of(step, *source);
    const auto written = std::string_view(source->text()).substr(bytes.begin, bytes.end - bytes.begin);
    bool blank = false;
    std::size_t characters = text.size();
    for (const char c : written) {
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
            blank = true;
            continue;
        }
        if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {  // A character begins.
            characters += blank ? 2 : 1;
            if (characters >= kWidestCall) {
                return text + "…";
            }
        }
        text += blank ? " " : "";
        text += c;
        blank = false;
    }
    return text;
}

/// With six digits; what is but rounding is 0.
std::string number_text(double value, double scale) {
    return fmt::format("{:.6g}", std::abs(value) < 1e-9 * scale ? 0.0 : value);
}

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

Json to_json(const PickReport& report, const Step& step) {
    const csg::scad::SourceFile* const source = source_of(report, step);
    Json begin = nullptr, end = nullptr;  // In the file, whose byte order mark is no part of the text.
    if (source != nullptr) {
        const csg::scad::ByteRange bytes = bytes_of(step, *source);
        begin = source->mark_bytes() + bytes.begin;
        end = source->mark_bytes() + bytes.end;
    }
    return {{"name", name_of(step)},
            {"module", step.statement != nullptr && step.statement->user_module},
            {"file", report.model.tree->files()[step.node.where.file]},
            {"line", step.node.where.line},
            {"column", step.node.where.column},
            {"begin", begin},
            {"end", end},
            {"child", step.child},
            {"of", step.children}};
}

void append_calls(const PickReport& report, const std::vector<Step>& steps, std::string& out) {
    std::vector<std::string> calls;
    std::size_t widest = 0;
    for (const Step& step : steps) {
        calls.push_back(call_text(report, step));
        widest = std::max(widest, character_count(calls.back()));
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        out += fmt::format("     {}{}  {}", calls[i], std::string(widest - character_count(calls[i]), ' '),
                           place_of(report.model, steps[i].node.where));
        if (is_loop(steps[i]) && i + 1 < steps.size()) {
            out += fmt::format("  (child {} of {})", steps[i + 1].child + 1, steps[i + 1].children);
        }
        out += '\n';
    }
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
        const std::vector<Step> steps = steps_to(report.model, s.occurrence);
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
        append_calls(report, steps, out);
    }
    return out;
}

Json pick_json(const PickReport& report) {
    const csg::Scene& scene = report.model.scene;
    Json surfaces = Json::array();
    for (const PickedSurface& s : report.surfaces) {
        const csg::LeafInstance& leaf = scene.leaves[s.surface.leaf];
        const csg::Part& part = scene.parts[s.part];
        const std::vector<Step> steps = steps_to(report.model, s.occurrence);
        Json calls = Json::array();
        for (const Step& step : steps) {
            calls.push_back(to_json(report, step));
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
