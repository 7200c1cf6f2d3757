// Models that image-based CSG is known to get wrong, by name.
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <memory>
#include <set>

#include "tests/goldfeather/engine_test.h"
#include "tests/random/build_model.h"

namespace {

using comparison::Subject;
using csg::Operation;
using random_tree::at;
using random_tree::box;
using random_tree::combine;
using random_tree::leaf;
using random_tree::matrix;
using random_tree::Model;

Model scaled(double s, Model child) {
    return matrix(glm::dmat4(glm::dmat3(s)), std::move(child));
}
Model cube(double x, double y, double z) {
    return leaf(csg::Cube{{x, y, z}, false});
}
base::Camera from(const glm::dvec3& eye, const glm::dvec3& center, double fov = 30) {
    base::Camera camera = base::camera_between(eye, center);
    camera.fov = fov;
    return camera;
}

class HardCases : public comparison::EngineTest {
  protected:
    /// Peels all layers, from which the truth must not differ.
    layers::HostStack peel(const Model& model, const base::Camera& camera, double most_undecided = 0.1) {
        const Subject subject = this->subject(model);
        const base::View view = subject.view(camera, {65, 65});
        auto stack = engine().peel(subject, view);
        comparison::Count count;
        EXPECT_EQ(comparison::difference(subject, view, stack, count), "") << random_tree::scad_text(model);
        EXPECT_LE(static_cast<double>(count.undecided), most_undecided * static_cast<double>(count.pixels));
        return stack;
    }

    /// Leaves of the surfaces in a pixel, nearest first; "-" before those that are cuts.
    static std::string along(const layers::HostStack& stack, int x = 32, int y = 32) {
        std::string text;
        for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0; ++layer) {
            const layers::Surface& s = stack.at(layer, x, y);
            text +=
                fmt::format("{}{}{}{}", text.empty() ? "" : " ", s.leaving ? "<" : ">", s.reversed ? "-" : "", s.leaf);
        }
        return text;
    }

    static std::size_t surfaces(const layers::HostStack& stack) {
        const std::vector<layers::Surface> all = stack.surfaces();
        return static_cast<std::size_t>(
            std::count_if(all.begin(), all.end(), [](const layers::Surface& s) { return s.depth > 0; }));
    }
};

TEST_P(HardCases, SharedFacesOfADifferenceHaveNoSkin) {
    // The hole is as thick as the plate: nothing is left in it.
    const Model plate = combine(Operation::Difference, {box({-4, -4, 0}, {8, 8, 1}), box({-1, -1, 0}, {2, 2, 1})});
    for (const glm::dvec3& eye : {glm::dvec3(0.1, 0.2, 20), glm::dvec3(3, -8, 15), glm::dvec3(0.1, 0.1, -20)}) {
        EXPECT_EQ(along(peel(plate, from(eye, {0.05, 0.06, 0.5}))), "");
    }
}

TEST_P(HardCases, TouchingBlocksHaveNoWall) {
    const Model blocks = combine(Operation::Union, {box({-2, -1, -1}, {2, 2, 2}), box({0, -1, -1}, {2, 2, 2})});
    EXPECT_EQ(along(peel(blocks, from({20, 0.1, 0.2}, {0, 0.1, 0.2}))), ">1 <0");
    EXPECT_EQ(along(peel(blocks, from({12, 9, 7}, {0, 0.1, 0.2}))), ">1 <0");
}

TEST_P(HardCases, ACubeMinusItselfIsNothing) {
    const Model none = combine(Operation::Difference, {cube(2, 3, 4), cube(2, 3, 4)});
    EXPECT_EQ(surfaces(peel(none, from({9, 8, 7}, {1, 1.5, 2}))), 0U);
    // The same place by another way round.
    glm::dmat4 turn(0.0);
    turn[0][1] = 1, turn[1][0] = -1, turn[2][2] = 1, turn[3] = {2, 0, 0, 1};
    const Model turned = combine(Operation::Difference, {cube(2, 3, 4), matrix(turn, cube(3, 2, 4))});
    EXPECT_EQ(surfaces(peel(turned, from({9, 8, 7}, {1, 1.5, 2}))), 0U);
}

TEST_P(HardCases, EndlessLeavesShowWhatLongOnesDo) {
    const auto picture = [&](double reach) {
        const Model turned =
            matrix(glm::rotate(glm::dmat4(1.0), 0.7, {0.3, 1, 0.2}), box({-reach, -0.5, -0.5}, {2 * reach, 1, 1}));
        const Model endless = combine(
            Operation::Difference,
            {combine(Operation::Intersection,
                     {box({-4, -4, -reach}, {8, 8, 2 * reach}), box({-reach, -reach, -2}, {2 * reach, 2 * reach, 4})}),
             box({1, -reach, -1}, {2, 2 * reach, 5}), turned});
        const auto stack = peel(endless, from({13, -17, 15}, {0, 0, 0}, 40));
        std::vector<std::string> pixels;
        for (int y = 0; y < 65; y += 4) {
            for (int x = 0; x < 65; x += 4) {
                pixels.push_back(along(stack, x, y));
            }
        }
        return pixels;
    };
    const auto expected = picture(20);
    EXPECT_GT(std::count_if(expected.begin(), expected.end(), [](const std::string& s) { return !s.empty(); }), 40);
    for (const double reach : {1e4, 1e10}) {
        EXPECT_EQ(picture(reach), expected) << reach;
    }
}

TEST_P(HardCases, EyeInsideASolid) {
    const Model solid = combine(Operation::Union, {box({-5, -5, -5}, {10, 10, 10}), leaf(csg::Sphere{2, {12, 12, 2}})});
    EXPECT_EQ(along(peel(solid, from({0.3, 0.2, 4}, {0.1, 0.2, 0}, 60))), "<0");
    EXPECT_EQ(along(peel(solid, from({0.3, 0.2, 0.5}, {0.1, 0.2, -4}, 60))), "<0");
    EXPECT_EQ(along(peel(solid, from({4.99, 0.2, 0.1}, {4.99, 4, 0}, 60))), "<0");
    // The eye on a face: float positions are as inaccurate as the near plane is close, for a strip of the picture.
    EXPECT_GT(surfaces(peel(solid, from({5, 0.2, 0.1}, {5.0, 4, 0}, 60), 0.5)), 0U);
}

TEST_P(HardCases, EyeInASubtractedHole) {
    const Model bored =
        combine(Operation::Difference,
                {box({-5, -5, -5}, {10, 10, 10}), leaf(csg::Sphere{3, {10, 12, 2}}), box({-1, -1, -9}, {2, 2, 18})});
    EXPECT_EQ(along(peel(bored, from({0.3, 0.2, 1}, {3, 0.4, 0.5}, 70))), ">-1 <0");
    EXPECT_EQ(along(peel(bored, from({0.3, 0.2, 7}, {0.1, 0.1, -7}, 40))), "");
}

TEST_P(HardCases, CoplanarTorture) {
    // Many leaves with common planes in all roles, also turned by an angle without exact sine.
    std::vector<Model> slabs{box({0, 0, 0}, {6, 6, 6})};
    for (int i = 0; i < 6; ++i) {
        const double d = i;
        slabs.push_back(box({d, d, 0}, {1, 1, 6}));
        slabs.push_back(combine(Operation::Difference, {box({d, 0, 5 - d}, {1, 6, 1}), box({d, 2, 5 - d}, {1, 1, 1})}));
    }
    const Model torture = combine(Operation::Difference, slabs);
    glm::dmat4 turn(1.0);
    const double c = std::cos(0.7), s = std::sin(0.7);
    turn[0] = {c, s, 0, 0}, turn[1] = {-s, c, 0, 0};
    for (const Model& model : {torture, matrix(turn, torture), combine(Operation::Union, {torture, slabs[0]})}) {
        peel(model, from({20, 14, 17}, {3, 3, 3}));
        peel(model, from({3.1, 3.2, 40}, {3.1, 3.2, 0}));
    }
    // Filled up again it is the cube.
    const Model filled =
        combine(Operation::Union, {torture, combine(Operation::Union, {slabs.begin() + 1, slabs.end()}), slabs[0]});
    EXPECT_EQ(peel(filled, from({20, 14, 17}, {3, 3, 3})).layers, 2);
}

TEST_P(HardCases, LeavesWithoutVolume) {
    const Model flat =
        combine(Operation::Union,
                {combine(Operation::Difference, {cube(2, 2, 2), cube(2, 2, 0), leaf(csg::Sphere{0, {8, 12, 2}})}),
                 leaf(csg::Cylinder{0, 1, 1, false, {6, 12, 2}}), cube(5, 0, 5),
                 combine(Operation::Intersection, {cube(3, 3, 3), leaf(csg::Cylinder{3, 0, 0, false, {6, 12, 2}})}),
                 combine(Operation::Union, {})});
    EXPECT_EQ(along(peel(flat, from({9, 8, 7}, {1, 1, 1}))), ">0 <0");
}

TEST_P(HardCases, OpenPolyhedronCountsFromTheEye) {
    // A cube without its top, in a union and as a cutter.
    csg::Polyhedron open;
    open.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};
    open.faces = {{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
    const Model mesh = leaf(std::make_shared<const csg::Polyhedron>(open));
    // From above the floor is met first and alone; what is behind it is inside.
    EXPECT_EQ(along(peel(mesh, from({1.1, 1.2, 12}, {1.1, 1.2, 0}))), ">0");
    peel(mesh, from({7, 6, 9}, {1, 1, 1}));
    peel(combine(Operation::Difference, {at({0.5, 0.5, 0.5}, cube(2, 2, 2)), mesh}), from({7, -6, 9}, {1, 1, 1}));
}

TEST_P(HardCases, OpenMeshesCountFromTheEyeInsideThemToo) {
    // Where the eye is in the box of an open mesh, as beside it: what the ray meets first is entered. A closed leaf
    // about the eye is counted from behind all the same.
    csg::Polyhedron open;
    open.points = {{-2, -2, -2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, -2}, {-2, -2, 2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, 2}};
    open.faces = {{0, 1, 2, 3}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
    const Model mesh = leaf(std::make_shared<const csg::Polyhedron>(open));
    const Model around = box({-3, -3, -3}, {6, 6, 6});
    EXPECT_EQ(along(peel(mesh, from({0.1, 0.2, 0.3}, {0.1, 0.2, -5}, 50))), ">0");
    for (const auto& [eye, center] : {std::pair(glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(0.1, 0.2, -5)),
                                      {glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(5, 0.3, 0.1)},
                                      {glm::dvec3(0.3, 0.1, 1.7), glm::dvec3(0.1, 0.2, 5)},
                                      {glm::dvec3(0.3, 0.1, 2.5), glm::dvec3(0.1, 0.2, -5)}}) {
        const base::Camera camera = from(eye, center, 100);
        peel(mesh, camera, 0.2);
        peel(combine(Operation::Difference, {around, mesh}), camera, 0.2);
        peel(combine(Operation::Intersection, {around, mesh}), camera, 0.2);
        peel(combine(Operation::Difference, {mesh, box({-1, -1, -3}, {2, 2, 6})}), camera, 0.2);
    }
}

TEST_P(HardCases, ShellsThatOverlapAreSolidThroughout) {
    // Two cubes in one mesh: inside is a winding number.
    csg::Polyhedron both;
    for (const double d : {0.0, 1.0}) {
        const auto first = static_cast<std::uint32_t>(both.points.size());
        for (unsigned i = 0; i < 8; ++i) {
            both.points.emplace_back(d + ((i & 1) ? 2 : 0), d + ((i & 2) ? 2 : 0), d + ((i & 4) ? 2 : 0));
        }
        for (const auto& f : std::vector<std::vector<std::uint32_t>>{
                 {0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
            both.faces.push_back({first + f[0], first + f[1], first + f[2], first + f[3]});
        }
    }
    const Model mesh = leaf(std::make_shared<const csg::Polyhedron>(both));
    EXPECT_EQ(along(peel(mesh, from({1.5, 1.6, 20}, {1.5, 1.6, 0}))), ">0 <0");
}

TEST_P(HardCases, HugeAndTinyCopiesLookTheSame) {
    const Model part =
        combine(Operation::Difference,
                {combine(Operation::Union, {box({0, 0, 0}, {4, 4, 2}), box({4, 0, 0}, {1, 4, 1})}),
                 at({2, 2, 0}, leaf(csg::Cylinder{2, 1, 1, false, {9, 12, 2}})), box({3, 0, 1}, {1, 4, 1})});
    const glm::dvec3 eye(11, -9, 12), center(2.1, 2.2, 1);
    const auto stack = peel(part, from(eye, center));
    const std::vector<layers::Surface> one = stack.surfaces();
    for (const double scale : {1e6, 1e-4}) {
        const auto of_copy = peel(scaled(scale, part), from(scale * eye, scale * center));
        ASSERT_EQ(of_copy.layers, stack.layers);
        const std::vector<layers::Surface> copy = of_copy.surfaces();
        std::size_t different = 0;
        for (std::size_t i = 0; i < one.size(); ++i) {
            different += one[i].leaf != copy[i].leaf || one[i].reversed != copy[i].reversed ||
                         (one[i].depth > 0) != (copy[i].depth > 0);
        }
        EXPECT_LE(different, one.size() / 200);
    }
}

TEST_P(HardCases, AFlushInlayShowsItself) {
    const Model inlaid = combine(
        Operation::Union, {combine(Operation::Difference, {box({-4, -4, 0}, {8, 8, 2}), box({-1, -1, 1}, {2, 2, 1})}),
                           box({-1, -1, 1}, {2, 2, 1})});
    EXPECT_EQ(along(peel(inlaid, from({0.2, 0.3, 30}, {0.2, 0.3, 0}))), ">2 <0");
}

TEST_P(HardCases, HighlightedPartsComeFirst) {
    Model a = cube(2, 2, 2), b = cube(2, 2, 3);
    const Model plain = cube(2, 2, 4);
    a.modifiers.highlight = b.modifiers.highlight = true;
    const auto stack = peel(combine(Operation::Union, {a, b, plain}), from({1.1, 1.2, -20}, {1.1, 1.2, 0}));
    const Subject subject(random_tree::make_tree(combine(Operation::Union, {a, b, plain})));
    std::vector<csg::PartId> parts;
    for (int layer = 0; layer < 3; ++layer) {
        parts.push_back(subject.scene.leaves[stack.at(layer, 32, 32).leaf].part);
    }
    EXPECT_EQ(parts.back(), 0U);
    EXPECT_EQ(std::set<csg::PartId>(parts.begin(), parts.end()), (std::set<csg::PartId>{0, 1, 2}));
}

INSTANTIATE_TEST_SUITE_P(Engines, HardCases,
                         testing::ValuesIn(comparison::engine_names({gl::ContextKind::Egl, gl::ContextKind::Osmesa})),
                         comparison::engine_name);

}  // namespace
