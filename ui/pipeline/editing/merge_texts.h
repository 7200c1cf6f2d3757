// Two edits of one text put together, statement by statement.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/source/source.h"

namespace ui {

/// Statements that both have changed, each in its own way.
struct MergeConflict {
    csg::scad::ByteRange bytes;  ///< Of the merged text: where `ours` stands.
    std::string base, ours, theirs;
    bool operator==(const MergeConflict&) const = default;
};

struct Merged {
    std::string text;                      ///< With what is ours where there is a conflict.
    std::vector<MergeConflict> conflicts;  ///< In the order of the text.
};

/// Three-way merge of what two have made of `base`. The units are those of statement_pieces(), whatever they are in.
/// What both have put in at one place is kept, theirs first; what both have changed alike is no conflict.
[[nodiscard]] Merged merged(std::string_view base, std::string_view ours, std::string_view theirs);

}  // namespace ui
