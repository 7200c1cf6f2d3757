// What sections leave of a model: cut areas against closed forms, sides, parts, hatching, and all engines and painters.
#include "ui/pipeline/sections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "base/file.h"
#include "npr/style.h"
#include "tests/csg/scad/evaluate_text.h"
#include "tests/support/gl_test.h"
#include "ui/pipeline/mesh/mesh.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {
namespace {

constexpr csg::PartRule kTop{csg::PartRule::Kind::Depth, 1, {}};

npr::Section plane(const glm::dvec3& normal, double offset,
                   npr::PlaneSection::Away away = npr::PlaneSection::Away::Beyond) {
    return {npr::PlaneSection{glm::normalize(normal), offset, away}, "plane"};
}

npr::Sections sections(std::vector<npr::Section> cuts, std::vector<std::string> uncut = {}) {
    return {std::move(cuts), std::move(uncut), 0};
}

std::shared_ptr<const Model> whole(const std::string& text, const npr::Sections& by = {}) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    ModelBuilder builder;
    builder.divide(kTop);
    builder.cut(by);
    return builder.build(run.evaluation.tree);
}

struct Cut {
    std::shared_ptr<SectionedModel> keeper;
    const Model* model;
    std::vector<std::string> warnings;
};

Cut cut(const std::string& text, const npr::Sections& by, const base::Camera& camera = {}) {
    const auto model = whole(text, by);
    const npr::Sections known = resolved(by, model->box, camera);
    auto keeper = std::make_shared<SectionedModel>();
    const Model& left = keeper->cut(model, known);
    return {keeper, &left, section_warnings(*model, known)};
}

/// Looks against `direction`, so that the picture is as wide and as high as `size` world units.
base::Camera facing(const glm::dvec3& rotation, const glm::dvec3& target, double size) {
    base::Camera camera;
    camera.rotation = rotation;
    camera.target = target;
    camera.projection = base::Projection::Orthographic;
    camera.distance = 0.5 * size / std::tan(glm::radians(0.5 * camera.fov));
    return camera;
}

/// What faces of sections take up in a picture of that many world units, in square units.
double cut_area(const Model& model, const glm::dvec3& rotation, const glm::dvec3& target, double size) {
    constexpr int kPixels = 1200;
    Renderer renderer({}, Painter::Cpu);
    PictureRequest request(npr::default_picture());
    request.camera = facing(rotation, target, size);
    request.size = {kPixels, kPixels};
    request.samples = 1;
    request.sections.cuts = {plane({0, 0, 1}, 0)};  // Hatching is on, at no distance: the picture tells cut faces …
    request.sections.spacing = 1e-9 * size;         // … by a tone of their own.
    const base::Image hatched = renderer.render(model, request);
    request.sections.spacing = 0;
    const base::Image plain = renderer.render(model, request);
    int count = 0;
    for (std::size_t i = 0; i < plain.rgba.size(); i += 4) {
        count += std::equal(&plain.rgba[i], &plain.rgba[i] + 4, &hatched.rgba[i]) ? 0 : 1;
    }
    return count * (size / kPixels) * (size / kPixels);
}

/// Of the closed mesh, in the plane, which goes through no corner of it: by the segments that its triangles leave
/// there.
double mesh_section_area(const csg::reference::Mesh& mesh, const glm::dvec3& normal, double offset) {
    double twice = 0;
    const glm::dvec3 origin = offset * normal;
    for (const glm::uvec3& t : mesh.triangles) {
        std::array<glm::dvec3, 2> ends{};  // Where the border of the triangle goes up through the plane, and down.
        bool crossed = false;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 &p = mesh.points[t[i]], &q = mesh.points[t[(i + 1) % 3]];
            const double a = glm::dot(normal, p) - offset, b = glm::dot(normal, q) - offset;
            if ((a < 0) != (b < 0)) {
                ends[a < 0 ? 0 : 1] = p + a / (a - b) * (q - p) - origin;
                crossed = true;
            }
        }
        twice += crossed ? glm::dot(normal, glm::cross(ends[0], ends[1])) : 0;
    }
    return 0.5 * std::abs(twice);
}

/// Cuts of a model of the gallery at a share of its height (or length), against its exact mesh (CGAL).
void expect_areas_of_mesh(const std::string& name, double share) {
    SCOPED_TRACE(name);
    const auto text = base::read_regular_file(CSGSCOPE_SOURCE_DIR "/models/" + name + ".scad");
    ASSERT_TRUE(text.has_value());
    const auto model = whole(*text);
    const csg::reference::Mesh mesh = make_mesh(*model).mesh;
    const csg::Box& box = model->box;
    struct Way {
        glm::dvec3 normal, rotation;
    };
    // Turned within the plane, so that no edge goes along rows of pixels.
    for (const Way& way : {Way{{0, 0, 1}, {0, 0, 17}}, Way{{1, 0, 0}, {90, 17, 90}}, Way{{0, -1, 0}, {90, 17, 0}}}) {
        const double low = std::min(glm::dot(way.normal, box.lo), glm::dot(way.normal, box.hi));
        const double offset = low + share * glm::dot(glm::abs(way.normal), box.size());
        const double expected = mesh_section_area(mesh, way.normal, offset);
        ASSERT_GT(expected, 0);
        SectionedModel keeper;
        const Model& left = keeper.cut(model, resolved(sections({plane(way.normal, offset)}), box, {}));
        const glm::dvec3 across = box.size() * (glm::dvec3(1) - glm::abs(way.normal));
        EXPECT_NEAR(cut_area(left, way.rotation, box.center(), glm::length(across)), expected, 1e-3 * expected)
            << "along " << way.normal.x << ", " << way.normal.y << ", " << way.normal.z;
    }
}

/// Is the point in the part, whose leaves are boxes?
bool remains(const Model& model, csg::PartId part, const glm::dvec3& point) {
    std::vector<char> values;
    const auto inside = [&](csg::LeafId leaf) {
        const csg::Box& box = model.geometry.leaves[leaf].box;
        return csg::enclose(box, point) == box;
    };
    return csg::evaluate(model.scene, model.scene.parts[part], inside, values);
}

double polygon_area(int corners, double radius) {
    return 0.5 * corners * radius * radius * std::sin(2 * std::numbers::pi / corners);
}

const char* const kPot =
    "color(\"red\") difference() { cylinder(r = 20, h = 30, $fn = 64); translate([0, 0, 3]) "
    "cylinder(r = 17, h = 30, $fn = 64); }";

TEST(Sections, CutAreasAreThoseOfTheSolid) {
    // Within a thousandth: of the pixels along the border half are counted. No edge goes along rows of pixels.
    const double ring = polygon_area(64, 20) - polygon_area(64, 17);
    const Cut level = cut(kPot, sections({plane({0, 0, 1}, 12)}));
    EXPECT_TRUE(level.warnings.empty());
    EXPECT_NEAR(cut_area(*level.model, {0, 0, 0}, {0, 0, 0}, 44), ring, 1e-3 * ring);

    const double profile = 2 * 20 * 30.0 - 2 * 17 * 27.0;
    const Cut upright = cut(kPot, sections({plane({0, -1, 0}, 0)}));
    EXPECT_NEAR(cut_area(*upright.model, {90, 17, 0}, {0, 0, 15}, 60), profile, 1e-3 * profile);

    // At 45 degrees through the middle of a cube: a rectangle of 10 by 10 √2.
    const Cut slant = cut("cube(10, center = true);", sections({plane({0, -1, 1}, 0)}));
    EXPECT_NEAR(cut_area(*slant.model, {45, 0, 0}, {0, 0, 0}, 20), 100 * std::numbers::sqrt2, 0.15);
}

TEST(Sections, CutAreasAreThoseOfTheMesh) {
    expect_areas_of_mesh("box", 0.41);
    expect_areas_of_mesh("pipe_tee", 0.437);
    expect_areas_of_mesh("widget", 0.463);
}

TEST(Sections, CutAreasOfAssembliesAreThoseOfTheMesh) {
    expect_areas_of_mesh("padlock", 0.437);
}

TEST(Sections, ShellsThatOverlapAreCutAsOneSolid) {
    // Inside is a winding number: where the cubes overlap there is no hole in the cut.
    const Cut two = cut("cube(10); translate([5, 5, 0]) cube(10);", sections({plane({0, 0, 1}, 5)}));
    EXPECT_NEAR(cut_area(*two.model, {0, 0, 0}, {7.5, 7.5, 0}, 20), 175, 0.2);
}

TEST(Sections, TheEyesSideOfAPlaneIsCutAway) {
    const auto eye_side = sections({plane({0, 0, 1}, 5, npr::PlaneSection::Away::Eye)});
    for (const auto projection : {base::Projection::Perspective, base::Projection::Orthographic}) {
        base::Camera above, below;
        above.projection = below.projection = projection;
        above.rotation = {30, 0, 0};
        below.rotation = {150, 0, 0};
        above.distance = below.distance = 100;
        for (const bool from_above : {true, false}) {
            const Cut made = cut("cube(10);", eye_side, from_above ? above : below);
            EXPECT_EQ(remains(*made.model, 0, {1, 1, 9}), !from_above);
            EXPECT_EQ(remains(*made.model, 0, {1, 1, 1}), from_above);
        }
    }
}

TEST(Sections, CornersFaceTheEye) {
    const char* const cube = "cube(10, center = true);";
    base::Camera camera;
    camera.rotation = {55, 0, 25};  // The eye is at +x, -y, +z, nearer to the y axis.
    camera.distance = 100;
    const auto is_left = [&](int axes, const glm::dvec3& point) {
        return remains(*cut(cube, sections({{npr::CornerSection{axes}, "corner"}}), camera).model, 0, point);
    };
    EXPECT_FALSE(is_left(1, {-4, -4, -4}));
    EXPECT_FALSE(is_left(1, {4, -4, 4}));
    EXPECT_TRUE(is_left(1, {4, 4, 4}));
    EXPECT_TRUE(is_left(2, {-4, -4, -4}));
    EXPECT_FALSE(is_left(2, {4, -4, -4}));
    EXPECT_FALSE(is_left(2, {4, -4, 4}));
    EXPECT_TRUE(is_left(3, {4, -4, -4}));
    EXPECT_FALSE(is_left(3, {4, -4, 4}));
}

const char* const kAssembly =
    "module block() cube(10); module pin() translate([5, 5, -1]) cylinder(r = 2, h = 12); "
    "module plate() translate([0, 0, 10]) cube([10, 10, 2]); block(); pin(); plate();";

TEST(Sections, PartsCanStayWhole) {
    const auto by = sections({plane({1, 0, 0}, 5)}, {"pin"});
    const Cut made = cut(kAssembly, by);
    const csg::Scene& scene = made.model->scene;
    ASSERT_EQ(scene.parts.size(), 3U);
    EXPECT_EQ(scene.parts[0].leaf_count, 2U);
    EXPECT_EQ(scene.parts[1].leaf_count, 1U) << "the pin";
    EXPECT_EQ(scene.parts[2].leaf_count, 2U);
}

TEST(Sections, PartsNextToEachOtherAreHatchedInOtherWays) {
    const Cut made = cut(kAssembly, sections({plane({1, 0, 0}, 5)}));
    std::set<int> hatchings;
    for (const csg::LeafInstance& leaf : made.model->scene.leaves) {
        if (leaf.hatching != 0) {
            hatchings.insert(leaf.hatching);
        }
    }
    EXPECT_EQ(hatchings.size(), 3U) << "all three touch";
    const Cut apart = cut("cube(1); translate([5, 0, 0]) cube(1);", sections({plane({0, 0, 1}, 0.5)}));
    for (const csg::LeafInstance& leaf : apart.model->scene.leaves) {
        EXPECT_LE(leaf.hatching, 1) << "at 45 degrees wherever that tells them apart";
    }
}

TEST(Sections, APartCutsTheOthers) {
    const auto by = sections({{npr::PartSection{"pin"}, "part:pin"}});
    const Cut made = cut(kAssembly, by);
    const csg::Scene& scene = made.model->scene;
    ASSERT_EQ(scene.parts.size(), 3U);
    EXPECT_TRUE(scene.parts[1].hidden);
    EXPECT_EQ(scene.parts[0].leaf_count, 2U);
    EXPECT_FALSE(remains(*made.model, 0, {5, 5, 5}));
    EXPECT_TRUE(remains(*made.model, 0, {1, 1, 1}));
}

TEST(Sections, UnknownPartsAreToldWithTheNearest) {
    const auto error_of = [](const npr::Sections& by) {
        try {
            (void)cut(kAssembly, by);
        } catch (const ModelError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(error_of(sections({plane({0, 0, 1}, 1)}, {"pim"})), "--uncut: no part \"pim\". Did you mean \"pin\"?");
    EXPECT_EQ(error_of(sections({{npr::PartSection{"x"}, "part:x"}})),
              "--section part: no part \"x\". There are block, pin, plate; --parts says what is one.");
}

TEST(Sections, WhatMissesTheModelIsTold) {
    const auto warnings = [](const npr::Section& section) { return cut("cube(10);", sections({section})).warnings; };
    EXPECT_EQ(warnings(plane({0, 0, 1}, 10)).size(), 1U) << "touches it only";
    EXPECT_EQ(warnings(plane({0, 0, 1}, 9.9)).size(), 0U);
    EXPECT_EQ(warnings(plane({0, 0, 1}, 0)).size(), 1U) << "all of it";
    EXPECT_EQ(warnings({npr::BoxSection{{20, 0, 0}, {30, 1, 1}}, "box"}).size(), 1U);
    EXPECT_EQ(warnings({npr::BoxSection{{-1, -1, -1}, {11, 11, 11}}, "box"}).size(), 1U);
    EXPECT_EQ(warnings({npr::BoxSection{{1, 1, 1}, {2, 2, 2}}, "box"}).size(), 0U);
}

TEST(Sections, PlanesThatMoveAreWhatPlanesThereWouldBe) {
    const auto model = whole(kAssembly);
    PictureRequest request(npr::default_picture());
    request.draw_as(*npr::find_style("edges"));
    request.size = {80, 60};
    request.samples = 1;
    base::view_all(request.camera, model->box.lo, model->box.hi, true);
    Renderer renderer({}, Painter::Cpu);
    SectionedModel keeper;
    const auto draw_kept = [&](const npr::Sections& by) {
        request.sections = by;
        const Model& left = keeper.cut(model, by);
        if (!keeper.change().empty()) {
            renderer.update(left, keeper.change());
        }
        return renderer.render(left, request).rgba;
    };
    const auto draw_anew = [&](const npr::Sections& by) {
        request.sections = by;
        SectionedModel once;
        return Renderer({}, Painter::Cpu).render(once.cut(model, by), request).rgba;
    };
    const std::uint64_t before = [&] {
        (void)draw_kept(sections({plane({1, 0, 0}, 3), plane({0, 0, 1}, 8)}));
        return keeper.cut(model, sections({plane({1, 0, 0}, 3), plane({0, 0, 1}, 8)})).generation;
    }();
    for (const double at : {4.0, 5.0, 5.5, 9.0, 2.0}) {
        const auto by = sections({plane({1, 0, 0}, at), plane({0, 0, 1}, 8)});
        EXPECT_EQ(draw_kept(by), draw_anew(by)) << at;
        EXPECT_FALSE(keeper.change().structure) << "moved in place";
        EXPECT_EQ(keeper.cut(model, by).generation, before);
    }
    for (const auto& by : {sections({plane({0, 1, 0}, 5)}), sections({plane({0, 1, 0}, 5)}, {"pin"}), sections({}),
                           sections({{npr::BoxSection{{5, 0, 0}, {20, 20, 20}}, "box"}})}) {
        EXPECT_EQ(draw_kept(by), draw_anew(by));
    }
}

/// Each engine, and each painter, draws the same section.
class SectionPictures : public test_support::GlTest {};

TEST_P(SectionPictures, AreTheSameByAllEnginesAndPainters) {
    const Cut made = cut(kAssembly, sections({plane({1, -1, 0}, 1), plane({0, 0, 1}, 8)}, {"pin"}));
    PictureRequest request(npr::default_picture());
    request.size = {120, 100};
    request.samples = 1;
    request.sections.cuts = {plane({0, 0, 1}, 8)};
    base::view_all(request.camera, made.model->box.lo, made.model->box.hi, true);
    for (const npr::StyleInfo& style : npr::styles()) {
        request.draw_as(style);
        const base::Image painted = Renderer({}, Painter::Cpu).render(*made.model, request);
        for (const char* const name : {"goldfeather", "lists", "scs"}) {
            const goldfeather::EngineInfo* const engine = goldfeather::find_engine(name);
            if (std::string_view(name) == "scs" && style.name != "shaded") {
                continue;  // First layers only.
            }
            const base::Image drawn = Renderer(*context_, {engine}, Painter::OpenGl).render(*made.model, request);
            int differ = 0;
            for (std::size_t i = 0; i < painted.rgba.size(); i += 4) {
                int worst = 0;
                for (std::size_t c = i; c < i + 4; ++c) {
                    worst = std::max(worst, std::abs(painted.rgba[c] - drawn.rgba[c]));
                }
                differ += worst > 8 ? 1 : 0;
            }
            EXPECT_LE(differ, 0.01 * request.size.x * request.size.y) << style.name << " by " << name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Contexts, SectionPictures, testing::Values(gl::ContextKind::Egl), test_support::context_name);

}  // namespace
}  // namespace ui
