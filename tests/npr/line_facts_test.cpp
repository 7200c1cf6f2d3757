// What lines know: kind, what hides them, and the coordinate along them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/surface_table.h"
#include "layers/upload.h"
#include "npr/edges/edge_map.h"
#include "npr/painter/cpu_edges.h"
#include "npr/samples.h"
#include "tests/npr/scene.h"
#include "tests/support/gl_test.h"

namespace {

using csg::Operation;
using npr::HostEdge;
using npr::LineFacts;
using npr::LineKind;
using scene::box;
using scene::combine;

const npr::EdgeSettings kWithFacts{.crease_degrees = 33, .parts = true, .visible_only = false, .facts = true};

/// A model as seen from one view, with the lines that both painters find.
class Sight {
  public:
    explicit Sight(const scene::Model& model, csg::PartRule::Kind parts = csg::PartRule::Kind::Model)
        : subject_(random_tree::make_tree(model), false, {.kind = parts, .depth = 1, .modules = {}}) {}

    [[nodiscard]] const csg::Box& box() const { return subject_.geometry.box; }
    [[nodiscard]] const base::View& view() const { return *view_; }

    void look(const base::Camera& camera, glm::ivec2 size, glm::dvec2 jitter = glm::dvec2(0)) {
        view_.emplace(camera, size, box().lo, box().hi, jitter);
        stack_ = goldfeather::peel_to_host(subject_.scene, subject_.geometry, *view_);
        stack_.table = goldfeather::surface_table(subject_.scene, subject_.geometry);
    }

    /// Found without OpenGL, in the form of the other.
    [[nodiscard]] std::vector<HostEdge> painted(const npr::EdgeSettings& settings = kWithFacts) const {
        npr::Picture picture;
        picture.size = view_->size();
        std::vector<glm::vec4> unused;
        std::vector<HostEdge> all;
        for (const auto& tile : npr::find_edges({picture, *view_, stack_, unused}, settings)) {
            for (const npr::CpuEdge& e : tile) {
                all.push_back({e.at + 0.5F + glm::vec2(view_->jitter()), e.across, e.layer, e.profile,
                               npr::shader::LineCode().unpack_facts(e.facts)});
            }
        }
        return all;
    }

    [[nodiscard]] std::vector<HostEdge> drawn(const gl::Functions& gl,
                                              const npr::EdgeSettings& settings = kWithFacts) const {
        layers::TextureStack textures = layers::Upload(gl).upload(stack_);
        textures.table = std::make_shared<layers::SurfaceBuffers>(gl, *stack_.table);
        const npr::Picture picture;
        const gl::Framebuffer unused(gl);
        npr::EdgeMap map(gl);
        map.draw({picture, *view_, textures, unused}, settings);
        return map.read_back();
    }

    /// Pixels from the lower left corner, as HostEdge has them.
    [[nodiscard]] glm::dvec2 project(const glm::dvec3& p) const {
        const glm::dvec4 clip = view_->clip_from_world() * glm::dvec4(p, 1);
        return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view_->size()) + view_->jitter();
    }

    /// What is known of the line through a point of the model, among those that so many surfaces hide (-1: any).
    [[nodiscard]] LineFacts at(const glm::dvec3& p, int surfaces = -1) const {
        double nearest = 1.2;
        LineFacts facts = npr::shader::LineCode().no_facts();
        for (const HostEdge& e : painted()) {
            const double away = glm::distance(project(p), glm::dvec2(e.at));
            if (away < nearest && (surfaces < 0 || e.facts.surfaces == surfaces)) {
                nearest = away;
                facts = e.facts;
            }
        }
        return facts;
    }

  private:
    comparison::Subject subject_;
    std::optional<base::View> view_;
    layers::HostStack stack_;
};

LineKind kind(const LineFacts& facts) {
    return static_cast<LineKind>(facts.kind);
}

base::Camera flat_camera(const csg::Box& box) {
    base::Camera camera = scene::camera(box);
    camera.projection = base::Projection::Orthographic;
    return camera;
}

/// A bored block, and another one of another color, flush with it.
scene::Model two_blocks() {
    csg::Fineness fine;
    fine.fn = 48;
    return combine(
        Operation::Union,
        {combine(Operation::Difference, {box({0, 0, 0}, {10, 10, 10}),
                                         scene::at({5, 5, -1}, scene::leaf(csg::Cylinder{12, 2, 2, false, fine}))}),
         scene::colored({0.8F, 0.2F, 0.1F, 1}, box({10, 0, 0}, {4, 10, 10}))});
}

/// On the rim of the bore, on the side where its wall is seen: the middle of a facet's edge.
const glm::dvec3 kRim =
    glm::dvec3(5, 5, 10) +
    2 * std::cos(glm::radians(3.75)) * glm::dvec3(std::cos(glm::radians(116.25)), std::sin(glm::radians(116.25)), 0);

TEST(LineFacts, KindsOfAKnownModel) {
    Sight sight(two_blocks(), csg::PartRule::Kind::Color);
    sight.look(flat_camera(sight.box()), {200, 200});
    EXPECT_EQ(kind(sight.at({5, 0, 10})), LineKind::Crease);
    EXPECT_EQ(kind(sight.at({14, 5, 10})), LineKind::Crease);
    EXPECT_EQ(kind(sight.at({5, 10, 10})), LineKind::Silhouette);
    EXPECT_EQ(kind(sight.at({0, 0, 5})), LineKind::Silhouette);
    EXPECT_EQ(kind(sight.at(kRim)), LineKind::Intersection);
    EXPECT_EQ(kind(sight.at({10, 5, 10}, 0)), LineKind::PartBorder);
    EXPECT_EQ(kind(sight.at({10, 0, 5}, 0)), LineKind::PartBorder);

    Sight as_one(two_blocks());
    as_one.look(flat_camera(as_one.box()), {200, 200});
    EXPECT_EQ(kind(as_one.at({10, 5, 10})), LineKind::ColorBorder);
    EXPECT_EQ(kind(as_one.at(kRim)), LineKind::Intersection);
}

TEST(LineFacts, TheStrongestKindWins) {
    // Two parts that meet in an angle: a border, a crease and an intersection at once.
    const scene::Model step = combine(
        Operation::Union, {box({0, 0, 0}, {10, 10, 4}), scene::colored({0, 0, 1, 1}, box({0, 5, 4}, {10, 5, 4}))});
    for (const auto& [rule, expected] : {std::pair{csg::PartRule::Kind::Color, LineKind::PartBorder},
                                         {csg::PartRule::Kind::Model, LineKind::Intersection}}) {
        Sight sight(step, rule);
        sight.look(flat_camera(sight.box()), {160, 160});
        EXPECT_EQ(kind(sight.at({5, 5, 4})), expected);
        EXPECT_EQ(kind(sight.at({5, 5, 8})), LineKind::Crease);
    }
}

TEST(LineFacts, WhatHides) {
    Sight sight(two_blocks(), csg::PartRule::Kind::Color);
    sight.look(flat_camera(sight.box()), {200, 200});
    EXPECT_EQ(sight.at({5, 0, 10}).surfaces, 0);
    EXPECT_EQ(sight.at({5, 0, 10}).solids, 0);
    EXPECT_EQ(sight.at({5, 10, 10}).solids, 0) << "a silhouette";
    // The lower edge at the back is behind its own block and, as parts, the other one.
    const glm::dvec3 back(9.5, 10, 0);
    EXPECT_EQ(sight.at(back).surfaces, 3);
    EXPECT_EQ(sight.at(back).solids, 2);
    Sight as_one(two_blocks());
    as_one.look(flat_camera(as_one.box()), {200, 200});
    EXPECT_EQ(as_one.at(back).surfaces, 1);
    EXPECT_EQ(as_one.at(back).solids, 1);
    EXPECT_EQ(kind(as_one.at(back)), LineKind::Crease);
}

TEST(LineFacts, NestedShells) {
    const auto centered = [](double size) { return box(glm::dvec3(-size / 2), glm::dvec3(size)); };
    Sight sight(combine(Operation::Union, {combine(Operation::Difference, {centered(20), centered(18)}),
                                           combine(Operation::Difference, {centered(14), centered(12)}), centered(6)}));
    sight.look(flat_camera(sight.box()), {200, 200});
    const auto expect = [&](double half, int surfaces, int solids) {
        const LineFacts facts = sight.at({0.3 * half, -half, half}, surfaces);  // The upper edge in front.
        EXPECT_EQ(kind(facts), LineKind::Crease) << half;
        EXPECT_EQ(facts.solids, solids) << half;
    };
    expect(10, 0, 0);
    expect(9, 1, 1);  // The wall's inner side.
    expect(7, 2, 1);
    expect(6, 3, 2);
    expect(3, 4, 2);
}

TEST(LineFacts, ATubeHidesTwiceAndARodOnce) {
    csg::Fineness fine;
    fine.fn = 64;
    const auto lying = [&](double radius) {
        return scene::matrix(glm::rotate(glm::dmat4(1), glm::radians(90.0), {0, 1, 0}),
                             scene::leaf(csg::Cylinder{30, radius, radius, true, fine}));
    };
    const scene::Model plate = box({0, 20, -10}, {12, 1, 20});
    for (const bool hollow : {false, true}) {
        const scene::Model bar =
            hollow ? combine(Operation::Difference,
                             {lying(4), scene::matrix(glm::scale(glm::dmat4(1), {2, 1, 1}), lying(3))})
                   : lying(4);
        Sight sight(combine(Operation::Union, {plate, bar}));
        base::Camera camera = flat_camera(sight.box());
        camera.rotation = {88, 0, 7};
        sight.look(camera, {240, 240});
        const LineFacts behind = sight.at({0, 20, -0.4});
        EXPECT_EQ(behind.surfaces, hollow ? 4 : 2);
        EXPECT_EQ(behind.solids, hollow ? 2 : 1);
        EXPECT_EQ(kind(behind), LineKind::Silhouette);
        EXPECT_EQ(sight.at({0, 20, 8}).surfaces, 0);
    }
}

TEST(LineFacts, GlassHidesNothing) {
    Sight sight(combine(Operation::Union, {box({0, 0, 0}, {10, 10, 10}),
                                           scene::colored({0.5F, 0.7F, 1, 0.4F}, box({-4, -4, 0}, {18, 1, 14}))}));
    sight.look(flat_camera(sight.box()), {200, 200});
    const LineFacts behind_glass = sight.at({5, 0, 9.99}, 2);
    EXPECT_EQ(kind(behind_glass), LineKind::Crease);
    EXPECT_EQ(behind_glass.solids, 0);
}

TEST(LineFacts, AnEyeInsideASolidSeesItsLines) {
    Sight sight(box({0, 0, 0}, {10, 10, 10}));
    base::Camera camera;
    camera.target = {5, 5, 5};
    camera.distance = 0.01;
    camera.fov = 100;
    sight.look(camera, {200, 200});
    const std::vector<HostEdge> lines = sight.painted();
    ASSERT_FALSE(lines.empty());
    for (const HostEdge& e : lines) {
        EXPECT_EQ(e.facts.surfaces, 0);
        EXPECT_EQ(e.facts.solids, 0);
    }
}

TEST(LineFacts, DeepLinesKeepTheirCounts) {
    std::vector<scene::Model> plates;
    for (int i = 0; i < 20; ++i) {
        plates.push_back(box({0, 2.0 * i, 0}, {30, 1, 30}));
    }
    Sight sight(combine(Operation::Union, plates));
    base::Camera camera = flat_camera(sight.box());
    camera.rotation = {80, 0, 8};
    sight.look(camera, {240, 240});
    int deepest = 0;
    for (const HostEdge& e : sight.painted()) {
        EXPECT_EQ(e.layer, std::min(e.facts.surfaces, layers::kLayersApart - 1));
        EXPECT_EQ(e.facts.solids, (e.facts.surfaces + 1) / 2);
        deepest = std::max(deepest, e.facts.surfaces);
    }
    EXPECT_GT(deepest, 30);
}

TEST(LineFacts, AreNothingWhereNobodyAsks) {
    Sight sight(two_blocks());
    sight.look(flat_camera(sight.box()), {64, 64});
    for (const HostEdge& e : sight.painted({})) {
        EXPECT_EQ(e.facts.kind, 0U);
    }
}

TEST(LineFacts, WordsComeBack) {
    npr::shader::LineCode code;
    for (const LineFacts& f : {LineFacts{1, 0, 0, false, 0, 1, 0, 0}, LineFacts{5, 77, 12, true, -3.25F, 0.6F, 3, 1},
                               LineFacts{4, code.kMostHiding, code.kMostHiding, true, 1e9F, 1, 7, 0}}) {
        const LineFacts back = code.unpack_facts(code.pack_facts(f));
        EXPECT_EQ(back.kind, f.kind);
        EXPECT_EQ(back.surfaces, f.surfaces);
        EXPECT_EQ(back.solids, f.solids);
        EXPECT_EQ(back.anchored, f.anchored);
        EXPECT_EQ(back.along, f.along);
        EXPECT_NEAR(back.slope, f.slope, 0.002);
        EXPECT_EQ(back.clearance, f.clearance);
        EXPECT_EQ(back.remoteness, f.remoteness);
    }
    const LineFacts most = code.unpack_facts(code.pack_facts({1, 1 << 20, 1 << 20, false, 0, 1, 99, 0}));
    EXPECT_EQ(most.surfaces, code.kMostHiding);
    EXPECT_EQ(most.solids, code.kMostHiding);
    EXPECT_EQ(most.clearance, code.kClear);
    EXPECT_EQ(most.kind, 1U);
}

/// The edges of the box of that size with a corner in the origin.
std::vector<std::array<glm::dvec3, 2>> box_edges(const glm::dvec3& size) {
    std::vector<std::array<glm::dvec3, 2>> edges;
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            glm::dvec3 from(0);
            from[(axis + 1) % 3] = (corner & 1) != 0 ? size[(axis + 1) % 3] : 0;
            from[(axis + 2) % 3] = (corner & 2) != 0 ? size[(axis + 2) % 3] : 0;
            glm::dvec3 to = from;
            to[axis] = size[axis];
            edges.push_back({from, to});
        }
    }
    return edges;
}

/// How far, in pixels, the coordinate along a line may be from that of the point of the box that is seen there: the
/// largest distance, over all lines that are not about a corner or about each other. `points`: how many there were.
double error_along(const Sight& sight, const std::vector<HostEdge>& lines, const glm::dmat4& placed,
                   const glm::dvec3& size, int& points) {
    double worst = 0;
    for (const HostEdge& e : lines) {
        double nearest = 1e9, next = 1e9, expected = 0, slope = 1, unit = 0;
        for (const auto& [a, b] : box_edges(size)) {
            const glm::dvec3 from(placed * glm::dvec4(a, 1)), to(placed * glm::dvec4(b, 1));
            const auto away = [&](double t) {
                return glm::distance(sight.project(glm::mix(from, to, t)), glm::dvec2(e.at));
            };
            double low = 0, high = 1;  // The nearest point is in between.
            for (int i = 0; i < 40; ++i) {
                const double third = (high - low) / 3;
                if (away(low + third) < away(high - third)) {
                    high -= third;
                } else {
                    low += third;
                }
            }
            const double here = away(low);
            if (here < nearest) {
                const glm::dvec3 p = glm::mix(from, to, low), way = glm::normalize(to - from), size_of = glm::abs(way);
                const int axis = size_of.x > std::max(size_of.y, size_of.z) ? 0 : size_of.y > size_of.z ? 1 : 2;
                next = nearest;
                nearest = here;
                expected = p[axis];
                slope = size_of[axis];
                unit = glm::distance(sight.project(p + 0.01 * way), sight.project(p)) / 0.01;
            } else {
                next = std::min(next, here);
            }
        }
        if (nearest > 0.7 || next < 4) {
            continue;
        }
        ++points;
        EXPECT_TRUE(e.facts.anchored) << e.at.x << ", " << e.at.y;
        EXPECT_NEAR(e.facts.slope, slope, 0.003);
        worst = std::max(worst, unit * std::abs(e.facts.along - expected) / slope);
    }
    return worst;
}

TEST(LineFacts, TheCoordinateStaysOnTheModel) {
    const glm::dvec3 size(10, 6, 14);
    const glm::dmat4 turned = glm::rotate(glm::translate(glm::dmat4(1), {3, -20, 8}), 0.7, {0.3, 0.5, -0.8});
    for (const glm::dmat4& placed : {glm::dmat4(1), turned}) {
        Sight sight(scene::matrix(placed, box({0, 0, 0}, size)));
        for (const auto projection : {base::Projection::Perspective, base::Projection::Orthographic}) {
            for (int turn = 0; turn < 12; turn += 3) {
                for (const int sample : {0, 3}) {
                    base::Camera camera = scene::camera(sight.box());
                    camera.projection = projection;
                    camera.rotation = {50.0 + turn, 0, 7.0 * turn + 3};
                    sight.look(camera, {180, 180}, sample == 0 ? glm::dvec2(0) : npr::sample_offsets(16)[3]);
                    int points = 0;
                    EXPECT_LT(error_along(sight, sight.painted(), placed, size, points), 0.1)
                        << fmt::format("turn {}, sample {}", turn, sample);
                    EXPECT_GT(points, 60);
                }
            }
        }
    }
}

TEST(LineFacts, BordersOfPartsAreAnchoredToo) {
    Sight sight(two_blocks(), csg::PartRule::Kind::Color);
    sight.look(flat_camera(sight.box()), {200, 200});
    EXPECT_TRUE(sight.at({10, 5, 10}).anchored);
    EXPECT_NEAR(sight.at({10, 5, 10}).along, 5, 0.1);
    EXPECT_NEAR(sight.at({10, 0, 5}).along, 5, 0.1);
    // Of a border of colors within a part the other plane is not in the stack.
    Sight as_one(two_blocks());
    as_one.look(flat_camera(as_one.box()), {200, 200});
    EXPECT_FALSE(as_one.at({10, 5, 10}).anchored);
}

/// Along a bent line the coordinate goes on from piece to piece, but where the main axis changes.
TEST(LineFacts, ThePiecesOfARimGoOnInEachOther) {
    csg::Fineness fine;
    fine.fn = 90;
    Sight sight(scene::at({100, -40, 7}, scene::leaf(csg::Cylinder{6, 8, 8, false, fine})));
    sight.look(flat_camera(sight.box()), {240, 240});
    int rim = 0;
    for (const HostEdge& e : sight.painted()) {
        // Seen from above at an angle, so the upper rim's front is a crease of layer 0.
        if (e.layer != 0 || kind(e.facts) != LineKind::Crease) {
            continue;
        }
        ++rim;
        double nearest = 1e9, expected = 0;
        for (double angle = 0; angle < 360; angle += 0.1) {
            const glm::dvec3 p(100 + 8 * std::cos(glm::radians(angle)), -40 + 8 * std::sin(glm::radians(angle)), 13);
            const double away = glm::distance(sight.project(p), glm::dvec2(e.at));
            if (away < nearest) {
                nearest = away;
                // The tangent's main axis is that to which the radius is less parallel.
                const bool by_y = std::abs(p.x - 100) > std::abs(p.y + 40);
                expected = std::abs(std::abs(p.x - 100) - std::abs(p.y + 40)) < 1 ? 1e9 : by_y ? p.y : p.x;
            }
        }
        if (expected < 1e8) {
            EXPECT_NEAR(e.facts.along, expected, 0.15);
        }
    }
    EXPECT_GT(rim, 60);
}

class LineFactsTest : public test_support::GlTest {};

TEST_P(LineFactsTest, BothPaintersAgree) {
    const scene::Model mixed =
        combine(Operation::Union, {scene::colored({0.35F, 0.5F, 0.7F, 1}, scene::widget()), scene::flush_blocks(),
                                   scene::colored({0.3F, 0.7F, 0.3F, 0.4F}, box({-9, -11, -9}, {18, 1, 18}))});
    for (const auto rule : {csg::PartRule::Kind::Model, csg::PartRule::Kind::Color}) {
        for (const bool flat : {false, true}) {
            Sight sight(mixed, rule);
            sight.look(flat ? flat_camera(sight.box()) : scene::camera(sight.box()), {150, 130},
                       npr::sample_offsets(4)[1]);
            const std::vector<HostEdge> painted = sight.painted(), drawn = sight.drawn(gl());
            int differing = 0;
            for (const HostEdge& e : painted) {
                const bool same = std::any_of(drawn.begin(), drawn.end(), [&](const HostEdge& d) {
                    return d.layer == e.layer && d.profile == e.profile && glm::distance(d.at, e.at) < 0.01F &&
                           d.facts.kind == e.facts.kind && d.facts.surfaces == e.facts.surfaces &&
                           d.facts.solids == e.facts.solids && d.facts.anchored == e.facts.anchored &&
                           std::abs(d.facts.along - e.facts.along) < 0.01F;
                });
                differing += same ? 0 : 1;
            }
            EXPECT_GT(painted.size(), 1000U);
            EXPECT_NEAR(static_cast<double>(painted.size()), static_cast<double>(drawn.size()), 5);
            EXPECT_LE(differing, static_cast<int>(painted.size() / 200));
        }
    }
}

TEST_P(LineFactsTest, WithoutThemTheMapIsTheSame) {
    Sight sight(two_blocks());
    sight.look(scene::camera(sight.box()), {90, 70});
    const std::vector<HostEdge> with = sight.drawn(gl()), without = sight.drawn(gl(), {});
    ASSERT_EQ(with.size(), without.size());
    for (std::size_t i = 0; i < with.size(); ++i) {
        EXPECT_EQ(with[i].at, without[i].at);
        EXPECT_EQ(without[i].facts.kind, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, LineFactsTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
