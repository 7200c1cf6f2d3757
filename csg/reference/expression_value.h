// The expressions of a scene's parts over sets of leaves.
#pragma once

#include <span>
#include <vector>

#include "csg/tree/scene.h"

namespace csg::reference {

/// The parts that are the model: solid and translucent ones.
[[nodiscard]] std::vector<PartId> solid_parts(const Scene& scene);

/// Evaluates the union of the solid parts where each leaf is entered or not, and tells whose a surface is.
class ExpressionValue {
  public:
    explicit ExpressionValue(const Scene& scene);

    /// `inside(leaf)`: is the point in the leaf? Keeps the values of all nodes for `owner`.
    template <typename Inside>
    bool evaluate(Inside&& inside) {
        bool any = false;
        for (const PartId part : parts_) {
            any |= csg::evaluate(scene_, scene_.parts[part], inside, scratch_);
            std::copy(scratch_.begin(), scratch_.end(), values_.begin() + scene_.parts[part].first_expression);
        }
        return any;
    }

    /// Of the sorted leaves that switch, the one whose surface it is (docs/ENGINES.md, "Whose surface it is"); the last
    /// evaluation must have been on the side where the solid is.
    [[nodiscard]] LeafId owner(std::span<const LeafId> switching);

  private:
    const Scene& scene_;
    std::vector<PartId> parts_;
    std::vector<char> values_, scratch_;
    std::vector<std::uint32_t> stack_;
};

}  // namespace csg::reference
