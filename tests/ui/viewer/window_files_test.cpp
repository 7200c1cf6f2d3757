// The window from outside: files that are opened, followed, customized, selected from, saved and exported.
#include "tests/ui/viewer/window_fixture.h"

namespace ui {
namespace {

using WindowFiles = WindowFixture;

TEST_F(WindowFiles, BeginsWithNothingAndOpensWhatIsTyped) {
    run({});
    ASSERT_TRUE(shows(kPanel, 10'000)) << "how to begin, in the middle";
    EXPECT_EQ(count(is_face), 0U);
    robot("key ctrl+o");
    std::this_thread::sleep_for(1500ms);
    robot("type --delay 40 '" + folder_.path("nothing.scad") + "'");
    robot("key Return");
    std::this_thread::sleep_for(1500ms);
    EXPECT_EQ(count(is_face), 0U) << "the form says that there is no such file";
    robot("key ctrl+a");
    robot("type --delay 40 '" + folder_.path("model.scad") + "'");
    robot("key Return");
    wait_for_picture();
    EXPECT_TRUE(shows_faces());
    EXPECT_EQ(folder_.read(".local/state/csgscope/recent"), folder_.path("model.scad") + "\n");
    folder_.write("model.scad", "sphere(10);");  // It is followed.
    const Json frame = frames().back();
    wait_for(frames().size(),
             [&](const Json& f) { return finished(f) && f.at("generation") > frame.at("generation"); });

    robot("key ctrl+q");
    ASSERT_EQ(program_->wait(kPatience), 0);
    run({});  // Now the file is offered.
    ASSERT_TRUE(shows(kPanel, 10'000));
    EXPECT_EQ(count(is_face), 0U);
    robot("mousemove 250 312 click 1");
    EXPECT_TRUE(shows_faces());
}

TEST_F(WindowFiles, TheCustomizerChangesTheSolidAndSavesASet) {
    folder_.write("model.scad", "size = 4; // [1:20]\ncube([size, size, size], center = true);\n");
    open({"--camera", "0,0,0,55,0,25,140"});
    const Json first = wait_for_picture();
    robot("key F7");
    const Json narrow = wait_for(frames().size(), [&](const Json& frame) {
        return finished(frame) && frame.at("width") < first.at("width") && frame.at("state") == "good";
    });
    const std::size_t before = count(is_face);
    ASSERT_GT(before, 100U);
    // The slider is dragged step by step; each step is another solid.
    robot("mousemove 170 152 mousedown 1");
    for (int x = 180; x <= 270; x += 15) {
        robot("mousemove " + std::to_string(x) + " 152");
        std::this_thread::sleep_for(150ms);
    }
    robot("mouseup 1");
    wait_for(frames().size(),
             [&](const Json& frame) { return finished(frame) && frame.at("generation") > narrow.at("generation"); });
    EXPECT_GT(count(is_face), 4 * before);
    robot("mousemove 60 94 click 1");
    robot("type --delay 40 'large'");
    robot("mousemove 172 94 click 1");
    const std::string sets = folder_.path("model.json");
    for (int i = 0; i < 100 && !std::filesystem::exists(sets); ++i) {
        std::this_thread::sleep_for(100ms);
    }
    const Json saved = Json::parse(folder_.read("model.json"));
    EXPECT_GT(std::stod(saved.at("parameterSets").at("large").at("size").get<std::string>()), 12);
}

TEST_F(WindowFiles, AClickTellsWhereTheSurfaceComesFrom) {
    folder_.write("model.scad",
                  "module hole() {\n    cylinder(r = 7, h = 40, center = true, $fn = 32);\n}\n"
                  "difference() {\n    cube(20, center = true);\n    hole();\n}\n");
    open({"--camera", "0,0,0,0,0,0,100", "--projection", "o"});
    wait_for_picture();
    robot("mousemove 485 100 click 1");  // Nothing is there.
    const auto selects = [&](const std::string& place) {
        return wait_for(0, [&](const Json& frame) { return frame.at("selected") == place; });
    };
    robot("mousemove 390 240 click 1");
    selects("model.scad:5");
    robot("key t");
    wait_for(0, [](const Json& frame) { return frame.at("text_line") == 5; });
    robot("key t key Escape");
    const std::size_t cleared = frames().size();
    wait_for(cleared, [](const Json& frame) { return frame.at("selected") == "" && frame.at("text_line") == -1; });
    robot("key 8");  // From the front; the third surface is the hole's, seen from within.
    wait_for_picture(frames().size());
    robot("mousemove 485 323 click 1");
    selects("model.scad:5");
    robot("mousemove 485 323 sleep 0.6 click 1");
    selects("model.scad:2");
}

TEST_F(WindowFiles, WhatAnOperationDoesIsShown) {
    open({"--camera", "0,0,0,55,0,25,140"});
    wait_for_picture();
    robot("mousemove 485 330 click 1");
    wait_for(0, [](const Json& frame) { return frame.at("selected") != ""; });
    ASSERT_TRUE(shows_removed(0, 100));
    // The rows of the bar: the leaf, and the difference with its button.
    robot("mousemove 60 602 click 1");
    EXPECT_TRUE(shows_removed(2000)) << "the bore";
    robot("key Escape");
    EXPECT_TRUE(shows_removed(0, 100));
}

TEST_F(WindowFiles, AMessageLeadsToItsLine) {
    folder_.write("model.scad", "cube(20);\n\necho(1);\nsphere(r = unknown);\n");
    open();
    wait_for(0, [](const Json& frame) { return frame.at("state") == "good" && frame.at("evaluating") == false; });
    for (const char* const y : {"664", "680", "696", "712"}) {  // What the console says of it has two lines and more.
        robot(std::string("mousemove 60 ").append(y).append(" click 1"));
        std::this_thread::sleep_for(100ms);
    }
    wait_for(0, [](const Json& frame) { return frame.at("text_line") == 4; });
}

TEST_F(WindowFiles, FollowsTheFileThroughAnErrorAndBack) {
    open({"--camera", "0,0,0,50,0,30,90"});
    const Json first = wait_for_picture();
    robot("mousemove 400 300 mousedown 1 mousemove_relative 60 0 mouseup 1");
    const Json turned =
        wait_for(0, [&](const Json& frame) { return finished(frame) && frame.at("camera") != first.at("camera"); });

    std::size_t from = frames().size();
    folder_.replace("model.scad", "cube(20, center = true);\ncube([1, 2, 3;\n");
    const Json failed = wait_for(from, [](const Json& frame) { return frame.at("state") == "failed"; });
    EXPECT_EQ(failed.at("generation"), turned.at("generation")) << "the last good model";
    EXPECT_EQ(failed.at("camera"), turned.at("camera"));
    EXPECT_TRUE(shows(kErrorBanner, 10'000));
    EXPECT_GT(count(is_cut), 1'000U) << "the hole of the last good model";

    from = frames().size();
    folder_.write("model.scad", "cube(20, center = true);\n");
    const Json repaired = wait_for_picture(from);
    EXPECT_NE(repaired.at("generation"), turned.at("generation"));
    EXPECT_EQ(repaired.at("camera"), turned.at("camera"));
    EXPECT_TRUE(shows(kErrorBanner, 0, 100));
    EXPECT_LT(count(is_cut), 200U) << "the hole is gone";
    EXPECT_GT(count(is_face), 20'000U);
}

TEST_F(WindowFiles, FollowsAFileThatIsUsed) {
    folder_.write("part.scad", "size = 20;\n");
    folder_.write("model.scad", "include <part.scad>\ncube(size, center = true);\n");
    open();
    const Json first = wait_for_picture();
    const std::size_t from = frames().size();
    folder_.replace("part.scad", "size = 10;\n");
    const Json second = wait_for(
        from, [&](const Json& frame) { return finished(frame) && frame.at("generation") != first.at("generation"); });
    EXPECT_EQ(second.at("camera"), first.at("camera"));
}

TEST_F(WindowFiles, AFileThatGoesAndComesBack) {
    open();
    wait_for_picture();
    std::size_t from = frames().size();
    folder_.remove("model.scad");
    wait_for(from, [](const Json& frame) { return frame.at("state") == "gone"; });
    EXPECT_TRUE(shows(kGoneBanner, 10'000));
    EXPECT_GT(count(is_face), 10'000U);
    from = frames().size();
    folder_.write("model.scad", kModel);
    wait_for_picture(from);
    EXPECT_TRUE(shows(kGoneBanner, 0, 100));
}

TEST_F(WindowFiles, AnEvaluationIsCanceled) {
    open();
    const Json good = wait_for_picture();
    folder_.write("model.scad", "function f(n) = n < 2 ? 1 : f(n - 1) + f(n - 2);\necho(f(70));\ncube(f(3));\n");
    wait_for(frames().size(), [](const Json& frame) { return frame.at("evaluating") == true; });
    std::size_t before = frames().size();
    std::this_thread::sleep_for(2s);
    EXPECT_LT(frames().size() - before, 20U) << "the seconds are counted, and nothing else is drawn";
    before = frames().size();
    robot("key Escape");
    const Json ended = wait_for(before, [](const Json& frame) { return frame.at("evaluating") == false; });
    EXPECT_EQ(ended.at("generation"), good.at("generation")) << "the model stays";
    EXPECT_TRUE(shows(kErrorBanner, 2000)) << "and the window says why";
    folder_.write("model.scad", "cube(25);\n");
    wait_for(before,
             [&](const Json& frame) { return finished(frame) && frame.at("generation") > good.at("generation"); });
    EXPECT_TRUE(shows(kErrorBanner, 0, 100));
}

TEST_F(WindowFiles, SavesThePicture) {
    open({"--style", "blueprint"});
    wait_for_picture();
    const std::string path = folder_.path("saved.png");
    robot("key ctrl+shift+s");
    ASSERT_TRUE(shows(kForm, 20'000));  // With the proposed name selected, so that typing replaces it.
    robot("type --delay 40 '" + path + "'");
    robot("key Return");
    for (int i = 0; i < 600 && !std::filesystem::exists(path); ++i) {
        std::this_thread::sleep_for(100ms);
    }
    const base::Image image = base::read_png(path);  // Complete as soon as it is there.
    const Json frame = frames().back();
    EXPECT_EQ(image.width, frame.at("width"));
    EXPECT_EQ(image.height, frame.at("height"));
    EXPECT_EQ(image.pixel(2, 2)[2], kBlueprint.b);
}

TEST_F(WindowFiles, ExportsWhatIsShown) {
    folder_.write("model.scad", "size = 4; // [1:20]\ncube(size);\n");
    open({"-D", "size=7"});
    wait_for_picture();
    robot("key ctrl+e");
    std::this_thread::sleep_for(1500ms);
    robot("key ctrl+a");
    robot("type --delay 40 '" + folder_.path("cube.off") + "'");
    robot("key Return");
    for (int i = 0; i < 300 && !std::filesystem::exists(folder_.path("cube.off")); ++i) {
        std::this_thread::sleep_for(100ms);
    }
    const std::string mesh = folder_.read("cube.off");
    EXPECT_NE(mesh.find("8 12 0"), std::string::npos) << mesh;
    EXPECT_NE(mesh.find("7 7 7"), std::string::npos) << mesh;
}

}  // namespace
}  // namespace ui
