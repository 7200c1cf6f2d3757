// Editing by hand without a window: text and model in step, what is moved and added, cursors, palette, gizmo.
#include <gtest/gtest.h>

#include <thread>

#include <fmt/format.h>

#include "csg/scad/program/loaded_program.h"
#include "tests/support/temporary_folder.h"
#include "ui/pipeline/editing/shape_numbers.h"
#include "ui/viewer/palette.h"
#include "ui/viewer/session.h"
#include "ui/viewer/text_caret.h"
#include "ui/viewer/tools/move_gizmo.h"
#include "ui/viewer/tools/side_handles.h"
#include "ui/viewer/tools/snap_places.h"

namespace ui {
namespace {

using namespace std::chrono_literals;

class HandEditing : public testing::Test {
  protected:
    void open(const std::string& text) {
        WindowOptions options;
        options.source.path = folder_.write("model.scad", text);
        options.settings = folder_.path("state/settings");
        session_ = std::make_unique<Session>(options, make_evaluate(), [] {});
        rest();
    }
    /// Until nothing goes on any more.
    void rest() {
        for (int i = 0; i < 3000; ++i) {
            now_ += 0.05;
            (void)session_->update(now_);
            if (!session_->evaluating() && session_->document().model() && session_->can_move()) {
                return;
            }
            std::this_thread::sleep_for(2ms);
        }
        ADD_FAILURE() << "it does not come to rest";
    }
    /// Waits for a while longer than the file is looked at.
    void wait_for_disk() {
        for (int i = 0; i < 40; ++i) {
            now_ += 0.05;
            (void)session_->update(now_);
        }
        rest();
    }
    const std::string& text() const { return session_->editing().text().text(); }
    const csg::Scene& scene() const { return session_->document().model()->scene; }
    void select_leaf(csg::LeafId leaf) {
        session_->perform(SelectCall{scene().leaves[leaf].occurrence, {}, "model.scad"});
    }
    void move_leaf(csg::LeafId leaf, const glm::dvec3& by) {
        select_leaf(leaf);
        session_->perform(PutPart{{session_->selected_occurrence(), by}});
        rest();
    }
    void perform(Command command) {
        session_->perform(command);
        rest();
    }

    test_support::TemporaryFolder folder_;
    std::unique_ptr<Session> session_;
    double now_ = 0;
};

TEST_F(HandEditing, WhatIsTurnedIsSelectedStill) {
    open("translate([10, 5, 0]) cylinder(h = 4, r = 1);\n");
    session_->perform(SelectByte{3});
    const csg::OccurrenceId selected = session_->selected_occurrence();
    ASSERT_NE(selected, csg::kNoOccurrence);
    HeldPart held{selected, {}, {90, 0, 0}, {10, 5, 0}};
    session_->perform(PutPart{held});
    rest();
    EXPECT_EQ(text(), "translate([10, 5, 0]) rotate([90, 0, 0]) cylinder(h = 4, r = 1);\n");
    EXPECT_EQ(session_->selected_occurrence(), selected) << "the translate(), above the rotate() that was put in";
}

TEST_F(HandEditing, WhatIsSelectedIsArranged) {
    open("translate([10, 0, 0]) cube([4, 2, 1]); // here\n");
    select_leaf(0);
    perform(Action::MirrorX);
    EXPECT_EQ(text(), "translate([24, 0, 0]) mirror([1, 0, 0]) translate([10, 0, 0]) cube([4, 2, 1]); // here\n");
    EXPECT_EQ(session_->document().model()->box.lo.x, 10) << "it lies where it lay";
    EXPECT_EQ(session_->document().model()->box.hi.x, 14);
    perform(Action::Undo);
    select_leaf(0);
    perform(Action::RowX);
    EXPECT_EQ(text(), "for (i = [0 : 2]) translate([5 * i, 0, 0]) translate([10, 0, 0]) cube([4, 2, 1]); // here\n");
    EXPECT_EQ(scene().leaves.size(), 3U);
    perform(Action::Undo);
    select_leaf(0);
    perform(Action::CircleZ);
    EXPECT_EQ(scene().leaves.size(), 6U);
    perform(Action::Undo);
    select_leaf(0);
    perform(Action::Group);
    EXPECT_EQ(text(), "union() {\n    translate([10, 0, 0]) cube([4, 2, 1]);\n} // here\n");
    perform(Action::MakeHull);
    EXPECT_EQ(text(), "hull() {\n    translate([10, 0, 0]) cube([4, 2, 1]);\n} // here\n");
    perform(Action::Ungroup);
    EXPECT_EQ(text(), "translate([10, 0, 0]) cube([4, 2, 1]); // here\n");
    select_leaf(0);
    perform(Action::MarkHighlight);
    EXPECT_EQ(text(), "#translate([10, 0, 0]) cube([4, 2, 1]); // here\n");
    perform(Action::MarkHighlight);
    EXPECT_EQ(text(), "translate([10, 0, 0]) cube([4, 2, 1]); // here\n");
    perform(Action::Ungroup);
    EXPECT_EQ(text(), "translate([10, 0, 0]) cube([4, 2, 1]); // here\n") << "which is told";
}

TEST_F(HandEditing, AllOfAGroupIsMoved) {
    const std::string group = "union() {\n    translate([0, 0, 0]) cube(1);\n    translate([3, 0, 0]) cube(1);\n}\n";
    open("cube(9);\n" + group);
    const csg::OccurrenceId whole =
        scene().occurrences[scene().occurrences[scene().leaves[1].occurrence].parent].parent;
    ASSERT_EQ(leaves_below(scene(), whole), 2U);
    session_->perform(SelectCall{whole, {}, "model.scad"});
    session_->perform(PutPart{{whole, {0, 5, 0}}});
    rest();
    EXPECT_EQ(text(), "cube(9);\ntranslate([0, 5, 0]) " + group);
}

TEST_F(HandEditing, WhatIsScaledChangesTheText) {
    open("cube(1);\ntranslate([2, 0, 0]) cube([4, 2, 1]); // here\n");
    select_leaf(1);
    HeldPart held{session_->selected_occurrence(), {}, {}, {2, 0, 0}};
    held.scale = {1.5, 1, 1};
    const glm::dmat4 motion = held.motion();
    EXPECT_EQ(glm::dvec3(motion * glm::dvec4(6, 2, 1, 1)), glm::dvec3(8, 2, 1)) << "as it is seen meanwhile";
    session_->perform(PutPart{held});
    rest();
    EXPECT_EQ(text(), "cube(1);\ntranslate([2, 0, 0]) cube([6, 2, 1]); // here\n");
    EXPECT_EQ(session_->editing().text().undo_what(), "scale cube");
}

TEST_F(HandEditing, ASideWhoseDimensionIsComputedIsDragged) {
    open("wall = 2;\ncube([3 * wall, 10, wall + 1]);\n");
    const csg::LeafInstance& leaf = scene().leaves[0];
    const auto sides = side_handles(*session_->document().model()->tree, leaf, {});
    ASSERT_EQ(sides.size(), 3U);
    EXPECT_EQ(sides[0].name, "x");
    EXPECT_EQ(sides[0].length, 6);
    EXPECT_EQ(sides[0].at, glm::dvec3(6, 5, 1.5));
    const HeldPart held = sides[0].moved_out(3);
    EXPECT_EQ(glm::dvec3(held.motion() * glm::dvec4(6, 10, 3, 1)), glm::dvec3(9, 10, 3));
    session_->perform(PutPart{held});
    rest();
    EXPECT_EQ(text(), "wall = 2;\ncube([4.5 * wall, 10, wall + 1]);\n");
    session_->perform(PutPart{sides[1].moved_out(-20)});  // There is nothing left of it.
    rest();
    EXPECT_EQ(text(), "wall = 2;\ncube([4.5 * wall, 10, wall + 1]);\n");
}

TEST_F(HandEditing, HandlesAreAtSidesThatNoNumberIsWrittenFor) {
    open("r = 3;\ncylinder(h = 10, r = r);\nsphere(2 * r);\nlinear_extrude(r) square(4);\n");
    const csg::Tree& tree = *session_->document().model()->tree;
    ShapeNumber height;
    height.along = {0, 0, 1};
    const auto of_cylinder = side_handles(tree, scene().leaves[0], {&height, 1});
    ASSERT_EQ(of_cylinder.size(), 1U);
    EXPECT_EQ(of_cylinder[0].name, "r");
    EXPECT_EQ(of_cylinder[0].length, 3);
    EXPECT_EQ(of_cylinder[0].moved_out(3).scale, glm::dvec3(2, 2, 1)) << "all around";
    const auto of_sphere = side_handles(tree, scene().leaves[1], {});
    ASSERT_EQ(of_sphere.size(), 1U);
    EXPECT_EQ(of_sphere[0].moved_out(6).scale, glm::dvec3(2));
    const auto of_extrusion = side_handles(tree, scene().leaves[2], {});
    ASSERT_EQ(of_extrusion.size(), 1U);
    EXPECT_EQ(of_extrusion[0].name, "h");
    EXPECT_EQ(of_extrusion[0].moved_out(1.5).scale, glm::dvec3(1, 1, 1.5));
}

TEST_F(HandEditing, WhatIsMovedComesToLieInLine) {
    open("cube([10, 20, 5]);\ntranslate([40, 0, 0]) cube(4);\n");
    const SnapPlaces places(*session_->document().model(), scene().leaves[1].occurrence);
    const auto beside = places.near(0, -29.5, 1);  // Its left side at the right one of the other.
    ASSERT_TRUE(beside);
    EXPECT_EQ(beside->by, -30);
    EXPECT_EQ(beside->own.x, 40);
    EXPECT_EQ(beside->other.x, 10);
    const auto middle = places.near(1, 8.25, 0.5);  // Middle to middle.
    ASSERT_TRUE(middle);
    EXPECT_EQ(middle->by, 8);
    EXPECT_FALSE(places.near(0, -15, 1)) << "nothing is there";
    EXPECT_EQ(places.near(2, -0.1, 0.5)->by, 0) << "it lies on the same plane already";
}

TEST_F(HandEditing, WhatIsMovedChangesTheText) {
    open("wall = 3;\ncube(1);\ntranslate([2 * wall, 0, 0]) cube(2); // here\n");
    move_leaf(1, {0, 5, 0});
    EXPECT_EQ(text(), "wall = 3;\ncube(1);\ntranslate([2 * wall, 5, 0]) cube(2); // here\n");
    EXPECT_EQ(glm::dvec3(scene().leaves[1].to_world[3]), glm::dvec3(6, 5, 0)) << "the model follows";
    EXPECT_EQ(session_->selected_occurrence(), scene().leaves[1].occurrence) << "it is selected still";
    EXPECT_FALSE(session_->held().any());
    EXPECT_EQ(folder_.read("model.scad").find("5"), std::string::npos) << "the file is not touched";
    move_leaf(1, {3, 0, 0});
    ASSERT_TRUE(session_->ways());
    ASSERT_GT(session_->ways()->ways.size(), 2U);
    const std::string first = text();
    std::size_t variable = 0;
    while (session_->ways()->ways[variable].kind != MoveWay::Kind::Variable) {
        ++variable;
    }
    perform(TakeWay{variable});
    EXPECT_EQ(text(), "wall = 4.5;\ncube(1);\ntranslate([2 * wall, 5, 0]) cube(2); // here\n");
    EXPECT_EQ(session_->editing().text().steps(), 2U) << "another way takes the place of the first";
    perform(Action::Undo);
    perform(Action::Undo);
    EXPECT_EQ(text(), folder_.read("model.scad"));
    EXPECT_FALSE(session_->editing().text().unsaved());
    perform(Action::Redo);
    perform(Action::Redo);
    perform(Action::Save);
    EXPECT_EQ(folder_.read("model.scad"), "wall = 4.5;\ncube(1);\ntranslate([2 * wall, 5, 0]) cube(2); // here\n");
    EXPECT_FALSE(session_->editing().text().unsaved());
}

TEST_F(HandEditing, WhatCannotBeMovedGoesBackAndSaysWhy) {
    folder_.write("part.scad", "cube(3);\n");
    open("include <part.scad>\n");
    move_leaf(0, {1, 0, 0});
    EXPECT_FALSE(session_->held().any());
    ASSERT_TRUE(session_->ways());
    if (session_->ways()->ways.empty()) {
        EXPECT_NE(session_->ways()->trouble, "");
        EXPECT_EQ(text(), "include <part.scad>\n");
    }
}

TEST_F(HandEditing, EditsAreOfOneTextWithIncludes) {
    folder_.write("part.scad", "module part() cube(3);\n");
    open("include <part.scad>\npart();\n");
    perform(Action::AddSphere);
    EXPECT_EQ(scene().leaves.size(), 2U) << "an include beside the file is found";
    folder_.write("part.scad", "module part() { cube(3); translate([9, 0, 0]) cube(3); }\n");
    wait_for_disk();
    EXPECT_EQ(scene().leaves.size(), 3U) << "and followed";
    EXPECT_TRUE(session_->editing().text().unsaved());
}

TEST_F(HandEditing, ShapesAreAddedAndTakenAway) {
    open("cube([40, 40, 10]);\n");
    perform(Action::AddCylinder);
    EXPECT_EQ(text(), "cube([40, 40, 10]);\ntranslate([45, 20, 0]) cylinder(h = 5, d = 5);\n");
    EXPECT_EQ(session_->selected_place(), "model.scad:2");
    select_leaf(0);
    session_->perform(Action::ToggleHole);
    perform(Action::AddCube);
    EXPECT_EQ(
        text(),
        "difference() {\n    cube([40, 40, 10]);\n    translate([20, 20, 10]) cube([5, 5, 5], center = true);\n}\n"
        "translate([45, 20, 0]) cylinder(h = 5, d = 5);\n");
    EXPECT_EQ(session_->selected_place(), "model.scad:3");
    EXPECT_EQ(scene().leaves.size(), 3U);
    perform(Action::Duplicate);
    EXPECT_EQ(session_->selected_place(), "model.scad:4");
    perform(Action::DeleteSelected);
    EXPECT_EQ(session_->selected_occurrence(), csg::kNoOccurrence);
    perform(Action::Undo);
    perform(Action::Undo);
    perform(Action::Undo);
    perform(Action::Undo);
    EXPECT_EQ(text(), "cube([40, 40, 10]);\n");
    EXPECT_EQ(scene().leaves.size(), 1U);
}

TEST_F(HandEditing, EveryShapeIsOneStatementThatRuns) {
    open("");
    std::size_t leaves = 0;
    for (const Action action : {Action::AddCube, Action::AddSphere, Action::AddCylinder, Action::AddCone,
                                Action::AddText, Action::AddExtrusion}) {
        perform(action);
        EXPECT_EQ(session_->document().messages().warnings() + session_->document().messages().errors(), 0U) << text();
        EXPECT_GT(scene().leaves.size(), leaves) << text();
        leaves = scene().leaves.size();
        EXPECT_NE(session_->selected_occurrence(), csg::kNoOccurrence);
    }
}

TEST_F(HandEditing, HolesInTurnedThingsLieWhereTheyAreSeen) {
    open("translate([100, 0, 0]) rotate([0, 0, 90]) { cube([40, 20, 10]); }\n");
    select_leaf(0);
    session_->perform(Action::ToggleHole);
    perform(Action::AddSphere);
    ASSERT_EQ(scene().leaves.size(), 2U);
    EXPECT_LT(glm::distance(glm::dvec3(scene().leaves[1].to_world[3]), glm::dvec3(90, 20, 10)), 1.0) << text();
}

/// "x 40 at [40, 15, 3]" and so on, of the first leaf of the text.
std::string numbers_of(const Session& session) {
    const Model& model = *session.document().model();
    const csg::NodeId node = model.scene.leaves[0].node;
    const std::string& text = session.editing().text().text();
    const auto numbers = model.program->look([&](const csg::scad::Program& program) {
        csg::SourceLocation where = model.tree->node(node).where;
        where.file = program.units[0].file;
        return shape_numbers(model.tree->shape(node), *csg::scad::call_at(program, where), text);
    });
    std::string all;
    for (const ShapeNumber& number : numbers) {
        const glm::dvec3& at = number.at;
        all += fmt::format("{} {} at [{}, {}, {}] ×{} \"{}\"; ", number.name, number.value, at.x, at.y, at.z,
                           number.per_unit, text.substr(number.bytes.begin, number.bytes.end - number.bytes.begin));
    }
    return all;
}

TEST_F(HandEditing, DimensionsAreNumbersOfTheCall) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"cube([40, 30, 6]);",
         "x 40 at [40, 15, 3] ×1 \"40\"; y 30 at [20, 30, 3] ×1 \"30\"; z 6 at [20, 15, 6] ×1 \"6\"; "},
        {"cube(center = true, size = 8.0);", "size 8 at [4, 0, 0] ×2 \"8.0\"; "},
        {"cube([a, 30, 2 * 3]); a = 4;", ""},
        {"sphere(5);", "r 5 at [5, 0, 0] ×1 \"5\"; "},
        {"sphere(d = 5);", "d 5 at [2.5, 0, 0] ×2 \"5\"; "},
        {"cylinder(10, 4, 2);",
         "h 10 at [0, 0, 10] ×1 \"10\"; r1 4 at [4, 0, 0] ×1 \"4\"; r2 2 at [2, 0, 10] ×1 \"2\"; "},
        {"cylinder(d = 6, h = 4, center = true);", "h 4 at [0, 0, 2] ×2 \"4\"; d 6 at [3, 0, 0] ×2 \"6\"; "},
        {"cylinder(h = 4, d1 = 6, d2 = 0);", "h 4 at [0, 0, 4] ×1 \"4\"; d1 6 at [3, 0, 0] ×2 \"6\"; "},
    };
    for (const auto& [text, numbers] : cases) {
        open(text);
        EXPECT_EQ(numbers_of(*session_), numbers) << text;
    }
}

TEST_F(HandEditing, ANumberThatIsDraggedIsOneStep) {
    open("cube([4, 30, 6]); // plate\n");
    select_leaf(0);
    for (const char* value : {"9", "10", "12.5"}) {
        session_->perform(SetNumber{{6, 7}, value, value == std::string("9"), "x"});
    }
    rest();
    EXPECT_EQ(text(), "cube([12.5, 30, 6]); // plate\n");
    EXPECT_EQ(session_->editing().text().steps(), 1U);
    EXPECT_NE(session_->selected_occurrence(), csg::kNoOccurrence) << "it is selected still";
    session_->perform(SetNumber{{6, 10}, "7", true, "x"});
    session_->perform(SetNumber{{6, 10}, "12.5", false, "x"});
    rest();
    EXPECT_EQ(session_->editing().text().steps(), 1U) << "it went back";
    perform(Action::Undo);
    EXPECT_EQ(text(), "cube([4, 30, 6]); // plate\n");
}

TEST_F(HandEditing, WhatOthersWriteIsMerged) {
    open("cube(1);\nsphere(2);\n");
    perform(TypeText{"cube(3);\nsphere(2);\n"});
    folder_.write("model.scad", "cube(1);\nsphere(7);\n");
    wait_for_disk();
    EXPECT_EQ(text(), "cube(3);\nsphere(7);\n");
    folder_.write("model.scad", "cube(8);\nsphere(7);\n");
    wait_for_disk();
    EXPECT_EQ(session_->editing().text().conflicts().size(), 1U);
    perform(Action::Save);
    EXPECT_EQ(folder_.read("model.scad"), "cube(8);\nsphere(7);\n") << "nothing is overwritten";
    perform(ResolveConflict{0, false});
    perform(Action::Save);
    EXPECT_EQ(folder_.read("model.scad"), "cube(3);\nsphere(7);\n");
    // Somebody is quicker than the look at the file.
    perform(TypeText{"cube(4);\nsphere(7);\n"});
    folder_.write("model.scad", "cube(3);\nsphere(7);\n// more\n");
    session_->perform(Action::Save);
    EXPECT_EQ(folder_.read("model.scad"), "cube(4);\nsphere(7);\n// more\n");
}

TEST_F(HandEditing, MarksAndLineEndsStay) {
    open(
        "\xEF\xBB\xBF"
        "cube(1);\r\n");
    perform(Action::AddCube);
    perform(Action::Save);
    const std::string saved = folder_.read("model.scad");
    EXPECT_TRUE(
        saved.starts_with("\xEF\xBB\xBF"
                          "cube(1);\r\ntranslate("));
    EXPECT_TRUE(saved.ends_with(";\r\n"));
}

TEST(TextCaretTest, MovesAndEdits) {
    using Way = TextCaret::Way;
    std::string text = "cube(1);\n  sphere(ä);\n";
    TextCaret caret;
    caret.move(text, Way::End, false);
    caret.move(text, Way::Up, false);
    EXPECT_EQ(caret.at(), 9U);
    caret.move(text, Way::LineBegin, false);
    EXPECT_EQ(caret.at(), 11U);
    caret.move(text, Way::LineEnd, true);
    EXPECT_EQ(text.substr(caret.begin(), caret.end() - caret.begin()), "sphere(ä);");
    caret.move(text, Way::Left, false);
    EXPECT_EQ(caret.at(), 11U) << "to where the selection begins";
    caret.put(20, false);
    caret.erase(text, Way::Left);
    EXPECT_EQ(text, "cube(1);\n  sphere();\n") << "all bytes of a character";
    caret.insert(text, "2");
    caret.move(text, Way::LineEnd, false);
    caret.new_line(text);
    EXPECT_EQ(text, "cube(1);\n  sphere(2);\n  \n");
    caret.select(0, text.size() - 1);
    caret.indent(text, false);
    EXPECT_EQ(text, "    cube(1);\n      sphere(2);\n      \n");
    caret.indent(text, true);
    EXPECT_EQ(text, "cube(1);\n  sphere(2);\n  \n");
    caret.select_word(text, 1);
    caret.insert(text, "box");
    EXPECT_EQ(text, "box(1);\n  sphere(2);\n  \n");
    caret.put(7, false);
    caret.move(text, Way::WordLeft, false);
    EXPECT_EQ(caret.at(), 4U);
}

TEST(TextCaretTest, Highlights) {
    EXPECT_EQ(highlighted("a = 1.5e-3; // x"), "    nnnnnn  cccc");
    EXPECT_EQ(highlighted("$fn=\"a\\\"\";if"), "$$$ sssss kk");
    EXPECT_EQ(highlighted("cube (x/*)*/)"), "ffff   ccccc ");
}

TEST(PaletteTest, FindsByLettersOfWords) {
    const auto first = [](const char* typed) {
        const auto entries = palette_entries(typed);
        return entries.empty() ? std::string("nothing") : entries.front().name;
    };
    EXPECT_EQ(first("cube"), "Add › Cube");
    EXPECT_EQ(first("cyl"), "Add › Cylinder");
    EXPECT_EQ(first("savpic"), "File › Save picture…");
    EXPECT_EQ(first("undo"), "Edit › Undo");
    EXPECT_EQ(first("top"), "View › Top");
    EXPECT_EQ(first("xyzzy"), "nothing");
    EXPECT_FALSE(fuzzy_score("ba", "abc"));
    EXPECT_GT(palette_entries("").size(), 50U);
}

TEST(MoveGizmoTest, GripsWhereItIsSeen) {
    const base::Camera camera;
    const Rectangle picture{{100, 50}, {800, 600}};
    const glm::dvec3 center(3, -2, 5);
    const MoveGizmo gizmo(camera, picture, center, 1);
    EXPECT_EQ(gizmo.handle_at(*gizmo.middle()), MoveHandle::Free);
    for (const MoveHandle handle : {MoveHandle::X, MoveHandle::Y, MoveHandle::Z}) {
        const auto tip = gizmo.tip(handle);
        ASSERT_TRUE(tip);
        EXPECT_EQ(gizmo.handle_at(glm::mix(*gizmo.middle(), *tip, 0.9)), handle);
        const auto grip = gizmo.grip(handle, *tip);
        ASSERT_TRUE(grip);
        const MoveGizmo there(camera, picture, center + *grip, 1);
        EXPECT_LT(glm::distance(*there.middle(), *tip), 1e-6) << "what is gripped stays under the pointer";
    }
    for (const MoveHandle plane : {MoveHandle::YZ, MoveHandle::ZX, MoveHandle::XY, MoveHandle::Free}) {
        const glm::dvec2 at = *gizmo.middle() + glm::dvec2(40, 30);
        const auto grip = gizmo.grip(plane, at);
        ASSERT_TRUE(grip);
        EXPECT_LT(glm::distance(*MoveGizmo(camera, picture, center + *grip, 1).middle(), at), 1e-6);
        const std::array<bool, 3> moves = axes_of(plane);
        for (int i = 0; i < 3; ++i) {
            EXPECT_TRUE(moves[static_cast<std::size_t>(i)] || std::abs((*grip)[i]) < 1e-9);
        }
    }
    base::Camera above = camera;
    above.rotation = glm::dvec3(0);
    const MoveGizmo from_above(above, picture, center, 1);
    EXPECT_FALSE(from_above.square(MoveHandle::YZ)) << "from its edge";
    EXPECT_TRUE(from_above.square(MoveHandle::XY));
    EXPECT_EQ(in_steps({1.26, 0.9, 3}, MoveHandle::X, 0.5), glm::dvec3(1.5, 0, 0));
    EXPECT_EQ(typed_way("-2.5", MoveHandle::Y, {0, 4, 0}), glm::dvec3(0, -2.5, 0));
    EXPECT_EQ(typed_way("7,", MoveHandle::ZX, {1, 0, 4}), glm::dvec3(7, 0, 4));
    EXPECT_EQ(typed_way("1,2,3", MoveHandle::Free, {}), glm::dvec3(1, 2, 3));
}

}  // namespace
}  // namespace ui
