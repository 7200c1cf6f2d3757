// What has changed from one version of a model to the next, part by part.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "csg/tree/part_rule.h"
#include "csg/tree/tree.h"
#include "ui/pipeline/comparison/solid_of_tree.h"

namespace ui {

struct PartChange {
    enum class Kind { Unchanged, Changed, New, Gone };
    Kind kind = Kind::Unchanged;
    std::string name;     ///< In the later version, where it has it.
    std::string was;      ///< In the earlier one, where it was called otherwise; else empty.
    MeasuredSolid added;  ///< Of a part that is new, all of it.
    MeasuredSolid removed;
};

/// "unchanged", "changed", "new", "gone".
[[nodiscard]] const char* name(PartChange::Kind kind);

/// In the order of the later version; what is gone comes last. Parts that are written alike and lie in the same place
/// are the same, whatever they are called; of the others those of one name. Only of these meshes are made, of their
/// differences. Throws ModelError where an object cannot be made, base::Stopped where `stop` asked for it.
[[nodiscard]] std::vector<PartChange> part_changes(const csg::Tree& before, const csg::Tree& after,
                                                   const csg::PartRule& rule, const std::stop_token& stop = {});

}  // namespace ui
