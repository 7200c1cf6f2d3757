// The pages of docs/transparency: one for each model, with a picture that is what the program draws.
// CSGSCOPE_UPDATE_GOLDENS=1 in the environment draws them anew; tools/transparency does so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "base/image.h"
#include "npr/transparency.h"
#include "tests/support/program_test.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

const fs::path kDocs = fs::path(CSGSCOPE_SOURCE_DIR) / "docs";

/// Channels of pixels that differ by more than what rounding on another machine may make of them.
int differing(const base::Image& a, const base::Image& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        count += std::abs(a.rgba[i] - b.rgba[i]) > 2 ? 1 : 0;
    }
    return count;
}

class TransparencyPages : public test_support::ProgramTest {
  protected:
    TransparencyPages() : ProgramTest(60) {}

    /// Compares the pictures of a page with what the program draws, or draws them anew.
    void check_pictures(const fs::path& page) const {
        const std::string text = test_support::read_file(page);
        static const std::regex kPicture(R"(!\[([^\]]*)\]\(([^)]*)\))");
        int pictures = 0;
        for (std::sregex_iterator i(text.begin(), text.end(), kPicture), end; i != end; ++i, ++pictures) {
            const std::string options = (*i)[1];
            if (options == "OpenSCAD") {
                continue;
            }
            const fs::path golden = page.parent_path() / (*i)[2].str();
            const bool scene = options.starts_with("scenes/");
            const fs::path folder = scene ? page.parent_path() : fs::path(CSGSCOPE_SOURCE_DIR) / "tools";
            const Result result = run(fmt::format("-o drawn.png --context none --imgsize 320,320 {}/{}{}",
                                                  folder.string(), scene ? "" : "transparency.scad ", options));
            ASSERT_EQ(result.status, 0) << result.err;
            const char* update = std::getenv("CSGSCOPE_UPDATE_GOLDENS");
            if (update != nullptr && *update == '1') {
                fs::copy_file(folder_.path("drawn.png"), golden, fs::copy_options::overwrite_existing);
                continue;
            }
            const base::Image drawn = base::read_png(folder_.path("drawn.png")), expected = base::read_png(golden);
            ASSERT_EQ(drawn.rgba.size(), expected.rgba.size()) << golden;
            EXPECT_LE(differing(drawn, expected), 40) << golden << "; tools/transparency draws it anew";
        }
        EXPECT_GE(pictures, 1) << page;
    }
};

TEST_F(TransparencyPages, AreOfThisProgram) {
    const std::string index = test_support::read_file(kDocs / "TRANSPARENCY.md");
    for (const npr::TransparencyInfo& model : npr::transparencies()) {
        EXPECT_NE(index.find(fmt::format("| `{}`", model.name)), std::string::npos) << model.name;
        EXPECT_NE(index.find(fmt::format("(transparency/{}.md)", model.name)), std::string::npos) << model.name;
        EXPECT_TRUE(fs::exists(kDocs / "transparency" / fmt::format("{}.md", model.name))) << model.name;
    }
    for (const fs::directory_entry& page : fs::directory_iterator(kDocs / "transparency")) {
        if (page.is_regular_file()) {
            check_pictures(page);
        }
    }
}

/// Those on OpenGL to the byte; lists-cpu but for rays that pass an edge by less than 1/256 pixel, where rasterizers
/// may differ.
TEST_F(TransparencyPages, AllEnginesDrawTheSame) {
    const auto drawn = [&](std::string_view engine, std::string_view model) {
        const Result result =
            run(fmt::format("{}/tools/transparency.scad -o {}.png --imgsize 64,64 --samples 1 "
                            "--context osmesa --engine {} --transparency {}",
                            CSGSCOPE_SOURCE_DIR, engine, engine, model));
        EXPECT_EQ(result.status, 0) << result.err;
        return base::read_png(folder_.path(fmt::format("{}.png", engine)));
    };
    std::vector<std::string> models{"view-dependent:opacity=vertices"};
    for (const npr::TransparencyInfo& model : npr::transparencies()) {
        models.emplace_back(model.name);
    }
    for (const std::string& model : models) {
        const base::Image expected = drawn("goldfeather", model);
        EXPECT_TRUE(drawn("lists", model).rgba == expected.rgba) << model;
        EXPECT_LE(differing(drawn("lists-cpu", model), expected), 3 * 8) << model;
    }
}

TEST_F(TransparencyPages, RadiographsAreWrittenAsNumbers) {
    constexpr std::size_t kSide = 40, kLine = 8 + 4 * kSide;
    folder_.write("block.scad", "color(\"red\") cube([4, 4, 7]); color(\"blue\") translate([4, 0, 0]) cube(3);");
    const char* camera =
        " --imgsize 40,40 --style radiograph --projection o --camera=0,0,0,0,0,0,40 --autocenter -o t.exr";
    ASSERT_EQ(run("block.scad" + std::string(camera)).status, 0);
    const std::string file = folder_.read("t.exr");
    EXPECT_NE(file.find(std::string("channels\0chlist\0", 16)), std::string::npos);
    ASSERT_GT(file.size(), kSide * kLine);
    float most = 0;
    for (std::size_t y = 0; y < kSide; ++y) {
        for (std::size_t x = 0; x < kSide; ++x) {
            float value = 0;
            std::memcpy(&value, file.data() + file.size() - (kSide - y) * kLine + 8 + 4 * x, sizeof(value));
            most = std::max(most, value);
        }
    }
    EXPECT_NEAR(most, 7, 7e-3);
    ASSERT_EQ(run("block.scad --parts color" + std::string(camera)).status, 0);
    const std::string parts = folder_.read("t.exr");
    EXPECT_NE(parts.find(std::string("#0000ff\0", 8)), std::string::npos);
    EXPECT_NE(parts.find(std::string("#ff0000\0", 8)), std::string::npos);
    EXPECT_EQ(run("m.scad -o light.exr --imgsize 8,8").status, 0) << "the light of any other style";
}

TEST_F(TransparencyPages, RadiographsHaveALegend) {
    ASSERT_EQ(run("m.scad -o a.png --imgsize 120,120 --style radiograph").status, 0);
    ASSERT_EQ(run("m.scad -o b.png --imgsize 120,120 --style radiograph --set legend=off").status, 0);
    const base::Image with = base::read_png(folder_.path("a.png")), without = base::read_png(folder_.path("b.png"));
    int left = 0, right = 0;
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 120; ++x) {
            (x < 60 ? left : right) += with.pixel(x, y)[0] != without.pixel(x, y)[0] ? 1 : 0;
        }
    }
    EXPECT_GT(left, 200);
    EXPECT_EQ(right, 0);
}

TEST_F(TransparencyPages, HelpManualAndReadmeNameAllModels) {
    const std::string manual = test_support::read_file(kDocs / "csgscope.1"), help = run("--help").out;
    std::string readme;
    for (const npr::TransparencyInfo& model : npr::transparencies()) {
        readme += fmt::format("{}{}", readme.empty() ? "" : "\\|", model.name);
        EXPECT_TRUE(std::regex_search(manual, std::regex(fmt::format("\n\\.BR? {}( :)?\n", model.name)))) << model.name;
        EXPECT_TRUE(std::regex_search(help, std::regex(fmt::format("opaque:[^()]*\\b{}\\b", model.name))))
            << model.name;
    }
    const std::string text = test_support::read_file(kDocs.parent_path() / "README.md");
    EXPECT_NE(text.find("`--transparency " + readme + "`"), std::string::npos) << readme;
}

TEST_F(TransparencyPages, UnknownNamesAreToldWithTheNearest) {
    const auto model = run("m.scad -o m.png --transparency volumes");
    EXPECT_EQ(model.status, 1);
    EXPECT_NE(model.err.find("Did you mean \"volume\"?"), std::string::npos) << model.err;
    const auto part = run("m.scad -o m.png --transparency volume --medium 'modle: tau=1/mm'");
    EXPECT_EQ(part.status, 1);
    EXPECT_NE(part.err.find("no part \"modle\". Did you mean \"model\"?"), std::string::npos) << part.err;
    for (const char* medium :
         {"model", "model:", "model: tau=1", "model: albedo=red", ": tau=1/mm", "model: tau=-1/mm"}) {
        EXPECT_EQ(run(fmt::format("m.scad -o m.png --transparency volume --medium '{}'", medium)).status, 1) << medium;
    }
    EXPECT_NE(run("m.scad -o m.png --medium 'model: tau=1/mm'").err.find("--transparency volume"), std::string::npos);
    EXPECT_EQ(run("m.scad -o m.png --transparency volume --medium-light 1").status, 1);
    EXPECT_EQ(run("m.scad -o m.png --transparency volume --medium 'model: albedo=#abc, tau=0.5/mm'").status, 0);
}

}  // namespace
