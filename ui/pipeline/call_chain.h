// The calls that made a leaf, from the top of the file down to its shape.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/scad.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/model.h"

namespace ui {

/// A step of the way down to a leaf.
struct CallStep {
    const csg::Node& node;
    const csg::Statement* statement;  ///< Null where no call is known.
    std::uint32_t child, children;    ///< Which child of the step before, of how many.
};

/// From the root's children down; the root itself is nothing that was written. None of csg::kNoOccurrence. The steps
/// refer to the model's tree.
[[nodiscard]] std::vector<CallStep> steps_to(const Model& model, csg::OccurrenceId occurrence);

/// The occurrence in another model to which the same calls lead, at the same places of the text; kNoOccurrence where
/// there is none.
[[nodiscard]] csg::OccurrenceId occurrence_like(const Model& model, csg::OccurrenceId occurrence, const Model& other);

/// What the last step calls; "section" of leaves that cut, "leaf" where nothing is known.
[[nodiscard]] std::string_view shape_of(const csg::LeafInstance& leaf, const std::vector<CallStep>& steps);

/// file:line:column
[[nodiscard]] std::string place_of(const Model& model, const csg::SourceLocation& where);

/// The call as it is written, on one line and not too long. `sources`: of the program that made the model.
[[nodiscard]] std::string call_text(const Model& model, const csg::scad::SourceSet& sources, const CallStep& step);

/// Where a call stands.
struct CallPlace {
    std::shared_ptr<const csg::scad::SourceFile> text;
    csg::scad::SourceRange range;  ///< Its `file` is of `sources`.
};
/// Nothing where the text is not known.
[[nodiscard]] std::optional<CallPlace> call_place(const Model& model, const csg::scad::SourceSet& sources,
                                                  const CallStep& step);

/// A line for each step, indented.
[[nodiscard]] std::string calls_text(const Model& model, const csg::scad::SourceSet& sources,
                                     const std::vector<CallStep>& steps);

/// {"name": …, "module": …, "file": …, "line": …, "column": …, "begin": …, "end": …, "child": …, "of": …}
[[nodiscard]] Json call_json(const Model& model, const csg::scad::SourceSet& sources, const CallStep& step);

}  // namespace ui
