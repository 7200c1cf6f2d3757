#include "ui/pipeline/call_chain.h"

#include <algorithm>

#include <fmt/format.h>

#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

constexpr std::size_t kWidestCall = 48;  ///< Characters of a call that are shown.

std::string_view name_of(csg::Operation operation) {
    static constexpr std::string_view kNames[]{"group",     "union", "difference", "intersection",
                                               "transform", "color", "leaf",       "mesh"};
    return kNames[static_cast<std::size_t>(operation)];
}

std::string_view name_of(const CallStep& step) {
    return step.statement != nullptr ? std::string_view(step.statement->name) : name_of(step.node.operation);
}

bool is_loop(const CallStep& step) {
    const std::string_view name = name_of(step);
    return name == "for" || name == "intersection_for";
}

/// The text that holds the step's call, in `sources`; none where it is not known.
std::optional<std::uint32_t> source_of(const Model& model, const csg::scad::SourceSet& sources, const CallStep& step) {
    if (step.statement == nullptr) {
        return std::nullopt;
    }
    const std::string& name = model.tree->files()[step.node.where.file];
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
        if (sources[i].name() == name) {
            return i;
        }
    }
    return std::nullopt;
}

/// Of its call, in the text of `source`.
csg::scad::ByteRange bytes_of(const CallStep& step, const csg::scad::SourceFile& source) {
    const csg::Statement& s = *step.statement;
    return {source.offset(s.where.line, s.where.column), source.offset(s.end_line, s.end_column)};
}

}  // namespace

std::vector<CallStep> steps_to(const Model& model, csg::OccurrenceId occurrence) {
    std::vector<CallStep> steps;
    if (occurrence == csg::kNoOccurrence) {
        return steps;
    }
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

csg::OccurrenceId occurrence_like(const Model& model, csg::OccurrenceId occurrence, const Model& other) {
    const std::vector<CallStep> wanted = steps_to(model, occurrence);
    const auto same = [&](const CallStep& a, const CallStep& b) {
        return a.child == b.child && a.node.where.line == b.node.where.line &&
               a.node.where.column == b.node.where.column &&
               model.tree->files()[a.node.where.file] == other.tree->files()[b.node.where.file];
    };
    for (csg::OccurrenceId id = 0; !wanted.empty() && id < other.scene.occurrences.size(); ++id) {
        const csg::SourceLocation& where = other.tree->node(other.scene.occurrences[id].node).where;
        if (where.line != wanted.back().node.where.line || where.column != wanted.back().node.where.column) {
            continue;
        }
        const std::vector<CallStep> steps = steps_to(other, id);
        if (std::equal(wanted.begin(), wanted.end(), steps.begin(), steps.end(), same)) {
            return id;
        }
    }
    return csg::kNoOccurrence;
}

std::string_view shape_of(const csg::LeafInstance& leaf, const std::vector<CallStep>& steps) {
    return leaf.hatching != 0 ? "section" : steps.empty() ? "leaf" : name_of(steps.back());
}

std::string place_of(const Model& model, const csg::SourceLocation& where) {
    return fmt::format("{}:{}:{}", model.tree->files()[where.file], where.line, where.column);
}

std::string call_text(const Model& model, const csg::scad::SourceSet& sources, const CallStep& step) {
    const csg::Modifiers& modifiers = step.node.modifiers;
    std::string text = modifiers.background ? "%" : modifiers.highlight ? "#" : modifiers.root ? "!" : "";
    if (step.statement == nullptr) {
        return text + std::string(name_of(step));
    }
    const auto source = source_of(model, sources, step);
    if (!source) {
        return text + step.statement->name;
    }
    const csg::scad::ByteRange bytes = bytes_of(step, sources[*source]);
    const auto written = std::string_view(sources[*source].text()).substr(bytes.begin, bytes.end - bytes.begin);
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

std::optional<CallPlace> call_place(const Model& model, const csg::scad::SourceSet& sources, const CallStep& step) {
    const auto source = source_of(model, sources, step);
    if (!source) {
        return std::nullopt;
    }
    const csg::Statement& s = *step.statement;
    return CallPlace{sources.shared(*source), {*source, s.where.line, s.where.column, s.end_line, s.end_column}};
}

std::string calls_text(const Model& model, const csg::scad::SourceSet& sources, const std::vector<CallStep>& steps) {
    std::string out;
    std::vector<std::string> calls;
    std::size_t widest = 0;
    for (const CallStep& step : steps) {
        calls.push_back(call_text(model, sources, step));
        widest = std::max(widest, character_count(calls.back()));
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        out += fmt::format("     {}{}  {}", calls[i], std::string(widest - character_count(calls[i]), ' '),
                           place_of(model, steps[i].node.where));
        if (is_loop(steps[i]) && i + 1 < steps.size()) {
            out += fmt::format("  (child {} of {})", steps[i + 1].child + 1, steps[i + 1].children);
        }
        out += '\n';
    }
    return out;
}

Json call_json(const Model& model, const csg::scad::SourceSet& sources, const CallStep& step) {
    const auto source = source_of(model, sources, step);
    Json begin = nullptr, end = nullptr;  // In the file, whose byte order mark is no part of the text.
    if (source) {
        const csg::scad::SourceFile& file = sources[*source];
        const csg::scad::ByteRange bytes = bytes_of(step, file);
        begin = file.mark_bytes() + bytes.begin;
        end = file.mark_bytes() + bytes.end;
    }
    return {{"name", name_of(step)},
            {"module", step.statement != nullptr && step.statement->user_module},
            {"file", model.tree->files()[step.node.where.file]},
            {"line", step.node.where.line},
            {"column", step.node.where.column},
            {"begin", begin},
            {"end", end},
            {"child", step.child},
            {"of", step.children}};
}

}  // namespace ui
