#include "ui/command_line/compare_versions.h"

#include <fmt/format.h>

#include "csg/tree/changes.h"
#include "ui/command_line/compare_input.h"
#include "ui/command_line/files.h"
#include "ui/pipeline/comparison/solid_of_tree.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

Json to_json(const MeasuredSolid& piece) {
    const auto array = [](const glm::dvec3& v) { return Json{v.x, v.y, v.z}; };
    return {{"volume", piece.volume},
            {"box", piece.box.empty() ? Json(nullptr) : Json{array(piece.box.lo), array(piece.box.hi)}}};
}

std::string line_of(const char* name, const MeasuredSolid& piece) {
    const auto& [lo, hi] = piece.box;
    return piece.box.empty()
               ? fmt::format("{:<8} nothing\n", name)
               : fmt::format("{:<8} {:.6g}, within [{:.6g}, {:.6g}, {:.6g}] and [{:.6g}, {:.6g}, {:.6g}]\n", name,
                             piece.volume, lo.x, lo.y, lo.z, hi.x, hi.y, hi.z);
}

}  // namespace

int compare_versions(const CompareOptions& o) {
    CompareOptions other = o;
    other.input = o.later;
    const auto before = evaluate(o, false).tree, after = evaluate(other, false).tree;
    csg::Versions changed = csg::versions(*before, *after);
    const MeasuredSolid added = solid_of(std::move(changed.added), o.stop),
                        removed = solid_of(std::move(changed.removed), o.stop);
    const bool same = added.box.empty() && removed.box.empty();
    if (o.json) {
        write_output("-", text_of(Json{{"before", o.input},
                                       {"after", o.later},
                                       {"same", same},
                                       {"added", to_json(added)},
                                       {"removed", to_json(removed)}}));
    } else {
        write_output("-", printable(fmt::format("{} and {} {}\n", o.input, o.later,
                                                same ? "are the same solid" : "differ; volumes are") +
                                    (same ? "" : line_of("added", added) + line_of("removed", removed))));
    }
    return same ? 0 : 1;
}

}  // namespace ui
