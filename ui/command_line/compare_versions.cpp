#include "ui/command_line/compare_versions.h"

#include <fmt/format.h>

#include "csg/tree/changes.h"
#include "ui/command_line/compare_input.h"
#include "ui/command_line/compare_table.h"
#include "ui/command_line/files.h"
#include "ui/pipeline/comparison/part_changes.h"
#include "ui/pipeline/comparison/solid_of_tree.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

Json to_json(const MeasuredSolid& piece) {
    return {{"volume", piece.volume},
            {"box", piece.box.empty() ? Json(nullptr) : Json{ui::to_json(piece.box.lo), ui::to_json(piece.box.hi)}}};
}

std::string line_of(const char* name, const MeasuredSolid& piece) {
    const auto& [lo, hi] = piece.box;
    return piece.box.empty()
               ? fmt::format("{:<8} nothing\n", name)
               : fmt::format("{:<8} {:.6g}, within [{:.6g}, {:.6g}, {:.6g}] and [{:.6g}, {:.6g}, {:.6g}]\n", name,
                             piece.volume, lo.x, lo.y, lo.z, hi.x, hi.y, hi.z);
}

Json to_json(const PartChange& part) {
    return {{"part", part.name},
            {"was", part.was.empty() ? Json(nullptr) : Json(part.was)},
            {"change", name(part.kind)},
            {"added", to_json(part.added)},
            {"removed", to_json(part.removed)}};
}

/// A line for each part, where there are several.
std::string parts_table(const std::vector<PartChange>& parts) {
    if (parts.size() < 2) {
        return "";
    }
    std::vector<std::vector<std::string>> rows{{"part", "", "added", "removed"}};
    for (const PartChange& part : parts) {
        const auto volume = [](const MeasuredSolid& piece) {
            return piece.box.empty() ? std::string("-") : fmt::format("{:.6g}", piece.volume);
        };
        rows.push_back({part.was.empty() ? part.name : fmt::format("{} (was {})", part.name, part.was), name(part.kind),
                        volume(part.added), volume(part.removed)});
    }
    return '\n' + aligned(rows);
}

}  // namespace

int compare_versions(const CompareOptions& o) {
    CompareOptions other = o;
    other.input = o.later;
    const auto before = evaluate(o, false).tree, after = evaluate(other, false).tree;
    const MeasuredSolid added = solid_of(csg::less(*after, *before), o.stop),
                        removed = solid_of(csg::less(*before, *after), o.stop);
    const std::vector<PartChange> parts = part_changes(*before, *after, o.parts, o.stop);
    const bool same = added.box.empty() && removed.box.empty();
    if (o.json) {
        Json by_part = Json::array();
        for (const PartChange& part : parts) {
            by_part.push_back(to_json(part));
        }
        write_output("-", text_of(Json{{"before", o.input},
                                       {"after", o.later},
                                       {"same", same},
                                       {"added", to_json(added)},
                                       {"removed", to_json(removed)},
                                       {"parts", by_part}}));
    } else {
        write_output(
            "-", printable(fmt::format("{} and {} {}\n", o.input, o.later,
                                       same ? "are the same solid" : "differ; volumes are") +
                           (same ? "" : line_of("added", added) + line_of("removed", removed)) + parts_table(parts)));
    }
    return same ? 0 : 1;
}

}  // namespace ui
