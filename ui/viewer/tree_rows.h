// The occurrences of a model as rows of a tree.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/pipeline/call_chain.h"
#include "ui/viewer/call_at.h"
#include "ui/viewer/text_place.h"

namespace ui {

struct TreeRow {
    csg::OccurrenceId occurrence = csg::kNoOccurrence;
    int depth = 0;        ///< 0 at the top of the file.
    std::size_t end = 0;  ///< The rows below it end there.
    std::string call;     ///< As it is written, shortened.
    std::string place;    ///< "lid.scad:12"
    CallAt at;
    TextPlace text;                  ///< Its `text` is null where that is not known.
    std::optional<csg::Rgba> color;  ///< Of a leaf that has one.
};

/// In the order of the text, what is below a row behind it. No more than `most`. `sources`: of the program that made
/// the model.
[[nodiscard]] std::vector<TreeRow> tree_rows(const Model& model, const csg::scad::SourceSet& sources,
                                             std::size_t most = 20'000);

/// By row: is it to be shown where only what has `text` in its call or place is wanted, with the rows above it? Small
/// and capital letters count as the same.
[[nodiscard]] std::vector<char> filtered(const std::vector<TreeRow>& rows, std::string_view text);

}  // namespace ui
