// Edges against the true edges of solids, in all layers.
#include "npr/edges/edge_map.h"

#include <algorithm>
#include <cmath>

#include "tests/npr/scene.h"
#include "tests/support/gl_test.h"

namespace {

using csg::Operation;

using Segment = std::array<glm::dvec3, 2>;

std::vector<Segment> box_edges(const glm::dvec3& lo, const glm::dvec3& hi) {
    std::vector<Segment> edges;
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            Segment s{lo, lo};
            s[1][axis] = hi[axis];
            for (int other = 1; other < 3; ++other) {
                if ((corner >> (other - 1) & 1) != 0) {
                    for (glm::dvec3& end : s) {
                        end[(axis + other) % 3] = hi[(axis + other) % 3];
                    }
                }
            }
            edges.push_back(s);
        }
    }
    return edges;
}

glm::dvec2 project(const base::View& view, const glm::dvec3& p) {
    const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(p, 1);
    // The view's jitter is zero here.
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view.size());
}

double distance(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const double t = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + t * (b - a));
}

/// A straight line that edge points lie on.
struct Line {
    glm::vec2 at, across;
    int points = 0;
};

/// How many straight lines of some length the layer's edges of a kind lie on.
int line_count(const std::vector<npr::HostEdge>& edges, int layer, bool profile) {
    std::vector<Line> lines;
    for (const npr::HostEdge& e : edges) {
        if (e.layer != layer || e.profile != profile) {
            continue;
        }
        auto line = std::find_if(lines.begin(), lines.end(), [&](const Line& l) {
            return std::abs(glm::dot(l.across, e.across)) > 0.998F && std::abs(glm::dot(e.at - l.at, l.across)) < 1.2F;
        });
        if (line == lines.end()) {
            line = lines.insert(lines.end(), Line{e.at, e.across, 0});
        }
        ++line->points;
    }
    return static_cast<int>(std::count_if(lines.begin(), lines.end(), [](const Line& l) { return l.points >= 8; }));
}

class EdgeMapTest : public test_support::GlTest {
  protected:
    void find(const scene::Model& model, const base::Camera* camera = nullptr, int size = 128,
              const npr::EdgeSettings& settings = {}) {
        const comparison::Subject subject(random_tree::make_tree(model));
        const auto engine = goldfeather::make_engine(*goldfeather::find_engine("goldfeather"), {&gl()});
        const auto prepared = engine->prepare(subject.input());
        view_.emplace(camera ? *camera : scene::camera(subject.geometry.box), glm::ivec2(size), subject.geometry.box.lo,
                      subject.geometry.box.hi);
        const layers::TextureStack layers = scene::peel(gl(), subject, *prepared, *view_);
        const gl::Framebuffer unused(gl());
        const npr::Picture picture;
        npr::EdgeMap map(gl());
        map.draw({picture, *view_, layers, unused}, settings);
        edges_ = map.read_back();
    }

    [[nodiscard]] std::size_t count(bool profile) const {
        return static_cast<std::size_t>(
            std::count_if(edges_.begin(), edges_.end(), [&](const auto& e) { return e.profile == profile; }));
    }

    /// All edge points lie on the solid's edges, and all of the solid's edges are found, hidden ones in deeper layers.
    void expect_exactly(const std::vector<Segment>& solid) const {
        std::vector<std::array<glm::dvec2, 2>> projected;
        for (const Segment& s : solid) {
            projected.push_back({project(*view_, s[0]), project(*view_, s[1])});
        }
        for (const npr::HostEdge& e : edges_) {
            double nearest = 1e9;
            for (const auto& s : projected) {
                nearest = std::min(nearest, distance(glm::dvec2(e.at), s[0], s[1]));
            }
            // The link that an edge crosses is as long as a pixel. About corners no more is known.
            EXPECT_LT(nearest, 1.0) << e.at.x << ", " << e.at.y << " layer " << e.layer;
        }
        for (std::size_t i = 0; i < solid.size(); ++i) {
            const double length = glm::distance(projected[i][0], projected[i][1]);
            int missed = 0, close = 0, steps = 0;
            for (double way = 1.5; way < length - 1.5; way += 0.5, ++steps) {
                const glm::dvec2 p = glm::mix(projected[i][0], projected[i][1], way / length);
                double nearest = 1e9, beside = 1e9;
                for (const npr::HostEdge& e : edges_) {
                    if (glm::distance(p, glm::dvec2(e.at)) < 1.0) {
                        nearest = glm::distance(p, glm::dvec2(e.at));
                        beside = std::min(beside, distance(glm::dvec2(e.at), projected[i][0], projected[i][1]));
                    }
                }
                missed += nearest > 1.0 ? 1 : 0;
                close += beside < 0.01 ? 1 : 0;  // A link is divided into 1023 parts, planes are in single precision.
            }
            EXPECT_LE(missed, 1) << "edge " << i << " of " << length << " pixels";
            EXPECT_GE(close, steps * 9 / 10) << "edge " << i;
        }
    }

    std::optional<base::View> view_;
    std::vector<npr::HostEdge> edges_;
};

TEST_P(EdgeMapTest, CubeSeenFromACorner) {
    base::Camera camera;
    camera.rotation = {54.7356, 0, 45};
    camera.projection = base::Projection::Orthographic;
    base::view_all(camera, glm::dvec3(0), glm::dvec3(10), true);
    find(scene::box({0, 0, 0}, glm::dvec3(10)), &camera);
    EXPECT_EQ(line_count(edges_, 0, true), 6);
    EXPECT_EQ(line_count(edges_, 0, false), 3);
    EXPECT_EQ(line_count(edges_, 1, true), 0) << "front and back end in one edge";
    EXPECT_EQ(line_count(edges_, 1, false), 3);
}

TEST_P(EdgeMapTest, BoxInPerspective) {
    const glm::dvec3 size(10, 6, 14);
    find(scene::box({0, 0, 0}, size));
    expect_exactly(box_edges(glm::dvec3(0), size));
}

TEST_P(EdgeMapTest, DifferenceHasTheEdgesOfTheResult) {
    // The subtracted box reaches out at the top; its edges there are none of the result's.
    find(scene::combine(Operation::Difference,
                        {scene::box({0, 0, 0}, glm::dvec3(10)), scene::box({3, 3, 5}, {4, 4, 8})}));
    std::vector<Segment> expected = box_edges(glm::dvec3(0), glm::dvec3(10));
    const auto pocket = box_edges({3, 3, 5}, {7, 7, 10});
    expected.insert(expected.end(), pocket.begin(), pocket.end());
    expect_exactly(expected);
}

TEST_P(EdgeMapTest, NoEdgeWithinAPlane) {
    find(scene::combine(Operation::Union, {scene::box({0, 0, 0}, glm::dvec3(4)), scene::box({4, 0, 0}, glm::dvec3(4)),
                                           scene::box({2, 1, 1}, {5, 2, 2})}));
    expect_exactly(box_edges(glm::dvec3(0), {8, 4, 4}));
}

TEST_P(EdgeMapTest, PartsAndColorsWithinAPlane) {
    const scene::Model model =
        scene::combine(Operation::Union, {scene::colored({1, 0, 0, 1}, scene::box({0, 0, 0}, glm::dvec3(4))),
                                          scene::colored({0, 1, 0, 1}, scene::box({4, 0, 0}, glm::dvec3(4)))});
    npr::EdgeSettings settings;
    settings.parts = false;
    find(model, nullptr, 128, settings);
    EXPECT_EQ(line_count(edges_, 0, false), 3);
    settings.parts = true;
    find(model, nullptr, 128, settings);
    EXPECT_GT(line_count(edges_, 0, false), 3);
}

TEST_P(EdgeMapTest, MantlesAreSmoothAndPrismsAreNot) {
    base::Camera side;
    side.rotation = {90, 0, 10};
    base::view_all(side, {-5, -5, 0}, {5, 5, 10}, true);
    for (const auto& [sides, lines] : {std::pair{64, 0}, {24, 0}, {12, 0}, {6, 2}, {4, 1}}) {
        csg::Fineness fineness;
        fineness.fn = sides;
        find(scene::leaf(csg::Cylinder{10, 5, 5, false, fineness}), &side);
        EXPECT_EQ(line_count(edges_, 0, false), lines) << sides << " sides";
        EXPECT_GE(line_count(edges_, 0, true), 4) << sides << " sides";
    }
}

TEST_P(EdgeMapTest, SpheresHaveNothingButAnOutline) {
    for (const int sides : {16, 30, 64}) {
        for (const int size : {24, 48, 96}) {
            // Two facets of 22 degrees on from the last, within a pixel, is a bend.
            if (sides == 16 && size == 24) {
                continue;
            }
            csg::Fineness fineness;
            fineness.fn = sides;
            find(scene::leaf(csg::Sphere{10, fineness}), nullptr, size);
            EXPECT_EQ(count(false), 0U) << sides << " sides in " << size << " pixels";
            // Its outline is a circle: about 4/3 of a link per pixel of it.
            const glm::dvec2 center = project(*view_, {0, 0, 0});
            double radius = 0;
            for (const npr::HostEdge& e : edges_) {
                radius = std::max(radius, glm::distance(glm::dvec2(e.at), center));
            }
            for (const npr::HostEdge& e : edges_) {
                EXPECT_NEAR(glm::distance(glm::dvec2(e.at), center), radius, 0.05 * radius + 1);
            }
            EXPECT_GT(static_cast<double>(count(true)), 6 * radius);
            EXPECT_LT(static_cast<double>(count(true)), 10 * radius);
        }
    }
}

TEST_P(EdgeMapTest, EmptyPictureHasNoEdges) {
    find(scene::combine(Operation::Intersection,
                        {scene::box({0, 0, 0}, glm::dvec3(1)), scene::box({2, 0, 0}, glm::dvec3(1))}));
    EXPECT_TRUE(edges_.empty());
}

INSTANTIATE_TEST_SUITE_P(Contexts, EdgeMapTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
