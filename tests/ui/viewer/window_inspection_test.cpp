// Thickness, checks, measures and changes in the window.
#include "tests/ui/viewer/window_fixture.h"

namespace ui {
namespace {

constexpr const char* kBox =
    "module box() difference() {\n"
    "    cube([40, 30, 12]);\n"
    "    translate([0.4, 2, 2]) cube([36, 26, 20]);\n"
    "}\n"
    "box();\n";

class WindowInspection : public WindowFixture {
  protected:
    void open_panel() {
        folder_.write("model.scad", kBox);
        open();
        wait_for_picture();
        robot("key i");
        std::this_thread::sleep_for(1500ms);
    }
    void open_tab(int x) {
        robot("mousemove " + std::to_string(x) + " 45 sleep 0.3 click 1");
        std::this_thread::sleep_for(1500ms);
    }
    Json wait_for_inspection(std::size_t from, const std::function<bool(const Json&)>& wanted) {
        return wait_for(from, [&](const Json& frame) { return wanted(frame.at("inspection")); });
    }
    static bool is_red(const std::uint8_t* p) { return p[0] > 100 && p[1] < p[0] / 3 && p[2] < p[0] / 3; }
    static bool is_blue(const std::uint8_t* p) { return p[2] > 90 && p[0] < p[2] * 3 / 4 && p[1] < p[2]; }
    static bool is_green(const std::uint8_t* p) { return p[1] > 90 && p[0] < p[1] * 3 / 4 && p[2] < p[1] * 3 / 4; }
};

TEST_F(WindowInspection, WallsAreSeenInTones) {
    open_panel();
    const std::size_t blue = count(is_blue);
    std::size_t from = frames().size();
    robot("mousemove 994 103 click 1");  // Walls, across faces.
    wait_for(from, [](const Json& frame) { return finished(frame) && frame.at("inspection").at("range") > 0; });
    EXPECT_GT(frames().back().at("inspection").at("thin_places"), 0);
    for (int i = 0; i < 50 && count(is_face) > 2000; ++i) {
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_LT(count(is_face), 2000U) << "the model's colors are gone; thin places are yellow";
    EXPECT_GT(count(is_blue), blue + 20'000);
    from = frames().size();
    robot("mousemove 1020 274 click 1");  // The thinnest place.
    wait_for_inspection(from, [](const Json& inspection) { return inspection.at("marked") == "0.4 mm"; });
    EXPECT_TRUE(frames().back().at("selected").get<std::string>().starts_with("model.scad:"));
    robot("mousemove 994 74 click 1");
    EXPECT_TRUE(shows_faces());
    wait_for_inspection(frames().size() - 1, [](const Json& inspection) { return inspection.at("range") == 0; });
}

TEST_F(WindowInspection, AFindingIsTurnedToAndItsLineShown) {
    open_panel();
    const Json first = frames().back();
    open_tab(1086);  // Checks; walls thinner than 0.8 and others.
    std::size_t from = frames().size();
    robot("mousemove 1120 74 click 1");
    wait_for_inspection(from, [](const Json& inspection) { return inspection.at("findings") == 1; });
    std::this_thread::sleep_for(500ms);
    from = frames().size();
    robot("mousemove 1120 500 click 1");
    const Json shown = wait_for(from, [](const Json& frame) {
        return frame.at("inspection").at("marked") == "thin wall, 0.4 mm, limit 0.8" && frame.at("text_line") >= 2 &&
               finished(frame);
    });
    EXPECT_TRUE(shown.at("selected") == "model.scad:2" || shown.at("selected") == "model.scad:3");
    EXPECT_NE(shown.at("camera").at("rotation"), first.at("camera").at("rotation"));
    EXPECT_NEAR(shown.at("camera").at("translation")[0], 0.2, 1e-6) << "the middle of the wall";
    from = frames().size();
    robot("key Escape");
    wait_for(from,
             [](const Json& frame) { return frame.at("inspection").at("marked") == "" && frame.at("selected") == ""; });
}

TEST_F(WindowInspection, MeasuresAreMade) {
    open_panel();
    open_tab(1160);
    std::size_t from = frames().size();
    robot("mousemove 1120 74 click 1");
    const Json measured = wait_for_inspection(from, [](const Json& inspection) { return inspection.at("volume") > 0; });
    EXPECT_NEAR(measured.at("inspection").at("volume"), 40 * 30 * 12 - 36 * 26 * 10, 50);
}

TEST_F(WindowInspection, ChangesSinceItWasOpenedAreTinted) {
    open_panel();
    open_tab(1230);
    std::size_t from = frames().size();
    const Json before = frames().back();
    robot("mousemove 994 103 click 1");
    wait_for(from,
             [&](const Json& frame) { return finished(frame) && frame.at("generation") != before.at("generation"); });
    const std::size_t green = count(is_green), red = count(is_red);
    from = frames().size();
    const Json same = frames().back();
    folder_.write("model.scad", std::string(kBox) + "translate([0, 0, 14]) cube([40, 30, 3]);\n");
    wait_for(from,
             [&](const Json& frame) { return finished(frame) && frame.at("generation") != same.at("generation"); });
    for (int i = 0; i < 50 && count(is_green) < green + 10'000; ++i) {
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_GT(count(is_green), green + 10'000) << "what is new";
    EXPECT_LT(count(is_red), red + 500);
    from = frames().size();
    robot("mousemove 1120 248 click 1");  // Volumes, part by part.
    wait_for_inspection(from, [](const Json& inspection) { return inspection.at("changed_parts") == 1; });
    robot("mousemove 480 300 key Escape");
    EXPECT_TRUE(shows_faces());
}

}  // namespace
}  // namespace ui
