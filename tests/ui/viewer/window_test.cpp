// The window from outside: a real X server, a real keyboard and mouse as far as the program can tell, pixels and the
// log of frames as evidence.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/support/gl_test.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/viewer/x_display.h"

namespace ui {
namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;

const std::string kModel =
    "difference() {\n"
    "    cube(20, center = true);\n"
    "    cylinder(r = 7, h = 40, center = true, $fn = 32);\n"
    "}\n";
constexpr auto kPatience = 60s;  // Software renderers on busy machines.

struct Color {
    int r, g, b;
};
constexpr Color kCornfield{255, 255, 229}, kBlueprint{27, 63, 139}, kErrorBanner{189, 38, 38},
    kGoneBanner{179, 115, 15}, kForm{38, 42, 48}, kPanel{33, 36, 41};

/// Yellow of added leaves and green of subtracted ones, in any light.
bool is_face(const std::uint8_t* p) {
    return p[0] > p[1] && p[1] > 80 && p[2] < p[1] / 2;
}
bool is_cut(const std::uint8_t* p) {
    return p[1] > p[0] && p[0] > 50 && p[2] < p[1] * 3 / 4 && p[1] > 80;
}

class Window : public testing::Test {
  protected:
    void SetUp() override {
        const std::string missing = XDisplay::missing_program();
        if (!missing.empty()) {
            test_support::skip_or_fail(missing + " is not installed");
            return;
        }
        display_ = std::make_unique<XDisplay>(folder_.path(""));
        folder_.write("model.scad", kModel);
    }

    void open(std::vector<std::string> more = {}) {
        more.insert(more.begin(), folder_.path("model.scad"));
        run(more);
    }
    void run(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{CSGSCOPE_PROGRAM, "--log-frames", folder_.path("frames.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        program_ = std::make_unique<Process>(arguments,
                                             std::vector<std::string>{"DISPLAY=" + display_->name(), "WAYLAND_DISPLAY",
                                                                      "XDG_STATE_HOME", "HOME=" + folder_.path("")},
                                             folder_.path("output.txt"));
        robot("mousemove 480 300");  // Without a window manager the keyboard follows the pointer.
    }
    void robot(const std::string& commands) const { display_->robot(commands); }

    std::vector<Json> frames() const {
        std::vector<Json> all;
        std::istringstream lines(folder_.read("frames.json"));
        for (std::string line; std::getline(lines, line);) {
            if (!lines.eof()) {  // The last line may be half written.
                all.push_back(Json::parse(line));
            }
        }
        return all;
    }
    /// Waits for a frame after the first `from` that is as wanted, and gives it; fails where none comes.
    Json wait_for(std::size_t from, const std::function<bool(const Json&)>& wanted) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        do {
            const auto all = frames();
            for (std::size_t i = from; i < all.size(); ++i) {
                if (wanted(all[i])) {
                    return all[i];
                }
            }
            if (const auto status = program_->wait(0s)) {
                ADD_FAILURE() << "the program has ended with " << *status << ": " << folder_.read("output.txt");
                return {};
            }
            std::this_thread::sleep_for(50ms);
        } while (std::chrono::steady_clock::now() < end);
        ADD_FAILURE() << "no such frame; the last: " << (frames().empty() ? Json() : frames().back());
        return {};
    }
    /// A whole picture of a good model, after the first `from` frames.
    Json wait_for_picture(std::size_t from = 0) {
        return wait_for(from, [](const Json& frame) { return finished(frame) && frame.at("state") == "good"; });
    }
    static bool finished(const Json& frame) {
        return frame.at("current") == true && frame.at("divisor") == 1 &&
               frame.at("samples") == frame.at("wanted_samples");
    }

    /// How many pixels of the screen are so.
    template <typename Wanted>
    std::size_t count(Wanted&& wanted) const {
        const base::Image image = display_->screenshot();
        std::size_t found = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
            found += wanted(&image.rgba[i]) ? 1 : 0;
        }
        return found;
    }
    std::size_t count(const Color& color) const {
        return count([&](const std::uint8_t* p) {
            return std::abs(p[0] - color.r) <= 2 && std::abs(p[1] - color.g) <= 2 && std::abs(p[2] - color.b) <= 2;
        });
    }
    /// Waits until the screen shows so many pixels of a color; frames are logged a moment before they are seen.
    testing::AssertionResult shows(const Color& color, std::size_t least, std::size_t most = ~std::size_t{0}) const {
        std::size_t found = 0;
        for (int i = 0; i < 50; ++i) {
            found = count(color);
            if (found >= least && found <= most) {
                return testing::AssertionSuccess();
            }
            std::this_thread::sleep_for(100ms);
        }
        return testing::AssertionFailure() << found << " pixels instead of " << least << " to " << most;
    }

    /// Red that is seen through, as what a difference removes.
    testing::AssertionResult shows_removed(std::size_t least, std::size_t most = ~std::size_t{0}) const {
        std::size_t found = 0;
        for (int i = 0; i < 100; ++i) {
            found =
                count([](const std::uint8_t* p) { return p[0] > 110 && p[1] < p[0] * 2 / 3 && p[2] < p[0] / 2 + 20; });
            if (found >= least && found <= most) {
                return testing::AssertionSuccess();
            }
            std::this_thread::sleep_for(100ms);
        }
        return testing::AssertionFailure() << found << " red pixels";
    }
    testing::AssertionResult shows_faces() const {
        for (int i = 0; i < 100; ++i) {
            if (count(is_face) > 10'000) {
                return testing::AssertionSuccess();
            }
            std::this_thread::sleep_for(100ms);
        }
        return testing::AssertionFailure() << count(is_face) << " pixels of faces";
    }

    test_support::TemporaryFolder folder_;
    std::unique_ptr<XDisplay> display_;
    std::unique_ptr<Process> program_;
};

TEST_F(Window, ShowsTheModelAndRests) {
    open();
    const Json frame = wait_for_picture();
    EXPECT_EQ(frame.at("samples"), 4);
    EXPECT_EQ(frame.at("style"), "shaded");
    EXPECT_TRUE(shows(kCornfield, 100'000));
    EXPECT_GT(count(is_face), 20'000U);
    EXPECT_GT(count(is_cut), 1'000U);

    std::this_thread::sleep_for(500ms);
    const std::size_t before = frames().size();
    const double busy = program_->processor_seconds();
    std::this_thread::sleep_for(2s);
    EXPECT_EQ(frames().size(), before) << "nothing changes, nothing is drawn";
    EXPECT_LT(program_->processor_seconds() - busy, 0.1);

    robot("key ctrl+q");
    EXPECT_EQ(program_->wait(kPatience), 0);
}

TEST_F(Window, MouseAndKeysChangeTheView) {
    open();
    const Json first = wait_for_picture();
    std::size_t from = frames().size();
    robot("mousemove 60 80 mousedown 1");  // Beside the model: the camera turns about its target.
    for (int i = 0; i < 10; ++i) {
        robot("mousemove_relative 6 4");
    }
    robot("mouseup 1");
    // 0.7 degrees per pixel.
    Json turned = wait_for(from, [&](const Json& frame) {
        return std::abs(frame.at("camera").at("rotation")[0].get<double>() - (55 - 0.7 * 40)) < 0.01;
    });
    EXPECT_NEAR(turned.at("camera").at("rotation")[2].get<double>(), 360 + 25 - 0.7 * 60, 0.01);
    EXPECT_EQ(turned.at("camera").at("translation"), first.at("camera").at("translation"));
    const Json rested =
        wait_for(from, [&](const Json& frame) { return finished(frame) && frame.at("camera") == turned.at("camera"); });
    EXPECT_EQ(rested.at("samples"), 4);
    const std::vector<Json> all_frames = frames();
    for (std::size_t i = from; i < all_frames.size(); ++i) {
        if (all_frames[i].at("camera") != all_frames[i - 1].at("camera")) {
            EXPECT_TRUE(all_frames[i].at("current") == false || all_frames[i].at("samples") == 1)
                << "a picture of a new camera begins with one sample";
        }
    }

    from = frames().size();
    robot("click 4 click 4");  // At the same place.
    const double distance = turned.at("camera").at("distance");
    wait_for(from, [&](const Json& frame) {
        return std::abs(frame.at("camera").at("distance").get<double>() * 1.15 * 1.15 - distance) < 1e-6;
    });

    // On the model it turns about what is under the pointer.
    from = frames().size();
    robot("mousemove 430 300 mousedown 1 sleep 0.5 mousemove_relative 20 0 mouseup 1");
    const Json about = wait_for(from, [&](const Json& frame) {
        return frame.at("camera").at("rotation") != turned.at("camera").at("rotation") && finished(frame);
    });
    EXPECT_NE(about.at("camera").at("translation"), turned.at("camera").at("translation"));
    turned = about;

    from = frames().size();
    robot("mousemove 400 300 mousedown 3 mousemove_relative 50 0 mouseup 3");
    wait_for(from, [&](const Json& frame) {
        return frame.at("camera").at("rotation") == turned.at("camera").at("rotation") &&
               frame.at("camera").at("translation") != turned.at("camera").at("translation");
    });

    from = frames().size();
    robot("key ctrl+4");
    wait_for(from, [](const Json& frame) { return frame.at("camera").at("rotation") == Json({0, 0, 0}); });
    robot("key p");
    wait_for(from, [](const Json& frame) { return frame.at("camera").at("projection") == "orthographic"; });
    robot("key Home");
    const Json all = wait_for(from, [&](const Json& frame) {
        return finished(frame) && frame.at("camera").at("translation") == first.at("camera").at("translation");
    });
    EXPECT_EQ(all.at("camera").at("projection"), "orthographic");
}

TEST_F(Window, ADoubleClickCentersThePointOfTheModel) {
    open({"--camera", "0,0,0,0,0,0,100", "--projection", "o"});
    const Json first = wait_for_picture();
    const std::size_t from = frames().size();
    // From the top the corner at (9, 9) of the cube's upper face is right of and above the middle.
    robot("mousemove 600 180 click 1 click 1");
    const Json centered = wait_for(from, [&](const Json& frame) {
        return frame.at("camera").at("translation") != first.at("camera").at("translation");
    });
    const Json at = centered.at("camera").at("translation");
    EXPECT_NEAR(at[2].get<double>(), 10, 0.01) << "on the upper face";
    EXPECT_GT(at[0].get<double>(), 2);
    EXPECT_GT(at[1].get<double>(), 2);
}

TEST_F(Window, AKeyChangesTheStyle) {
    open();
    wait_for_picture();
    const std::size_t from = frames().size();
    for (int i = 0; i < 20; ++i) {
        const std::size_t now = frames().size();
        robot("key s");
        const Json frame = wait_for(now, [](const Json& each) { return finished(each); });
        if (frame.at("style") == "blueprint") {
            break;
        }
    }
    wait_for(from, [](const Json& frame) { return finished(frame) && frame.at("style") == "blueprint"; });
    EXPECT_TRUE(shows(kBlueprint, 100'000));
    EXPECT_TRUE(shows(kCornfield, 0, 1'000));
}

TEST_F(Window, FastClicksAreAllSeen) {
    open();
    wait_for_picture();
    std::string clicks;
    constexpr int kClicks = 100;
    for (int i = 0; i < kClicks; ++i) {
        clicks += i % 2 == 0 ? "mousemove 1118 74 click 1 " : "mousemove 1025 74 click 1 ";  // Edges, Shaded.
    }
    robot(clicks);
    const auto changes = [&] {
        int count = 0;
        std::string style = "shaded";
        for (const Json& frame : frames()) {
            count += frame.at("style") != style ? 1 : 0;
            style = frame.at("style");
        }
        return count;
    };
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (changes() < kClicks && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_EQ(changes(), kClicks);
}

TEST_F(Window, HoveringDrawsNothing) {
    open();
    wait_for_picture();
    robot("mousemove 300 300 mousemove 310 300");
    std::this_thread::sleep_for(500ms);
    const std::size_t before = frames().size();
    for (int i = 0; i < 10; ++i) {
        robot("mousemove " + std::to_string(200 + 30 * i) + " 200");
        std::this_thread::sleep_for(30ms);
    }
    std::this_thread::sleep_for(500ms);
    const std::size_t hovered = frames().size();
    EXPECT_LE(hovered, before + 3);
    robot("mousemove 1118 74");  // But a button lights up under the pointer.
    std::this_thread::sleep_for(500ms);
    EXPECT_GT(frames().size(), hovered);
}

TEST_F(Window, ASectionIsCutAndDragged) {
    open({"--style", "edges"});
    wait_for_picture();
    const std::size_t cuts = count(is_cut), faces = count(is_face);
    ASSERT_GT(faces, 20000U);
    const auto comes_to = [&](auto&& condition) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (!condition() && std::chrono::steady_clock::now() < end) {
            std::this_thread::sleep_for(100ms);
        }
        return condition();
    };
    robot("mousemove 1174 600 click 1");  // Z: what is above the middle goes.
    EXPECT_TRUE(comes_to([&] { return count(is_cut) > 2 * cuts + 10000; })) << "the face of the section";
    const std::size_t half = count(is_face);
    robot("mousemove 1118 629 mousedown 1 mousemove 1100 629 mousemove 1080 629 mousemove 1050 629 mouseup 1");
    EXPECT_TRUE(comes_to([&] { return count(is_face) < half * 4 / 5 && count(is_cut) > 10000; })) << "deeper";
    robot("mousemove 1006 600 click 1");
    EXPECT_TRUE(comes_to([&] { return count(is_face) > faces - 50 && count(is_face) < faces + 50; })) << "whole again";
}

TEST_F(Window, BeginsWithNothingAndOpensWhatIsTyped) {
    run({});
    ASSERT_TRUE(shows(kPanel, 10'000)) << "how to begin, in the middle";
    EXPECT_EQ(count(is_face), 0U);
    robot("key ctrl+o");
    std::this_thread::sleep_for(500ms);
    robot("type --delay 40 '" + folder_.path("nothing.scad") + "'");
    robot("key Return");
    std::this_thread::sleep_for(500ms);
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

TEST_F(Window, TheCustomizerChangesTheSolidAndSavesASet) {
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

TEST_F(Window, AClickTellsWhereTheSurfaceComesFrom) {
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

TEST_F(Window, WhatAnOperationDoesIsShown) {
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

TEST_F(Window, AMessageLeadsToItsLine) {
    folder_.write("model.scad", "cube(20);\n\necho(1);\nsphere(r = unknown);\n");
    open();
    wait_for(0, [](const Json& frame) { return frame.at("state") == "good" && frame.at("evaluating") == false; });
    for (const char* const y : {"664", "680", "696", "712"}) {  // What the console says of it has two lines and more.
        robot(std::string("mousemove 60 ").append(y).append(" click 1"));
        std::this_thread::sleep_for(100ms);
    }
    wait_for(0, [](const Json& frame) { return frame.at("text_line") == 4; });
}

TEST_F(Window, TheMenuChoosesTheEngine) {
    open();
    EXPECT_EQ(wait_for_picture().at("engine"), "lists-cpu") << "the quickest where the processor computes OpenGL";
    const std::size_t faces = count(is_face);
    robot("mousemove 222 12 click 1");
    std::this_thread::sleep_for(1s);
    const std::size_t from = frames().size();
    robot("mousemove 250 83 click 1");
    wait_for(from, [](const Json& frame) { return finished(frame) && frame.at("engine") == "lists"; });
    std::this_thread::sleep_for(1s);
    EXPECT_NEAR(static_cast<double>(count(is_face)), static_cast<double>(faces), 0.01 * static_cast<double>(faces));
}

TEST_F(Window, FollowsTheFileThroughAnErrorAndBack) {
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

TEST_F(Window, FollowsAFileThatIsUsed) {
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

TEST_F(Window, AFileThatGoesAndComesBack) {
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

TEST_F(Window, DoesNotWaitForTheEvaluation) {
    open();
    const Json first = wait_for_picture();
    std::size_t from = frames().size();
    folder_.replace("model.scad",
                    "function f(n, s = 0) = n == 0 ? s : f(n - 1, s + sin(n));\n"
                    "for (i = [0 : 10000]) echo(f(900000 + i));\ncube(5);\n");
    wait_for(from, [](const Json& frame) { return frame.at("evaluating") == true; });
    from = frames().size();
    robot("mousemove 400 300 mousedown 1 mousemove_relative 30 0 mouseup 1");
    const Json turned = wait_for(from, [&](const Json& frame) {
        return frame.at("camera") != first.at("camera") && frame.at("evaluating") == true;
    });
    EXPECT_EQ(turned.at("generation"), first.at("generation"));

    from = frames().size();
    folder_.replace("model.scad", "cube(5);\n");  // Stops the long evaluation.
    wait_for(from, [&](const Json& frame) {
        return frame.at("generation") != first.at("generation") && frame.at("evaluating") == false;
    });
}

TEST_F(Window, AnEvaluationIsCancelled) {
    open();
    const Json good = wait_for_picture();
    folder_.write("model.scad", "function f(n) = n < 2 ? 1 : f(n - 1) + f(n - 2);\necho(f(70));\ncube(f(3));\n");
    wait_for(frames().size(), [](const Json& frame) { return frame.at("evaluating") == true; });
    const std::size_t before = frames().size();
    robot("key Escape");
    const Json ended = wait_for(before, [](const Json& frame) { return frame.at("evaluating") == false; });
    EXPECT_EQ(ended.at("generation"), good.at("generation")) << "the model stays";
    EXPECT_TRUE(shows(kErrorBanner, 2000)) << "and the window says why";
    folder_.write("model.scad", "cube(25);\n");
    wait_for(before,
             [&](const Json& frame) { return finished(frame) && frame.at("generation") > good.at("generation"); });
    EXPECT_TRUE(shows(kErrorBanner, 0, 100));
}

TEST_F(Window, DoesNotWaitForThePicture) {
    open();
    const Json first = wait_for_picture();
    std::size_t from = frames().size();
    // Thousands of surfaces in every pixel: one sample takes longer than all that follows.
    folder_.replace("model.scad", "for (i = [0 : 4000]) cube([20, 20, 20 + i / 1000], center = true);\n");
    wait_for(from, [&](const Json& frame) {
        return frame.at("generation") != first.at("generation") && frame.at("current") == false;
    });
    from = frames().size();
    robot("mousemove 400 300 mousedown 1 mousemove_relative 30 0 mouseup 1");
    wait_for(from, [&](const Json& frame) {
        return frame.at("camera") != first.at("camera") && frame.at("current") == false && frame.at("picture_ms") == 0;
    });
    robot("key ctrl+q");
    EXPECT_EQ(program_->wait(kPatience), 0);
}

TEST_F(Window, SavesThePicture) {
    open({"--style", "blueprint"});
    wait_for_picture();
    const std::string path = folder_.path("saved.png");
    robot("key ctrl+s");
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

TEST_F(Window, ExportsWhatIsShown) {
    folder_.write("model.scad", "size = 4; // [1:20]\ncube(size);\n");
    open({"-D", "size=7"});
    wait_for_picture();
    robot("key ctrl+e");
    std::this_thread::sleep_for(500ms);
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

TEST_F(Window, WithoutDisplayItSaysWhatToDo) {
    program_ =
        std::make_unique<Process>(std::vector<std::string>{CSGSCOPE_PROGRAM, folder_.path("model.scad")},
                                  std::vector<std::string>{"DISPLAY", "WAYLAND_DISPLAY"}, folder_.path("output.txt"));
    EXPECT_EQ(program_->wait(kPatience), 1);
    EXPECT_NE(folder_.read("output.txt").find("-o picture.png"), std::string::npos) << folder_.read("output.txt");
}

}  // namespace
}  // namespace ui
