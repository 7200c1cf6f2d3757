// Glyphs of what moves: where they are, and what is said of expressions that are none.
#include "ui/pipeline/motion/depiction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "csg/solid/placed.h"
#include "csg/solid/winding_number.h"
#include "npr/style.h"
#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/motion/star.h"
#include "ui/pipeline/motion/tube.h"

namespace ui {
namespace {

constexpr const char* kModel =
    "module ball() sphere(2, $fn = 32);\n"
    "translate([20 * cos(180 * $t), 20 * sin(180 * $t), 0]) ball();\n"
    "translate([0, 0, 30]) rotate([0, 0, 90 * $t]) translate([5, 0, 0]) cube([5, 2, 2]);\n"
    "translate([0, 0, -9]) cube([4, 4, 1]);\n"
    "%translate([0, 0, -20]) cube(1);\n";

std::shared_ptr<const csg::Tree> tree_at(double time) {
    csg::scad::Request at;
    at.time = time;
    return test::run(kModel, {}, at).evaluation.tree;
}

const Motion& motion() {
    static const Motion found = [] {
        MotionRequest request;
        request.derivatives = false;
        return find_motion(tree_at, request);
    }();
    return found;
}

/// The model with glyphs, built.
std::shared_ptr<const Model> depicted(const std::vector<std::string>& texts, double now) {
    std::vector<Depiction> depictions;
    for (const std::string& text : texts) {
        depictions.push_back(read_depiction(text));
    }
    ModelBuilder builder;
    return builder.build(
        std::make_shared<const csg::Tree>(depict({*tree_at(now), motion(), now, {}, 1}, depictions).tree));
}

Depicted glyphs(const std::vector<Depiction>& depictions, double now, const Motion& of,
                const std::function<base::Camera(double)>& camera = {}) {
    return depict({*tree_at(now), of, now, camera, 2}, depictions);
}

/// Is the point in a leaf that is none of the model's own?
bool in_glyph(const Model& model, const glm::dvec3& point) {
    for (csg::LeafId leaf = 0; leaf < model.scene.leaves.size(); ++leaf) {
        const csg::solid::PlacedLeaf& placed = model.geometry.leaves[leaf];
        if (!model.scene.leaves[leaf].where.known() && !placed.triangles.empty() &&
            csg::solid::winding_number(placed.points, placed.triangles, point) != 0) {
            return true;
        }
    }
    return false;
}

std::size_t parts_of(const Model& model, csg::PartKind kind) {
    return static_cast<std::size_t>(std::count_if(model.scene.parts.begin(), model.scene.parts.end(),
                                                  [&](const csg::Part& part) { return part.kind == kind; }));
}

TEST(Depiction, PathsFollowTheMiddle) {
    const auto model = depicted({"path {ball} [0, 1] (width = 0.5)"}, 0.5);
    const auto at = [](double t) {
        return 20.0 * glm::dvec3(std::cos(std::numbers::pi * t), std::sin(std::numbers::pi * t), 0);
    };
    for (double t = 0.01; t < 0.5; t += 0.01) {
        EXPECT_TRUE(in_glyph(*model, at(t))) << t;
        EXPECT_FALSE(in_glyph(*model, 1.02 * at(t))) << t;
    }
    // The future is dashed: 8 radii of 13.
    int drawn = 0, all = 0;
    for (double t = 0.5; t < 0.95; t += 0.001, ++all) {
        drawn += in_glyph(*model, at(t)) ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(drawn) / all, 8.0 / 13, 0.05);
    EXPECT_EQ(parts_of(*model, csg::PartKind::Background), 1u) << "what is not of the solid stays";
}

TEST(Depiction, GhostsStandWhereItWasAndWillBe) {
    const auto model = depicted({"ghost {ball} [0, 1] (n = 3)"}, 0.5);
    // One of the three is where the ball itself is.
    EXPECT_EQ(parts_of(*model, csg::PartKind::Translucent), 2u);
    for (const double x : {20.0, -20.0}) {
        bool found = false;
        for (const auto& leaf : model->geometry.leaves) {
            found = found ||
                    (std::abs(0.5 * (leaf.box.lo.x + leaf.box.hi.x) - x) < 1e-9 && leaf.box.hi.x - leaf.box.lo.x < 5);
        }
        EXPECT_TRUE(found) << x;
    }
    const auto still = depicted({"still {ball} [0.25]"}, 0);
    EXPECT_EQ(parts_of(*still, csg::PartKind::Translucent), 0u);
    // Stretched along its way, across it thinner: the volume stays.
    const auto squashed = depicted({"still {ball} [0] (squash = 1)"}, 0.5);
    const csg::Box& box = squashed->geometry.leaves.back().box;
    bool found = false;
    for (const auto& leaf : squashed->geometry.leaves) {
        const glm::dvec3 size = leaf.box.size();
        found = found || (std::abs(size.y / size.z - 2 * std::sqrt(2.0)) < 0.3 && size.y > 7);
    }
    EXPECT_TRUE(found) << box.size().x;
}

TEST(Depiction, TurnsHaveArrowsAboutTheirAxis) {
    const auto model = depicted({"rotation {cube} (width = 0.5)"}, 0);
    // Beyond the corner that is farthest from the axis, [10, 2], in the middle of its height.
    const double r = 1.08 * std::hypot(10, 2) + 3 * 0.25, first = std::atan2(2, 10);
    for (double turn = 0.05; turn < 1.45; turn += 0.1) {
        const double a = first + turn;
        EXPECT_TRUE(in_glyph(*model, {r * std::cos(a), r * std::sin(a), 31})) << turn;
    }
    EXPECT_FALSE(in_glyph(*model, {r * std::cos(first - 0.1), r * std::sin(first - 0.1), 31}));
    EXPECT_FALSE(in_glyph(*model, {r * std::cos(first + 1.7), r * std::sin(first + 1.7), 31}));
}

TEST(Depiction, LinesTrailBehind) {
    const auto model = depicted({"motion {ball} [0.3, 0.5] (n = 6)"}, 0.5);
    EXPECT_EQ(model->scene.leaves.size(), 4u + 6u);
    for (csg::LeafId leaf = 0; leaf < model->scene.leaves.size(); ++leaf) {
        if (!model->scene.leaves[leaf].where.known()) {
            EXPECT_GT(model->geometry.leaves[leaf].box.hi.x, 9);  // At t = 0.3 it was at 11.8, 16.2.
        }
    }
}

TEST(Depiction, AutoGoesByTheMotion) {
    const auto model = depicted({"auto"}, 0);
    EXPECT_GT(model->scene.leaves.size(), 10u);
    EXPECT_EQ(parts_of(*model, csg::PartKind::Translucent), 4u);  // Of the ball; the cube turns.
}

TEST(Depiction, TubesAreClosedAndTurnedOutwards) {
    const std::vector<glm::dvec3> curve{{0, 0, 0}, {10, 0, 0}, {10, 8, 0}, {10, 8, 9}};
    for (const csg::Polyhedron& mesh : {arrow(curve, 0.5), arrow(std::span(curve).first(2), 3),
                                        tube(std::vector<TubePoint>{{curve[0], 0}, {curve[1], 1}})}) {
        double volume = 0;
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const auto& face : mesh.faces) {
            for (std::size_t i = 0; i < face.size(); ++i) {
                ++edges[{face[i], face[(i + 1) % face.size()]}];
                if (i > 0 && i + 1 < face.size()) {
                    volume -=
                        glm::dot(mesh.points[face[0]], glm::cross(mesh.points[face[i]], mesh.points[face[i + 1]])) / 6;
                }
            }
        }
        EXPECT_GT(volume, 0);
        for (const auto& [edge, count] : edges) {
            EXPECT_EQ(count, 1);
            EXPECT_TRUE(edges.contains({edge.second, edge.first}));
        }
    }
    EXPECT_TRUE(arrow(std::vector<glm::dvec3>(3, glm::dvec3(1.0)), 1).faces.empty());
}

TEST(Depiction, ExpressionsAreRead) {
    const Depiction d = read_depiction("ghost { wheel 2 } [0.25,1](n=7, squash=0.5, width=2, color=#ff8000)");
    EXPECT_EQ(d.technique, Depiction::Technique::Ghost);
    EXPECT_EQ(d.part, "wheel 2");
    EXPECT_EQ(d.times, (std::pair(0.25, 1.0)));
    EXPECT_EQ(d.count, 7);
    EXPECT_EQ(d.squash, 0.5);
    EXPECT_EQ(*d.width, 2);
    EXPECT_FLOAT_EQ(d.color->g, 128 / 255.0F);
    EXPECT_EQ(read_depiction("auto").part, "*");
    EXPECT_EQ(read_depiction("still {a} [3]").times, (std::pair(3.0, 3.0)));
}

TEST(Depiction, WhatSwingsBackHasStrokes) {
    // A pendulum there and back; and legs of something that goes on, of which one swings back.
    const auto of = [](const std::string& text) {
        MotionRequest request;
        request.derivatives = false;
        const auto at_time = [&](double time) {
            csg::scad::Request at;
            at.time = time;
            return test::run(text, {}, at).evaluation.tree;
        };
        const Motion found = find_motion(at_time, request);
        const Depiction all = read_depiction("motion {*} [0.2,0.5] (n=1)");
        const Depicted made = depict({*at_time(0.5), found, 0.5, {}, 1}, {all});
        ModelBuilder builder;
        const auto built = builder.build(std::make_shared<const csg::Tree>(made.tree));
        // Even strokes are tubes of one radius; trails begin in a point.
        std::size_t strokes = 0, trails = 0;
        for (csg::LeafId leaf = 0; leaf < built->scene.leaves.size(); ++leaf) {
            if (!built->scene.leaves[leaf].where.known()) {
                const std::size_t points = built->geometry.leaves[leaf].points.size();
                (points % 12 == 0 || points % 12 == 2 ? strokes : trails) += 1;
            }
        }
        return std::pair(strokes, trails);
    };
    const auto [pendulum_strokes, pendulum_trails] =
        of("rotate([0, 40 * sin(900 * $t), 0]) translate([0, 0, -20]) cube(4, center = true);");
    EXPECT_GT(pendulum_strokes, 0u);
    EXPECT_EQ(pendulum_trails, 1u);
    const auto [leg_strokes, leg_trails] =
        of("module fore() translate([60 * $t + 20 * $t, 0, 0]) cube(2); module aft() translate([60 * $t - 20 * $t, 9, "
           "0]) cube(2);"
           "fore(); aft();");
    EXPECT_EQ(leg_strokes, 1u) << "of the one that falls back";
    EXPECT_EQ(leg_trails, 1u);
}

TEST(Depiction, ErrorsSayWhereAndWhatWasExpected) {
    const std::pair<const char*, const char*> wrong[] = {
        {"", "a technique"},
        {"pat {ball}", "Did you mean \"path\"?"},
        {"path {ball", "expected '}'\n  path {ball\n            ^"},
        {"path {}", "the name of a part"},
        {"path {ball} [0.5", "expected ']'"},
        {"path {ball} [1,0]", "not before the first"},
        {"path {ball} [x]", "expected a number\n  path {ball} [x]\n               ^"},
        {"path {ball} (n)", "'='"},
        {"path {ball} (n=0)", "a whole number"},
        {"path {ball} (size=3)", "n=, squash=, width=, color=, text= or with="},
        {"path {ball} (color=rad)", "#rrggbb"},
        {"ghost {ball} (style=)", "a style"},
        {"ghost {ball} (sise=3)", "style=, text= or with="},
        {"path {ball} (style=sketch)", "n=, squash=, width=, color=, text= or with="},
        {"path {ball} 7", "or the end"},
        {"speak {ball}", "what it says"},
        {"speak {ball} (text=hello)", "a text in quotes"},
        {"speak {ball} (text='hello)", "expected '"},
        {"collision {ball} (with='')", "a text"},
    };
    for (const auto& [text, part] : wrong) {
        try {
            (void)read_depiction(text);
            ADD_FAILURE() << text;
        } catch (const std::runtime_error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << text << "\n" << error.what();
        }
    }
    for (const auto& [text, part] : {std::pair("ghost {ball} (style=sketsh)", "Did you mean \"sketch\"?"),
                                     std::pair("still {ball} (style=sketsh)", "\n                      ^"),
                                     std::pair("ghost {ball} (style=\"sketch,wobles=3\")", "wobles"),
                                     std::pair("path {bal}", "Did you mean \"ball\"?"),
                                     std::pair("rotation {ball}", "does not turn about one axis")}) {
        try {
            (void)depicted({text}, 0);
            ADD_FAILURE() << text;
        } catch (const std::runtime_error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    }
}

TEST(Depiction, ImagesInAStyleOfTheirOwnFade) {
    EXPECT_FLOAT_EQ(read_depiction("path {ball} (color=orange)").color->g, 165 / 255.0F);
    const Depicted made =
        glyphs({read_depiction("ghost {ball} (n=4, style=sketch)"), read_depiction("still {cube} [1] (style=lines)"),
                read_depiction("ghost {cube} (n=3)")},
               0, motion());
    // Of four images the first is where the ball itself is.
    ASSERT_EQ(made.styles.size(), 4u);
    for (csg::PartRule::Kind kind :
         {csg::PartRule::Kind::Model, csg::PartRule::Kind::Depth, csg::PartRule::Kind::Color}) {
        csg::PartRule rule;
        rule.kind = kind;
        ModelBuilder builder;
        builder.divide(rule);
        const auto model = builder.build(std::make_shared<const csg::Tree>(made.tree));
        const std::vector<npr::PartStyle> styles = styles_of_glyphs(model->scene, made.styles);
        ASSERT_EQ(styles.size(), 4u) << "each is a part";
        std::vector<std::string> names;
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(styles[i].style->name, i < 3 ? "sketch" : "lines");
            EXPECT_EQ(std::count(names.begin(), names.end(), styles[i].of.name), 0);
            names.push_back(styles[i].of.name);
        }
        EXPECT_GT(styles[0].opacity, styles[1].opacity) << "the fainter the farther off";
        EXPECT_GT(styles[1].opacity, styles[2].opacity);
        EXPECT_EQ(styles[3].opacity, 1);
        // The ball itself, and the plain ghosts, are drawn as the picture is.
        std::size_t styled = 0;
        for (const csg::Part& part : model->scene.parts) {
            layers::PartLook look;
            look.name = part.name;
            for (const npr::PartStyle& style : styles) {
                styled += npr::selects(style.of, look) ? 1 : 0;
            }
        }
        EXPECT_EQ(styled, 4u);
    }
}

TEST(Depiction, WhatCanBeDrawnIsDrawn) {
    std::vector<std::string> problems;
    const std::vector<Depiction> all{read_depiction("path {ball}"), read_depiction("path {bal}"),
                                     read_depiction("rotation {ball}"), read_depiction("rotation {cube}")};
    const Depicted made = depict_what_can({*tree_at(0), motion(), 0, {}, 1}, all, problems);
    ASSERT_EQ(problems.size(), 4u);
    EXPECT_EQ(problems[0], "");
    EXPECT_NE(problems[1].find("Did you mean \"ball\"?"), std::string::npos);
    EXPECT_NE(problems[2].find("does not turn"), std::string::npos);
    EXPECT_EQ(problems[3], "");
    ModelBuilder builder;
    const auto built = builder.build(std::make_shared<const csg::Tree>(made.tree));
    EXPECT_GT(built->scene.leaves.size(), 6u) << "dashes and an arc";
}

TEST(Depiction, RulesAreForBodiesByTheirNames) {
    const std::vector<Depiction> rules = read_depiction_rules(
        "# what turns\n"
        "  rotation {cu*} (color=#00ff00)   # and not {ball}\n"
        "\n"
        "path {wheel, b*ll}\n"
        "rotation {ball}\n"
        "speak {*} [0] (text='# one')\n",
        "rules.txt");
    ASSERT_EQ(rules.size(), 4u);
    EXPECT_EQ(rules[3].say, "# one");
    // The ball has no axis, and rules may be for what is not there: neither is an error.
    const Depicted made = glyphs(rules, 0.5, motion());
    EXPECT_TRUE(made.bubbles.empty()) << "each body has a rule of its own";
    ModelBuilder builder;
    EXPECT_GT(builder.build(std::make_shared<const csg::Tree>(made.tree))->scene.leaves.size(), 8u);
    EXPECT_EQ(glyphs({rules[0], rules[3]}, 0.5, motion()).bubbles.size(), 1u) << "the ball has none";
    try {
        (void)read_depiction_rules("path {a}\n  paht {b}\n", "rules.txt");
        ADD_FAILURE();
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(std::string(error.what()).find("rules.txt:2:3: expected a technique"), 0u) << error.what();
    }
}

TEST(Depiction, NamesHaveStarsAndNumbers) {
    EXPECT_TRUE(names_body("wheel", "wheel"));
    EXPECT_TRUE(names_body("wheel", "wheel 12"));
    EXPECT_TRUE(names_body("axle, w*l", "wheel 12"));
    EXPECT_TRUE(names_body("wheel 2", "wheel 2"));
    EXPECT_TRUE(names_body("*", "anything"));
    EXPECT_FALSE(names_body("wheel 2", "wheel"));
    EXPECT_FALSE(names_body("whee", "wheel"));
    EXPECT_FALSE(names_body("w*x", "wheel"));
    EXPECT_FALSE(names_body("", "wheel"));
}

TEST(Depiction, SpeechAndFramesAreOfTheBodyAtATime) {
    const Depicted made =
        glyphs({read_depiction("speak {ball} [0.5] (text=\"up here\")"), read_depiction("frame {ball} [0] (width=3)")},
               0, motion());
    ASSERT_EQ(made.bubbles.size(), 1u);
    EXPECT_EQ(made.bubbles[0].text, "up here");
    EXPECT_LT(glm::distance(made.bubbles[0].at, glm::dvec3(0, 20, 2)), 0.5);
    ASSERT_EQ(made.frames.size(), 1u);
    EXPECT_EQ(made.frames[0].width, 3);
    for (const glm::dvec3& p : made.frames[0].points) {
        EXPECT_NEAR(glm::distance(p, glm::dvec3(20, 0, 0)), 2, 0.1);
    }
}

TEST(Depiction, CamerasHaveFramesWhereTheyLook) {
    const auto camera = [](double time) {
        base::Camera at;
        at.target = {10 * time, 0, 0};
        at.rotation = {0, 0, 0};
        at.distance = 100;
        return at;
    };
    const Depicted made = glyphs({read_depiction("camera [0,1] (width=0.5)")}, 0, motion(), camera);
    ModelBuilder builder;
    const auto model = builder.build(std::make_shared<const csg::Tree>(made.tree));
    // Of twice the width as it is high, across its axis, about what it looks at.
    const double half = 100 * std::tan(22.5 / 2 * std::numbers::pi / 180);
    for (const double x : {-2 * half, 2 * half, 10 - 2 * half, 10 + 2 * half}) {
        EXPECT_TRUE(in_glyph(*model, {x, 0, 0})) << x;
    }
    EXPECT_TRUE(in_glyph(*model, {0, half, 0}));
    EXPECT_TRUE(in_glyph(*model, {5, 0, 100})) << "the way of the eye";
    EXPECT_THROW((void)glyphs({read_depiction("camera")}, 0, motion(), [](double) { return base::Camera{}; }),
                 std::runtime_error);
}

TEST(Depiction, StarsAreClosedAndTurnedOutwards) {
    const csg::Polyhedron mesh = star({1, 2, 3}, 5);
    double volume = 0, most = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& face : mesh.faces) {
        ASSERT_EQ(face.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            ++edges[{face[i], face[(i + 1) % 3]}];
        }
        volume -= glm::dot(mesh.points[face[0]], glm::cross(mesh.points[face[1]], mesh.points[face[2]])) / 6;
    }
    for (const glm::dvec3& p : mesh.points) {
        most = std::max(most, glm::distance(p, glm::dvec3(1, 2, 3)));
    }
    EXPECT_NEAR(most, 5, 1e-12);
    EXPECT_GT(volume, 0);
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
}

}  // namespace
}  // namespace ui
