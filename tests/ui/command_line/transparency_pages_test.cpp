// The pages of docs/transparency: one for each model, with a picture that is what the program draws.
// CSGSCOPE_UPDATE_GOLDENS=1 in the environment draws them anew; tools/transparency does so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

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
            const fs::path golden = page.parent_path() / (*i)[2].str();
            const Result result =
                run(fmt::format("{}/tools/transparency.scad -o drawn.png --context none "
                                "--imgsize 320,320 {}",
                                CSGSCOPE_SOURCE_DIR, (*i)[1].str()));
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
        check_pictures(kDocs / "transparency" / fmt::format("{}.md", model.name));
    }
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
