// The window from outside: pictures, mouse and keys.
#include "tests/ui/viewer/window_fixture.h"

namespace ui {
namespace {

using Window = WindowFixture;

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
    // One style after the other; a frame of the one before may still come after the key.
    std::string style = frames().back().at("style");
    for (int i = 0; i < 30 && style != "blueprint"; ++i) {
        const std::size_t now = frames().size();
        robot("key s");
        style =
            wait_for(now, [&](const Json& frame) { return finished(frame) && frame.at("style") != style; }).at("style");
    }
    EXPECT_EQ(style, "blueprint");
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
    open();  // A style without parameters, so that the panel stays as it is.
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
    robot("mousemove 1174 339 click 1");  // Z: what is above the middle goes.
    EXPECT_TRUE(comes_to([&] { return count(is_cut) > 2 * cuts + 10000; })) << "the face of the section";
    const std::size_t half = count(is_face);
    robot("mousemove 1118 368 mousedown 1 mousemove 1100 368 mousemove 1080 368 mousemove 1050 368 mouseup 1");
    EXPECT_TRUE(comes_to([&] { return count(is_face) < half * 4 / 5 && count(is_cut) > 10000; })) << "deeper";
    robot("mousemove 1006 339 click 1");
    EXPECT_TRUE(comes_to([&] { return count(is_face) > faces - 50 && count(is_face) < faces + 50; })) << "whole again";
}

TEST_F(Window, TheMenuChoosesTheEngine) {
    open();
    EXPECT_EQ(wait_for_picture().at("engine"), "lists-cpu") << "the quickest where the processor computes OpenGL";
    const std::size_t faces = count(is_face);
    robot("mousemove 391 12 click 1");
    std::this_thread::sleep_for(1s);
    const std::size_t from = frames().size();
    robot("mousemove 419 83 click 1");
    wait_for(from, [](const Json& frame) { return finished(frame) && frame.at("engine") == "lists"; });
    std::this_thread::sleep_for(1s);
    EXPECT_NEAR(static_cast<double>(count(is_face)), static_cast<double>(faces), 0.01 * static_cast<double>(faces));
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

TEST_F(Window, WithoutDisplayItSaysWhatToDo) {
    program_ =
        std::make_unique<Process>(std::vector<std::string>{CSGSCOPE_PROGRAM, folder_.path("model.scad")},
                                  std::vector<std::string>{"DISPLAY", "WAYLAND_DISPLAY"}, folder_.path("output.txt"));
    EXPECT_EQ(program_->wait(kPatience), 1);
    EXPECT_NE(folder_.read("output.txt").find("-o picture.png"), std::string::npos) << folder_.read("output.txt");
}

}  // namespace
}  // namespace ui
