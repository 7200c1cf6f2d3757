// Models divided into parts.
#include <cmath>
#include <map>

#include "tests/goldfeather/engine_test.h"
#include "tests/random/build_model.h"

namespace {

using comparison::Subject;
using csg::PartRule;

constexpr glm::ivec2 kSize{40, 40};

PartRule depth(unsigned n) {
    return {PartRule::Kind::Depth, n, {}};
}

/// Rules in turn.
PartRule rule_of(std::uint64_t seed) {
    return seed % 4 == 0 ? PartRule{PartRule::Kind::Color, 1, {}} : depth(static_cast<unsigned>(seed % 4));
}

class Parts : public comparison::EngineTest {
  protected:
    [[nodiscard]] Subject divided(const csg::Tree& tree, const PartRule& rule) {
        return Subject(tree, engine().capabilities().needs_products, rule);
    }
};

TEST_P(Parts, AgreeWithTheRayCaster) {
    std::size_t parts = 0, undivided = 0;
    comparison::Count count;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        std::mt19937_64 random(seed);
        const random_tree::Model model = random_tree::make_model(random);
        const Subject subject = divided(random_tree::make_tree(model), rule_of(seed));
        const base::Camera camera = random_tree::make_camera(random, subject.geometry.box.lo, subject.geometry.box.hi);
        const base::View view = subject.view(camera, kSize);
        parts += subject.scene.parts.size();
        undivided += csg::make_scene(random_tree::make_tree(model)).parts.size();
        const std::string wrong = comparison::difference(subject, view, engine().peel(subject, view), count);
        ASSERT_EQ(wrong, "") << "seed " << seed << random_tree::camera_text(camera) << random_tree::scad_text(model);
    }
    EXPECT_GT(parts, undivided + 100) << "they are divided";
}

/// A surface of the union of all parts.
struct Edge {
    float depth;
    bool leaving;
};

/// What the surfaces of a pixel say of the union of their parts.
std::vector<Edge> united(const Subject& subject, const layers::HostStack& stack, int x, int y) {
    std::map<csg::PartId, bool> inside;
    for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0; ++layer) {
        const layers::Surface s = stack.at(layer, x, y);
        inside.try_emplace(subject.scene.leaves[s.leaf].part, s.leaving);  // Where the ray begins.
    }
    const auto any = [&] { return std::ranges::any_of(inside, [](const auto& part) { return part.second; }); };
    std::vector<Edge> edges;
    for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0;) {
        const float depth = stack.at(layer, x, y).depth;
        const bool before = any();
        for (; layer < stack.layers && stack.at(layer, x, y).depth == depth; ++layer) {
            inside[subject.scene.leaves[stack.at(layer, x, y).leaf].part] = !stack.at(layer, x, y).leaving;
        }
        if (any() != before) {
            edges.push_back({depth, before});
        }
    }
    return edges;
}

TEST_P(Parts, AreTheWholeTogether) {
    std::size_t compared = 0, more = 0, given_up = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        std::mt19937_64 random(seed);
        random_tree::Options options;
        options.modifiers = false;
        const random_tree::Model model = random_tree::make_model(random, options);
        const csg::Tree tree = random_tree::make_tree(model);
        const Subject whole(tree, engine().capabilities().needs_products), parts = divided(tree, rule_of(seed));
        if (whole.over_budget + parts.over_budget > 0) {
            continue;
        }
        const base::Camera camera = random_tree::make_camera(random, whole.geometry.box.lo, whole.geometry.box.hi);
        const base::View view = whole.view(camera, kSize);
        layers::HostStack one, many;
        try {
            one = engine().peel(whole, view);
            many = engine().peel(parts, view);
        } catch (const goldfeather::EngineObstacle&) {
            ++given_up;  // Lists that are too long for this OpenGL.
            continue;
        }
        const truth::RayCaster caster(whole.scene, whole.geometry, view),
            part_caster(parts.scene, parts.geometry, view);
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const truth::Ray ray = caster.cast(x, y);
                if (!ray.hit || !ray.decided || !part_caster.cast(x, y).decided) {
                    continue;
                }
                const std::vector<Edge> edges = united(parts, many, x, y);
                ASSERT_EQ(edges.size(), ray.surfaces.size())
                    << "seed " << seed << " at " << x << ", " << y << random_tree::scad_text(model);
                for (std::size_t i = 0; i < edges.size(); ++i) {
                    const layers::Surface s = one.at(static_cast<int>(i), x, y);
                    EXPECT_NEAR(edges[i].depth, s.depth, 2 * ray.surfaces[i].depth_error);
                    EXPECT_EQ(edges[i].leaving, s.leaving);
                }
                ++compared;
                more += many.layers > one.layers ? 1 : 0;
            }
        }
    }
    EXPECT_GT(compared, 20'000u);
    EXPECT_GT(more, 0u);
    EXPECT_LT(given_up, 5u);
}

/// One block on another, and the same cut through, seen from above.
TEST_P(Parts, ThatTouchKeepBothFaces) {
    using random_tree::box, random_tree::combine;
    const auto two = combine(csg::Operation::Union, {box({0, 0, 0}, {2, 2, 1}), box({0, 0, 1}, {2, 2, 1})});
    const auto cut = combine(csg::Operation::Difference,
                             {combine(csg::Operation::Union, {box({0, 0, 0}, {2, 2, 1}), box({0, 0, 1}, {2, 2, 1})}),
                              box({-1, -1, -1}, {2, 4, 4})});
    base::Camera camera;
    camera.rotation = {0, 0, 0};
    camera.target = {1.5, 1, 0};
    camera.distance = 10;
    camera.fov = 1;
    for (const auto& [model, rule] : {std::pair(two, depth(1)), std::pair(cut, depth(2))}) {
        const csg::Tree tree = random_tree::make_tree(model);
        const Subject whole(tree, engine().capabilities().needs_products), parts = divided(tree, rule);
        ASSERT_EQ(parts.scene.parts.size(), 2u);
        const base::View view = parts.view(camera, {1, 1});
        const auto one = engine().peel(whole, view), many = engine().peel(parts, view);
        EXPECT_EQ(comparison::padded(one, 3)[2].depth, 0) << "one block of two surfaces";
        ASSERT_GE(many.layers, 4);
        EXPECT_EQ(many.at(1, 0, 0).depth, many.at(2, 0, 0).depth);
        std::map<csg::PartId, int> entered;
        for (int layer = 0; layer < 4; ++layer) {
            const layers::Surface s = many.at(layer, 0, 0);
            ASSERT_GT(s.depth, 0);
            entered[parts.scene.leaves[s.leaf].part] += s.leaving ? -1 : 1;
        }
        EXPECT_EQ(entered, (std::map<csg::PartId, int>{{0, 0}, {1, 0}}));
        EXPECT_EQ(many.at(0, 0, 0).depth, one.at(0, 0, 0).depth);
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, Parts, testing::ValuesIn(comparison::engine_names({gl::ContextKind::Egl})),
                         comparison::engine_name);

}  // namespace
