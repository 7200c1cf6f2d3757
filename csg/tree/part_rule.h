// What is a part of a model.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace csg {

/// Which pieces of the solid are parts of their own. The union of all parts is the solid: each surface of the scene is
/// of one part, and where two parts touch both have one there. `%` and `#` subtrees are parts in any case, and so is
/// what has a color that is seen through, wherever it is added: below a first operand it is divided from the rest as
/// below.
///
/// Where a difference or an intersection is divided, its first operand is, and each part has copies of the others: of
/// `(a ∪ b) − c` the parts are `a − c` and `b − c`. That is done through at most kMostShared of them above each other.
struct PartRule {
    enum class Kind : std::uint8_t {
        Model,   ///< The whole solid is one.
        Depth,   ///< What is left after `depth` divisions from the root down: of each union into its children (those of
                 ///< one child do not count), of each difference and each intersection into those of its first operand.
        Color,   ///< What has one color is one part. A difference has that of its first operand.
        Module,  ///< Each instantiation of one of the `modules`; the rest is one more.
    };
    static constexpr unsigned kMostShared = 64;

    Kind kind = Kind::Model;
    unsigned depth = 1;                ///< 1: the children of the top-level union.
    std::vector<std::string> modules;  ///< User-defined.
    bool operator==(const PartRule&) const = default;
};

}  // namespace csg
