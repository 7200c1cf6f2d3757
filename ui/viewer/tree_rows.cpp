#include "ui/viewer/tree_rows.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

namespace ui {

namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

TreeRow row_of(const Model& model, const csg::scad::SourceSet& sources, csg::OccurrenceId id, int depth) {
    const csg::Occurrence& occurrence = model.scene.occurrences[id];
    const csg::Node& node = model.tree->node(occurrence.node);
    const CallStep step{node, model.tree->statement(occurrence.node), occurrence.child, 1};
    const std::string& file = model.tree->files()[node.where.file];
    TreeRow row;
    row.occurrence = id;
    row.depth = depth;
    row.call = call_text(model, sources, step);
    row.place = fmt::format("{}:{}", std::filesystem::path(file).filename().string(), node.where.line);
    row.at = {step.statement != nullptr ? step.statement->name : "", file, node.where.line, node.where.column};
    if (auto place = call_place(model, sources, step)) {
        row.text = {std::move(place->text), place->range};
    }
    return row;
}

}  // namespace

std::vector<TreeRow> tree_rows(const Model& model, const csg::scad::SourceSet& sources, std::size_t most) {
    const csg::Scene& scene = model.scene;
    std::vector<std::vector<csg::OccurrenceId>> below(scene.occurrences.size());
    std::vector<csg::OccurrenceId> tops;
    for (csg::OccurrenceId id = 0; id < scene.occurrences.size(); ++id) {
        const csg::OccurrenceId parent = scene.occurrences[id].parent;
        (parent == csg::kNoOccurrence ? tops : below[parent]).push_back(id);
    }
    for (auto& each : below) {
        std::stable_sort(each.begin(), each.end(), [&](csg::OccurrenceId a, csg::OccurrenceId b) {
            return scene.occurrences[a].child < scene.occurrences[b].child;
        });
    }
    // Without recursion: trees are as deep as programs make them. A row that is left is where its end is known.
    struct Visit {
        csg::OccurrenceId occurrence;
        int depth;
        std::optional<std::size_t> ends;  ///< The row of that occurrence, whose end this is.
    };
    std::vector<TreeRow> rows;
    std::vector<Visit> stack;
    for (auto top = tops.rbegin(); top != tops.rend(); ++top) {
        stack.push_back({*top, 0, {}});
    }
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (visit.ends) {
            rows[*visit.ends].end = rows.size();
            continue;
        }
        const bool written = model.tree->node(scene.occurrences[visit.occurrence].node).where.known();
        if (written && rows.size() < most) {
            stack.push_back({visit.occurrence, 0, rows.size()});
            rows.push_back(row_of(model, sources, visit.occurrence, visit.depth));
        }
        const auto& children = below[visit.occurrence];
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            stack.push_back({*child, visit.depth + (written ? 1 : 0), {}});
        }
    }
    std::vector<std::optional<csg::Rgba>> colors(scene.occurrences.size());
    for (const csg::LeafInstance& leaf : scene.leaves) {
        if (leaf.occurrence < colors.size() && leaf.color.given()) {
            colors[leaf.occurrence] = leaf.color;
        }
    }
    for (TreeRow& row : rows) {
        row.color = colors[row.occurrence];
    }
    return rows;
}

std::vector<char> filtered(const std::vector<TreeRow>& rows, std::string_view text) {
    const std::string wanted = lower(std::string(text));
    std::vector<char> shown(rows.size(), 0);
    std::vector<std::size_t> above;  // The row and those above it.
    for (std::size_t i = 0; i < rows.size(); ++i) {
        while (!above.empty() && rows[above.back()].end <= i) {
            above.pop_back();
        }
        above.push_back(i);
        if (lower(rows[i].call + " " + rows[i].place).find(wanted) != std::string::npos) {
            for (const std::size_t each : above) {
                shown[each] = 1;
            }
        }
    }
    return shown;
}

}  // namespace ui
