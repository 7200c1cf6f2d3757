// The log of frames is JSON, a line each.
#include "ui/viewer/frame_log.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/temporary_folder.h"

namespace ui {
namespace {

TEST(FrameLog, WritesALinePerFrame) {
    const test_support::TemporaryFolder folder;
    FrameLog log(folder.path("frames.json"));
    FrameRecord record;
    record.samples = 3;
    record.generation = 9;
    record.style = "blueprint";
    record.state = "good";
    record.camera.target = {1, 2.5, -3};
    log.write(record);
    record.camera.projection = base::Projection::Orthographic;
    log.write(record);

    std::istringstream lines(folder.read("frames.json"));  // Complete while the log is open.
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    const auto first = nlohmann::json::parse(line);
    EXPECT_EQ(first.at("samples"), 3);
    EXPECT_EQ(first.at("generation"), 9);
    EXPECT_EQ(first.at("style"), "blueprint");
    EXPECT_EQ(first.at("camera").at("translation"), nlohmann::json({1, 2.5, -3}));
    EXPECT_EQ(first.at("camera").at("projection"), "perspective");
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(nlohmann::json::parse(line).at("camera").at("projection"), "orthographic");
    EXPECT_FALSE(std::getline(lines, line));
}

TEST(FrameLog, NoPathNoLog) {
    FrameLog log("");
    EXPECT_NO_THROW(log.write({}));
}

TEST(FrameLog, AnImpossiblePathIsTold) {
    EXPECT_THROW(FrameLog("/nowhere/at/all/frames.json"), std::runtime_error);
}

}  // namespace
}  // namespace ui
