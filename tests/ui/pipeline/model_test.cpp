#include "ui/pipeline/model.h"

#include <gtest/gtest.h>

#include <array>

#include "base/stop.h"

namespace ui {
namespace {

using csg::NodeId;
using csg::Operation;

csg::SourceLocation at(std::uint32_t line) {
    return {0, line, 5};
}

NodeId cube(csg::TreeBuilder& builder, double x, double size, std::uint32_t line = 1) {
    const NodeId leaf = builder.leaf(csg::Cube{glm::dvec3(size), false}, at(line));
    glm::dmat4 move(1.0);
    move[3] = {x, 0, 0, 1};
    return builder.transform(move, std::array{leaf}, at(line));
}

std::shared_ptr<const csg::Tree> finish(csg::TreeBuilder& builder, Operation operation, std::vector<NodeId> children) {
    builder.file("m.scad");
    return std::make_shared<const csg::Tree>(builder.finish(builder.combine(operation, children, at(1))));
}

TEST(ModelBuilder, MakesProductsAndTheBoxOfWhatIsLeft) {
    csg::TreeBuilder builder;
    const auto tree =
        finish(builder, Operation::Difference, {cube(builder, 0, 10), cube(builder, 5, 10), cube(builder, 100, 10)});
    const auto model = ModelBuilder().build(tree);
    EXPECT_EQ(model->statistics.leaves, 3U);
    EXPECT_EQ(model->statistics.products, 1U);
    EXPECT_EQ(model->statistics.pruned_literals, 1U) << "the far cube cannot touch the product";
    EXPECT_EQ(model->statistics.triangles, 36U);
    EXPECT_EQ(model->box, (csg::Box{{0, 0, 0}, {10, 10, 10}}));
    EXPECT_FALSE(model->empty());
}

TEST(ModelBuilder, AnEmptyTreeIsAnEmptyModel) {
    csg::TreeBuilder builder;
    const auto model = ModelBuilder().build(std::make_shared<const csg::Tree>(builder.finish(csg::kNoNode)));
    EXPECT_TRUE(model->empty());
    EXPECT_EQ(model->statistics.leaves, 0U);
}

TEST(ModelBuilder, TooManyProductsAreToldWithTheirPlace) {
    csg::TreeBuilder builder;
    std::vector<NodeId> a, b;
    for (int i = 0; i < 10; ++i) {
        a.push_back(cube(builder, 0.1 * i, 10, 3));
        b.push_back(cube(builder, 0.1 * i, 9, 4));
    }
    const NodeId first = builder.combine(Operation::Union, a, at(3));
    const NodeId second = builder.combine(Operation::Union, b, at(4));
    const auto tree = finish(builder, Operation::Intersection, {first, second});
    EXPECT_EQ(ModelBuilder().build(tree)->statistics.products, 100U);
    EXPECT_EQ(ModelBuilder().build(tree)->over_budget, "");
    const auto model = ModelBuilder({50, 1000}).build(tree);
    EXPECT_NE(model->over_budget.find("m.scad:3:5: "), std::string::npos) << model->over_budget;
    EXPECT_NE(model->over_budget.find("more than 50 products"), std::string::npos) << model->over_budget;
    EXPECT_TRUE(model->products[0].empty());
    EXPECT_NEAR(model->box.hi.x, 9.9, 1e-12) << "the intersection's box is known all the same";
}

TEST(ModelBuilder, StopsWhenAsked) {
    csg::TreeBuilder builder;
    const auto tree = finish(builder, Operation::Union, {cube(builder, 0, 10)});
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)ModelBuilder().build(tree, stop.get_token()), base::Stopped);
}

TEST(ModelBuilder, KeepsTheMeshesOfEqualLeaves) {
    ModelBuilder models;
    std::array<std::shared_ptr<const Model>, 2> two;
    for (auto& model : two) {
        csg::TreeBuilder builder;
        model = models.build(finish(builder, Operation::Union, {cube(builder, 0, 10)}));
    }
    EXPECT_EQ(two[0]->geometry.leaves[0].solid, two[1]->geometry.leaves[0].solid);
    EXPECT_LT(two[0]->generation, two[1]->generation);
}

}  // namespace
}  // namespace ui
