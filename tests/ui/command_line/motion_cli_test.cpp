// csgscope motion as its users run it: text, JSON and errors. The motions themselves: tests/ui/pipeline/motion_test.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"
#include "tests/support/refusals.h"

namespace {

class MotionProgram : public test_support::ProgramTest {
  protected:
    MotionProgram() : ProgramTest(60) {
        folder_.write("door.scad",
                      "module door() cube([10, 1, 20]);\n"
                      "rotate(90 * $t) door();\n"
                      "translate([-1, 0, 0]) cube([1, 5, 20]);\n"
                      "if ($t > 0.5) translate([0, 0, 30]) sphere(2);\n");
    }
};

TEST_F(MotionProgram, TellsWhatMoves) {
    const Result result = run("motion door.scad");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("2 of 3 leaves move, as 2 bodies"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("door (door.scad:2:1)\n   turns by 90° about [0, 0, 1] through [0, 0, 0]\n"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("sphere (door.scad:4:1)\n   stays where it is\n   appears at $t = 0.5"),
              std::string::npos)
        << result.out;
    EXPECT_NE(run("motion door.scad --interval 0,0.4").out.find("as 1 body\n"), std::string::npos);
    EXPECT_NE(run("motion door.scad -D '$t=0.3;'").out.find("Nothing moves."), std::string::npos);
}

TEST_F(MotionProgram, WritesJson) {
    EXPECT_EQ(run("motion door.scad --format json -o motion.json --error 0.01").status, 0);
    const auto json = nlohmann::json::parse(folder_.read("motion.json"));
    EXPECT_EQ(json.at("leaves"), 3);
    EXPECT_EQ(json.at("still"), 1);
    const auto& door = json.at("bodies").at(0);
    EXPECT_EQ(door.at("name"), "door");
    EXPECT_EQ(door.at("line"), 2);
    EXPECT_EQ(door.at("motion").at("kind"), "turns");
    EXPECT_NEAR(door.at("motion").at("turned_net").get<double>(), 90, 1e-9);
    EXPECT_EQ(door.at("poses").size(), json.at("samples").get<std::size_t>());
    EXPECT_NEAR(door.at("poses").back().at("matrix").at(1).at(0).get<double>(), 1, 1e-12);
    const auto& sphere = json.at("bodies").at(1);
    EXPECT_EQ(sphere.at("events").at(0).at("kind"), "appears");
    EXPECT_TRUE(sphere.at("poses").at(0).at("matrix").is_null());
}

/// The pictures: tests/gallery.
TEST_F(MotionProgram, IsDepicted) {
    const std::string size = " --imgsize 60,60 ";
    EXPECT_EQ(run("door.scad -o plain.png" + size).status, 0);
    EXPECT_EQ(run("door.scad -o turned.png --time 1" + size).status, 0);
    EXPECT_EQ(run("door.scad -o arrow.png --depict 'rotation {door}'" + size).status, 0);
    EXPECT_NE(folder_.read("plain.png"), folder_.read("turned.png"));
    EXPECT_NE(folder_.read("plain.png"), folder_.read("arrow.png"));
    EXPECT_EQ(run("door.scad -o film.png --animate 2 --depict auto" + size).status, 0);
    EXPECT_NE(folder_.read("film00000.png"), folder_.read("film00001.png"));
    const auto sized = [&](const std::string& arguments) { return run(arguments + size); };
    test_support::expect_refused(sized, {{"door.scad -o x.png --depict 'paht {door}'", "Did you mean \"path\"?"},
                                         {"door.scad -o x.png --depict 'path {dor}'", "Did you mean \"door\"?"},
                                         {"door.scad -o x.stl --depict auto", "pictures"},
                                         {"door.scad -o x.png --animate 2 --time 1", "--animate"}});
}

/// Where they are: tests/ui/pipeline/annotation_test.
TEST_F(MotionProgram, WritesIntoPictures) {
    const std::string size = " --imgsize 160,120 ";
    folder_.write("rules.txt", "# of doors\nrotation {do*r}\nspeak {door} (text='I open')\nauto {*}\n");
    folder_.write("wrong.txt", "rotation {door}\n\n  path {door} [1\n");
    EXPECT_EQ(run("door.scad -o plain.png --parts top" + size).status, 0);
    for (const char* const options :
         {"--label 'door=A door'", "--callouts", "--arrow '0,0,0:5,5,20:0,0,30 (width=1)'", "--depict-rules rules.txt",
          "--depict 'ghost {door} (style=sketch)'",
          "--depict 'collision {door} (width=3)' -D 'translate([2,6,0]) cube([2,2,20]);'"}) {
        const Result result = run(std::string("door.scad -o drawn.png ") + options + size);
        EXPECT_EQ(result.status, 0) << options << result.err;
        EXPECT_NE(folder_.read("plain.png"), folder_.read("drawn.png")) << options;
    }
    const std::string drawn = "door.scad -o x.png ";
    const auto sized = [&](const std::string& arguments) { return run(arguments + size); };
    test_support::expect_refused(sized, {{drawn + "--label 'doro=A door'", "Did you mean \"door\"?"},
                                         {drawn + "--label door", "expected PART=TEXT"},
                                         {drawn + "--arrow 0,0,0", "two points"},
                                         {drawn + "--arrow '0,0,0:1,1,1 (size=2)'", "width=LENGTH or color=COLOR"},
                                         {drawn + "--arrow '0,0,0:1,1'", "expected x,y,z:x,y,z"},
                                         {drawn + "--callouts --plan top", "--plan"},
                                         {drawn + "--depict 'collision {door}'", "begins to touch nothing"},
                                         {drawn + "--depict 'ghost {door} (style=sketsh)'", "Did you mean \"sketch\"?"},
                                         {drawn + "--depict camera", "the camera stays where it is"},
                                         {drawn + "--depict-rules wrong.txt", "wrong.txt:3:17: expected ']'"},
                                         {drawn + "--storyboard 4 --time 1", "--storyboard"}});
}

TEST_F(MotionProgram, DrawsStoryboards) {
    const Result result = run("door.scad -o board.png --storyboard 3 --imgsize 400,300");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(run("door.scad -o again.png --storyboard 3 --imgsize 400,300").status, 0);
    EXPECT_EQ(folder_.read("board.png"), folder_.read("again.png"));
    EXPECT_NE(run("door.scad -o x.png --storyboard 30 --imgsize 100,100").err.find("make the picture larger"),
              std::string::npos);
}

/// Their frames: tests/base/apng_test and film_test.
TEST_F(MotionProgram, WritesFilms) {
    EXPECT_EQ(run("door.scad -o film.apng --animate 3 --fps 10 --imgsize 40,40").status, 0);
    EXPECT_EQ(run("door.scad -o film.gif -o film.webp --animate 3 --imgsize 40,40").status, 0);
    EXPECT_EQ(folder_.read("film.gif").substr(0, 6), "GIF89a");
    EXPECT_EQ(folder_.read("film.webp").substr(8, 4), "WEBP");
    EXPECT_EQ(run("door.scad -o turn.apng -o turn.png --turntable 3 --imgsize 40,40").status, 0);
    for (const char* const film : {"film.apng", "turn.apng"}) {
        std::size_t frames = 0;
        const std::string bytes = folder_.read(film);
        for (std::size_t at = 0; (at = bytes.find("fcTL", at)) != std::string::npos; ++at) {
            ++frames;
        }
        EXPECT_EQ(frames, 3u) << film;
    }
    EXPECT_TRUE(std::filesystem::exists(folder_.path("turn00002.png")));
    EXPECT_EQ(run("door.scad -o one.apng --imgsize 40,40").status, 0);
    EXPECT_EQ(run("door.scad -o x.apng --animate 4 --animate_sharding 1/2").status, 1);
    EXPECT_EQ(run("door.scad -o x.apng --animate 4 --fps 0").status, 1);
    // A film that is not finished is no file.
    folder_.write("ends.scad", "assert($t < 0.5); cube($t + 1);");
    EXPECT_EQ(run("ends.scad -o ends.apng --animate 4 --imgsize 20,20").status, 1);
    EXPECT_FALSE(std::filesystem::exists(folder_.path("ends.apng")));
}

/// That pictures are the same all the same: tests/ui/pipeline/moving_model_test.
TEST_F(MotionProgram, MakesNothingAgainThatStays) {
    folder_.write("wheel.scad", "translate([-9, -9, -2]) cube([18, 18, 1]); rotate(90 * $t) cube([5, 1, 1]);");
    const auto film = [&](const std::string& model) {
        EXPECT_EQ(run(model + " -o film.png --animate 5 --imgsize 40,40 --stats stats.json").status, 0);
        return nlohmann::json::parse(folder_.read("stats.json")).at("film");
    };
    const auto wheel = film("wheel.scad");
    EXPECT_EQ(wheel.at("frames"), 5);
    EXPECT_EQ(wheel.at("drawn"), 5);
    EXPECT_EQ(wheel.at("leaves_placed"), 2 + 4) << "both, and then the one that turns";
    EXPECT_EQ(wheel.at("leaves_kept"), 4);
    EXPECT_EQ(run("wheel.scad -o one.png --time 0.6 --imgsize 40,40").status, 0);
    EXPECT_EQ(folder_.read("one.png"), folder_.read("film00003.png"));
    folder_.write("still.scad", "cube(3);");
    const auto still = film("still.scad");
    EXPECT_EQ(still.at("drawn"), 1);
    EXPECT_EQ(still.at("leaves_placed"), 1);
    EXPECT_EQ(folder_.read("film00000.png"), folder_.read("film00004.png"));
}

TEST_F(MotionProgram, RefusesWhatItCannotDo) {
    for (const char* const bad :
         {"motion", "motion none.scad", "motion door.scad --interval 1,0", "motion door.scad --interval 1",
          "motion door.scad --error 0", "motion door.scad --eror 1", "motion door.scad -D 'a=['"}) {
        const Result result = run(bad);
        EXPECT_EQ(result.status, 1) << bad;
        EXPECT_NE(result.err, "") << bad;
    }
    EXPECT_NE(run("motion door.scad --eror 1").err.find("--error"), std::string::npos);
    folder_.write("slow.scad", "function f(n) = n < 2 ? 1 : f(n - 1) + f(n - 2); cube(f(40) + $t);");
    const Result slow = run("motion slow.scad --time-limit 0.5");
    EXPECT_EQ(slow.status, 1);
    EXPECT_NE(slow.err.find("time"), std::string::npos) << slow.err;
    // What every run has to say is said once.
    folder_.write("warns.scad", "echo(x); translate([$t, 0, 0]) cube(1);");
    const Result warns = run("motion warns.scad");
    EXPECT_EQ(warns.status, 0);
    EXPECT_NE(warns.err.find("unknown variable"), std::string::npos) << warns.err;
    EXPECT_EQ(warns.err.find("unknown variable"), warns.err.rfind("unknown variable")) << warns.err;
}

}  // namespace
