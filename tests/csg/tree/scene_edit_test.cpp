// Leaves put into expressions and taken out.
#include "csg/tree/scene_edit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "csg/solid/cut_box.h"
#include "tests/csg/solid/mesh_volume.h"
#include "tests/random/build_model.h"

namespace {

using csg::ExpressionKind;

std::string text(const csg::Scene& scene, std::uint32_t expression) {
    const csg::Expression& e = scene.expressions[expression];
    if (e.kind == ExpressionKind::Leaf) {
        return fmt::format("{}", e.leaf);
    }
    std::string result = e.kind == ExpressionKind::Union ? "(+" : e.kind == ExpressionKind::Difference ? "(-" : "(*";
    for (const std::uint32_t child : scene.children(e)) {
        result += fmt::format(" {}", text(scene, child));
    }
    return result + ")";
}

std::string text(const csg::Scene& scene) {
    std::string result;
    for (const csg::Part& part : scene.parts) {
        result += fmt::format("{} of {}+{}; ", text(scene, part.root), part.first_leaf, part.leaf_count);
    }
    return result;
}

csg::Scene scene() {
    const random_tree::Model box = random_tree::box({0, 0, 0}, {1, 1, 1});
    random_tree::Model behind = box;
    behind.modifiers.background = true;
    return csg::make_scene(random_tree::make_tree(random_tree::combine(
        csg::Operation::Union, {random_tree::combine(csg::Operation::Difference, {box, box}), box, behind})));
}

TEST(SceneEdit, PutsLeavesBehindThoseOfTheSite) {
    csg::Scene s = scene();
    ASSERT_EQ(text(s), "(+ (- 0 1) 2) of 0+3; 3 of 3+1; ");
    EXPECT_EQ(csg::insert_leaf(s, {0}, ExpressionKind::Intersection, {}), 3U);
    EXPECT_EQ(text(s), "(* (+ (- 0 1) 2) 3) of 0+4; 4 of 4+1; ");
    csg::OccurrenceId difference = 0;
    while (s.occurrences[difference].parent != 0) {
        ++difference;
    }
    EXPECT_EQ(csg::insert_leaf(s, {0, difference}, ExpressionKind::Union, {}), 2U);
    EXPECT_EQ(text(s), "(* (+ (+ (- 0 1) 2) 3) 4) of 0+5; 5 of 5+1; ");
    EXPECT_EQ(csg::insert_leaf(s, {1}, ExpressionKind::Difference, {}), 6U);
    EXPECT_EQ(csg::insert_leaf(s, {0, difference}, ExpressionKind::Difference, {}), 3U) << "of all that is there now";
    EXPECT_EQ(text(s), "(* (+ (- (+ (- 0 1) 2) 3) 4) 5) of 0+6; (- 6 7) of 6+2; ");
    EXPECT_EQ(s.leaves[7].part, 1U);

    csg::erase_leaf(s, 2);
    EXPECT_EQ(text(s), "(* (+ (- (- 0 1) 2) 3) 4) of 0+5; (- 5 6) of 5+2; ");
    csg::erase_leaf(s, 4);
    csg::erase_leaf(s, 2);
    csg::erase_leaf(s, 4);
    EXPECT_EQ(text(s), text(scene()));
    EXPECT_EQ(s.expression_children.size(), scene().expression_children.size());
}

TEST(SceneEdit, FindsNoSiteInOtherParts) {
    const csg::Scene s = scene();
    csg::OccurrenceId background = s.leaves[3].occurrence;
    EXPECT_EQ(csg::expression_at(s, {0, background}), csg::kNoExpression);
    EXPECT_EQ(csg::expression_at(s, {1, background}), s.parts[1].root);
    EXPECT_EQ(csg::expression_at(s, {0, 0}), s.parts[0].root);
}

TEST(CutBox, KeepsWhatIsBelowThePlane) {
    const csg::Box box{{0, 0, 0}, {4, 2, 1}};
    const auto volume = [&](const csg::solid::Plane& plane) {
        const csg::solid::CutBox cut = csg::solid::cut_box(box, plane);
        return test::mesh_volume(cut.solid->points, cut.solid->triangles);
    };
    EXPECT_DOUBLE_EQ(volume({{0, 0, 1}, 0.25}), 2);
    EXPECT_DOUBLE_EQ(volume({{0, 0, -1}, -0.25}), 6);
    EXPECT_DOUBLE_EQ(volume({{0, 0, 1}, 2}), 8);
    EXPECT_DOUBLE_EQ(volume({{0, 0, 1}, -1}), 0);
    EXPECT_DOUBLE_EQ(volume({{0, 0, 1}, 0}), 0) << "along a face";
    EXPECT_NEAR(volume({glm::normalize(glm::dvec3(1, 2, 0)), 4 / std::sqrt(5.0)}), 4, 1e-12) << "through two edges";
    EXPECT_NEAR(volume({glm::normalize(glm::dvec3(1, 1, 1)), 1 / std::sqrt(3.0)}), 1.0 / 6, 1e-12) << "one corner";
    const csg::solid::CutBox cut = csg::solid::cut_box(box, {{1, 0, 0}, 3});
    EXPECT_EQ(cut.face_triangles, 2U);
    for (std::uint32_t t = 0; t < 2; ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            EXPECT_EQ(cut.solid->points[cut.solid->triangles[t][corner]].x, 3);
        }
    }
}

}  // namespace
