// The pages of docs/styles: what they show is what the program draws. CSGSCOPE_UPDATE_GOLDENS=1 in the environment
// draws them anew; tools/styles does so.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include "base/image.h"
#include "npr/style.h"
#include "tests/support/program_test.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = CSGSCOPE_SOURCE_DIR;

/// Channels of pixels that differ by more than what rounding on another machine may make of them.
int differing(const base::Image& a, const base::Image& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        count += std::abs(a.rgba[i] - b.rgba[i]) > 2 ? 1 : 0;
    }
    return count;
}

class StylePages : public test_support::ProgramTest {
  protected:
    StylePages() : ProgramTest(60) {}
};

TEST_F(StylePages, AreOfThisProgram) {
    static const std::regex kPicture(R"(!\[([^\]]*)\]\(([^)]*)\))");
    const char* update = std::getenv("CSGSCOPE_UPDATE_GOLDENS");
    const fs::path pages = kRoot / "docs/styles";
    for (const fs::directory_entry& page : fs::directory_iterator(pages)) {
        const std::string text = test_support::read_file(page.path());
        int pictures = 0;
        for (std::sregex_iterator i(text.begin(), text.end(), kPicture), end; i != end; ++i, ++pictures) {
            const fs::path golden = pages / (*i)[2].str();
            const Result result = run(
                fmt::format("-o drawn.png -q --context none --imgsize 400,320 {}/{}", kRoot.string(), (*i)[1].str()));
            ASSERT_EQ(result.status, 0) << result.err;
            if (update != nullptr && *update == '1') {
                fs::copy_file(folder_.path("drawn.png"), golden, fs::copy_options::overwrite_existing);
                continue;
            }
            const base::Image drawn = base::read_png(folder_.path("drawn.png")), expected = base::read_png(golden);
            ASSERT_EQ(drawn.rgba.size(), expected.rgba.size()) << golden;
            EXPECT_LE(differing(drawn, expected), 60) << golden << "; tools/styles draws it anew";
        }
        EXPECT_GE(pictures, 1) << page;
    }
}

TEST_F(StylePages, ThereIsOneForEachStyle) {
    const std::set<std::string_view> elsewhere{"radiograph"};  // In docs/transparency.
    const std::string readme = test_support::read_file(kRoot / "README.md"),
                      manual = test_support::read_file(kRoot / "docs/csgscope.1");
    for (const npr::StyleInfo& style : npr::styles()) {
        EXPECT_TRUE(elsewhere.contains(style.name) ||
                    fs::exists(kRoot / "docs/styles" / fmt::format("{}.md", style.name)))
            << style.name;
        for (const std::string& text : {readme, manual}) {
            EXPECT_TRUE(std::regex_search(text, std::regex(fmt::format("\\b{}\\b", style.name)))) << style.name;
        }
    }
}

}  // namespace
