// The table of engines, and what is drawn where an engine meets an obstacle.
#include "goldfeather/engines.h"

#include <gtest/gtest.h>

#include <set>

#include "csg/solid/placed.h"
#include "goldfeather/engine_set.h"
#include "goldfeather/surface_table.h"
#include "layers/host_stack.h"
#include "tests/random/build_model.h"
#include "tests/support/temporary_folder.h"

namespace {

using goldfeather::EngineInfo;

TEST(Engines, AreFoundByTheirNames) {
    std::set<std::string_view> names;
    for (const EngineInfo& engine : goldfeather::engines()) {
        EXPECT_EQ(goldfeather::find_engine(engine.name), &engine);
        EXPECT_TRUE(names.insert(engine.name).second) << engine.name << " is there twice";
    }
    EXPECT_EQ(goldfeather::find_engine("auto"), nullptr);
    EXPECT_EQ(goldfeather::find_engine(""), nullptr);
}

TEST(Engines, OneDrawsEverythingAndNeedsNothing) {
    const goldfeather::EngineCapabilities& c = goldfeather::fallback_engine().capabilities;
    EXPECT_EQ(c.most_layers, goldfeather::kAllLayers);
    EXPECT_FALSE(c.needs_opengl);
    EXPECT_FALSE(c.needs_products);
}

/// Whoever adds an engine tells of it.
TEST(Engines, AreInTheDocuments) {
    const std::string root = CSGSCOPE_SOURCE_DIR;
    const std::string engines = test_support::read_file(root + "/docs/ENGINES.md");
    const std::string architecture = test_support::read_file(root + "/docs/ARCHITECTURE.md");
    const std::string manual = test_support::read_file(root + "/docs/csgscope.1");
    EXPECT_NE(manual.find("auto (default), " + goldfeather::engine_names()), std::string::npos)
        << "docs/csgscope.1 lists other engines";
    for (const EngineInfo& engine : goldfeather::engines()) {
        const std::string name(engine.name);
        EXPECT_NE(engines.find("\n## `" + name + "`\n"), std::string::npos) << "docs/ENGINES.md: " << name;
        EXPECT_NE(architecture.find("| engine `" + name + "` |"), std::string::npos)
            << "docs/ARCHITECTURE.md: " << name;
    }
}

struct Subject {
    explicit Subject(const random_tree::Model& model)
        : tree(random_tree::make_tree(model)), scene(csg::make_scene(tree)) {
        csg::solid::SolidCache cache;
        geometry = csg::solid::place(tree, scene, cache);
    }
    csg::Tree tree;
    csg::Scene scene;
    csg::solid::Geometry geometry;
};

/// An engine in a few lines. It draws an empty layer, once; then, and of scenes with more than one leaf, nothing.
class Shy : public goldfeather::Engine {
  public:
    std::unique_ptr<goldfeather::PreparedScene> prepare(const goldfeather::EngineInput& input) override {
        if (input.scene.leaves.size() > 1) {
            throw goldfeather::EngineObstacle("too many leaves");
        }
        return std::make_unique<Scene>();
    }

  private:
    class Scene : public goldfeather::PreparedScene {
      public:
        layers::Stack draw(const base::View& view, int /*max_layers*/, goldfeather::WalkStats& stats,
                           const std::stop_token& /*stop*/) override {
            if (drawn_) {
                throw goldfeather::EngineObstacle("once is enough");
            }
            drawn_ = true;
            ++stats.passes;
            auto stack = std::make_shared<layers::HostStack>();
            stack->resize(view.size());
            stack->layers = 1;
            stack->reserve(1);
            return {stack, nullptr};
        }

      private:
        bool drawn_ = false;
    };
};

class EngineSets : public testing::Test {
  protected:
    /// How many layers are found, and why another engine has drawn.
    std::pair<int, std::string> draw(goldfeather::PreparedScene& scene, const Subject& subject) {
        base::Camera camera;
        base::view_all(camera, subject.geometry.box.lo, subject.geometry.box.hi, true);
        const base::View view(camera, {33, 33}, subject.geometry.box.lo, subject.geometry.box.hi);
        goldfeather::WalkStats stats;
        const layers::Stack stack = scene.draw(view, goldfeather::kAllLayers, stats);
        return {stack.host->layers, stats.fallback};
    }
    goldfeather::EngineSet engines_{{}};
    Shy shy_;
};

TEST_F(EngineSets, DrawWithAnotherWhatOneCannotDraw) {
    const Subject one(random_tree::box({0, 0, 0}, {1, 1, 1}));
    const auto scene = engines_.prepare({one.scene, one.geometry}, shy_);
    EXPECT_EQ(draw(*scene, one), std::pair(1, std::string()));
    EXPECT_EQ(draw(*scene, one), std::pair(2, std::string("once is enough")));
}

TEST_F(EngineSets, DrawWithAnotherWhereTheSceneIsNoneForTheEngine) {
    const Subject two(random_tree::combine(
        csg::Operation::Union, {random_tree::box({0, 0, 0}, {1, 1, 1}), random_tree::box({3, 0, 0}, {1, 1, 1})}));
    const auto scene = engines_.prepare({two.scene, two.geometry}, shy_);
    EXPECT_EQ(draw(*scene, two).second, "too many leaves");
    EXPECT_GE(draw(*scene, two).first, 2);
}

/// Memory goes from picture to picture, but never from one that somebody holds.
TEST_F(EngineSets, StacksThatAreHeldStay) {
    const Subject one(random_tree::box({0, 0, 0}, {1, 1, 1}));
    base::Camera camera;
    base::view_all(camera, one.geometry.box.lo, one.geometry.box.hi, true);
    const base::View view(camera, {33, 33}, one.geometry.box.lo, one.geometry.box.hi);
    const auto scene = engines_.prepare({one.scene, one.geometry}, goldfeather::fallback_engine());
    goldfeather::WalkStats stats;
    layers::Stack held = scene->draw(view, 0, stats);
    const layers::HostStack* const first = held.host.get();
    EXPECT_NE(scene->draw(view, 0, stats).host.get(), first);
    held = {};
    const layers::HostStack* const second = scene->draw(view, 0, stats).host.get();
    EXPECT_EQ(scene->draw(view, 0, stats).host.get(), second);
}

/// The table of surfaces says what the scene says.
TEST(SurfaceTable, HasColorsPartsAndTheirKinds) {
    random_tree::Model ghost = random_tree::box({0, 0, 5}, {1, 1, 1}), marked = random_tree::box({0, 0, 9}, {1, 1, 1});
    ghost.modifiers.background = true;
    marked.modifiers.highlight = true;
    random_tree::Model glass = random_tree::combine(csg::Operation::Color, {random_tree::box({5, 0, 0}, {1, 1, 1})});
    glass.color = {0.25F, 0.5F, 0.75F, 0.5F};
    const Subject subject(
        random_tree::combine(csg::Operation::Union, {random_tree::box({0, 0, 0}, {1, 1, 1}), glass, ghost, marked}));
    const auto table = goldfeather::surface_table(subject.scene, subject.geometry);
    ASSERT_EQ(table->leaves.size(), subject.scene.leaves.size());
    std::set<layers::PartKind> kinds;
    for (std::size_t leaf = 0; leaf < table->leaves.size(); ++leaf) {
        const csg::LeafInstance& expected = subject.scene.leaves[leaf];
        EXPECT_EQ(table->leaves[leaf].part.x, expected.part);
        EXPECT_EQ(table->leaves[leaf].color.r, expected.color.r);
        const bool ghostly = subject.scene.parts[expected.part].kind == csg::PartKind::Background;
        EXPECT_EQ(table->leaves[leaf].color.a, ghostly ? -1 : expected.color.a)
            << "that of the scheme, where not given";
        kinds.insert(static_cast<layers::PartKind>(table->leaves[leaf].part.y));
        const bool same = [&] {
            switch (subject.scene.parts[expected.part].kind) {
                case csg::PartKind::Solid:
                    return table->leaves[leaf].part.y == layers::SurfaceCode().kPartSolid;
                case csg::PartKind::Translucent:
                    return table->leaves[leaf].part.y == layers::SurfaceCode().kPartTranslucent;
                case csg::PartKind::Background:
                    return table->leaves[leaf].part.y == layers::SurfaceCode().kPartBackground;
                case csg::PartKind::Highlight:
                    return table->leaves[leaf].part.y == layers::SurfaceCode().kPartHighlight;
            }
            return false;
        }();
        EXPECT_TRUE(same) << leaf;
    }
    EXPECT_EQ(kinds.size(), 4U);
    EXPECT_EQ(table->planes.size(), subject.geometry.planes.planes().size());
    EXPECT_EQ(table->local_center, subject.geometry.box.center());
}

}  // namespace
