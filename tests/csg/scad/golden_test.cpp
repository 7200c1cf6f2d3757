// Syntax trees of small files. CSGSCOPE_UPDATE_GOLDENS=1 in the environment writes the expected texts anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "csg/scad/text/ast_text.h"
#include "tests/csg/scad/parsing.h"

namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(CSGSCOPE_SOURCE_DIR) / "tests/csg/scad/golden";

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, SyntaxTree) {
    const fs::path source = kFolder / (GetParam() + ".scad");
    csg::scad::ParseRequest request;
    request.path = source.string();
    request.text = test::read_file(source);
    request.search_path.clear();
    const csg::scad::Parsed parsed = csg::scad::parse(request);
    ASSERT_TRUE(parsed.ok) << test::messages(parsed);
    const std::string text = ast_text(parsed.program);
    const fs::path expected = kFolder / (GetParam() + ".ast");
    if (const char* update = std::getenv("CSGSCOPE_UPDATE_GOLDENS"); update != nullptr && *update == '1') {
        std::ofstream(expected, std::ios::binary) << text;
    }
    EXPECT_EQ(text, test::read_file(expected));

    request.text = text;  // The normal form means the same.
    EXPECT_EQ(test::without_comments(ast_text(csg::scad::parse(request).program)), test::without_comments(text));
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(kFolder)) {
        if (entry.path().extension() == ".scad") {
            all.push_back(entry.path().stem().string());
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

INSTANTIATE_TEST_SUITE_P(Scad, Golden, testing::ValuesIn(names()), [](const auto& info) { return info.param; });

TEST(Goldens, AreThere) {
    EXPECT_GE(names().size(), 4U);
}

}  // namespace
