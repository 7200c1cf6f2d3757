#include "ui/pipeline/annotation/glyph_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "csg/solid/extrude.h"
#include "ui/pipeline/editable_model.h"

namespace ui {

namespace {

std::string free_name(const csg::Scene& scene, const std::string& name) {
    const auto taken = [&](const std::string& wanted) {
        return std::any_of(scene.parts.begin(), scene.parts.end(),
                           [&](const csg::Part& part) { return part.name == wanted; });
    };
    std::string found = name;
    for (int i = 2; taken(found); ++i) {
        found = fmt::format("{} {}", name, i);
    }
    return found;
}

}  // namespace

std::shared_ptr<const Model> with_glyphs(const Model& model, std::span<const PlacedGlyph> glyphs,
                                         const std::string& name) {
    Model beside = model;
    csg::Scene& scene = beside.scene;
    csg::Part part;
    part.name = free_name(scene, name);
    part.first_expression = part.root = static_cast<std::uint32_t>(scene.expressions.size());
    part.first_leaf = static_cast<csg::LeafId>(scene.leaves.size());
    csg::Expression nothing;
    nothing.kind = csg::ExpressionKind::Union;
    nothing.first_child = static_cast<std::uint32_t>(scene.expression_children.size());
    scene.expressions.push_back(nothing);
    scene.parts.push_back(part);
    beside.products.emplace_back();
    EditableModel edited(beside);
    const csg::Site site{static_cast<csg::PartId>(scene.parts.size() - 1), csg::kNoOccurrence};
    for (const PlacedGlyph& glyph : glyphs) {
        if (glyph.solid != nullptr && !glyph.solid->triangles.empty()) {
            (void)edited.scene().add(site, csg::ExpressionKind::Union, glyph.solid, glyph.to_world, {glyph.color, 0});
        }
    }
    (void)edited.commit();
    return std::make_shared<const Model>(edited.model());
}

std::shared_ptr<const csg::solid::Solid> slab_of(const csg::solid::Outline& outline, double thickness) {
    csg::LinearExtrude how;
    how.height = thickness;
    return csg::solid::linear_extrude(outline, how);
}

csg::solid::Loop circle(const glm::dvec2& middle, double radius) {
    return rounded_box(middle - radius, middle + radius, radius);
}

csg::solid::Loop rounded_box(const glm::dvec2& lo, const glm::dvec2& hi, double radius) {
    constexpr int kToACorner = 8;
    const double r = std::min(radius, 0.5 * std::min(hi.x - lo.x, hi.y - lo.y));
    const glm::dvec2 middles[]{{hi.x - r, lo.y + r}, {hi.x - r, hi.y - r}, {lo.x + r, hi.y - r}, {lo.x + r, lo.y + r}};
    csg::solid::Loop loop;
    for (int corner = 0; corner < 4; ++corner) {
        for (int i = 0; i <= kToACorner; ++i) {
            const double angle = (corner - 1 + static_cast<double>(i) / kToACorner) * 0.5 * std::numbers::pi;
            const glm::dvec2 p = middles[corner] + r * glm::dvec2(std::cos(angle), std::sin(angle));
            if (loop.empty() || glm::distance(loop.back(), p) > 1e-9 * (1 + r)) {
                loop.push_back(p);
            }
        }
    }
    if (glm::distance(loop.front(), loop.back()) <= 1e-9 * (1 + r)) {
        loop.pop_back();
    }
    return loop;
}

csg::solid::Loop reversed(csg::solid::Loop loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

}  // namespace ui
