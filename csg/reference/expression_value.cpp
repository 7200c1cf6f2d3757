#include "csg/reference/expression_value.h"

namespace csg::reference {

std::vector<PartId> solid_parts(const Scene& scene) {
    std::vector<PartId> parts;
    for (PartId i = 0; i < scene.parts.size(); ++i) {
        if (scene.parts[i].kind == PartKind::Solid || scene.parts[i].kind == PartKind::Translucent)
            parts.push_back(i);
    }
    return parts;
}

ExpressionValue::ExpressionValue(const Scene& scene)
    : scene_(scene), parts_(solid_parts(scene)), values_(scene.expressions.size(), 0) {}

LeafId ExpressionValue::owner(std::span<const LeafId> switching) {
    LeafId best = switching.front();
    bool found = false;
    // Bit 0 of an entry: below an odd number of subtractions, where a node speaks for the solid when it is false.
    stack_.clear();
    for (const PartId part : parts_)
        stack_.push_back(scene_.parts[part].root << 1);
    while (!stack_.empty()) {
        const std::uint32_t top = stack_.back();
        stack_.pop_back();
        const bool complement = (top & 1) != 0;
        const Expression& e = scene_.expressions[top >> 1];
        if ((values_[top >> 1] != 0) == complement)
            continue;
        if (e.kind == ExpressionKind::Leaf) {
            if (std::binary_search(switching.begin(), switching.end(), e.leaf) && (!found || e.leaf < best)) {
                best = e.leaf;
                found = true;
            }
            continue;
        }
        const auto children = scene_.children(e);
        for (std::size_t i = 0; i < children.size(); ++i) {
            const bool flip = e.kind == ExpressionKind::Difference && i > 0;
            stack_.push_back(children[i] << 1 | static_cast<std::uint32_t>(complement != flip));
        }
    }
    return best;
}

}  // namespace csg::reference
