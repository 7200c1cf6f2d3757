// A window on an X server of its own: a real keyboard and mouse as far as the program can tell, pixels and the log of
// frames as evidence.
#pragma once

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

using namespace std::chrono_literals;
using Json = nlohmann::json;

inline const std::string kModel =
    "difference() {\n"
    "    cube(20, center = true);\n"
    "    cylinder(r = 7, h = 40, center = true, $fn = 32);\n"
    "}\n";
inline constexpr auto kPatience = 60s;  // Software renderers on busy machines.

struct Color {
    int r, g, b;
};
inline constexpr Color kCornfield{255, 255, 229}, kBlueprint{27, 63, 139}, kErrorBanner{189, 38, 38},
    kGoneBanner{179, 115, 15}, kForm{38, 42, 48}, kPanel{33, 36, 41};

/// Yellow of added leaves and green of subtracted ones, in any light.
inline bool is_face(const std::uint8_t* p) {
    return p[0] > p[1] && p[1] > 80 && p[2] < p[1] / 2;
}
inline bool is_cut(const std::uint8_t* p) {
    return p[1] > p[0] && p[0] > 50 && p[2] < p[1] * 3 / 4 && p[1] > 80;
}

class WindowFixture : public testing::Test {
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

}  // namespace ui
