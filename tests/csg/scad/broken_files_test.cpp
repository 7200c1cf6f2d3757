// Broken files: for each the place and the message of its error. The files are those of tests/ui/command_line/bad,
// which the command line is tested with as well; the table is broken_files.txt.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/csg/scad/parsing.h"

namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(CSGSCOPE_SOURCE_DIR) / "tests/ui/command_line/bad";

struct Row {
    std::string file, place, message;
};

std::vector<Row> table() {
    std::vector<Row> rows;
    std::ifstream file(fs::path(CSGSCOPE_SOURCE_DIR) / "tests/csg/scad/broken_files.txt");
    for (std::string line; std::getline(file, line);) {
        if (!line.empty() && line[0] != '#') {
            std::istringstream fields(line);
            Row row;
            fields >> row.file >> row.place;
            std::getline(fields >> std::ws, row.message);
            rows.push_back(row);
        }
    }
    return rows;
}

class BrokenFile : public testing::TestWithParam<Row> {};

TEST_P(BrokenFile, IsALocatedError) {
    const Row& row = GetParam();
    csg::scad::ParseRequest request;
    request.path = (kFolder / (row.file + ".scad")).string();
    request.text = test::read_file(request.path);
    request.search_path.clear();
    const csg::scad::Parsed parsed = csg::scad::parse(request);
    if (row.message == "(evaluation)") {  // What is wrong shows when it runs.
        EXPECT_TRUE(parsed.ok) << test::messages(parsed);
        return;
    }
    EXPECT_FALSE(parsed.ok);
    ASSERT_FALSE(parsed.messages.empty());
    const csg::scad::Message& error = parsed.messages.back();
    EXPECT_EQ(error.severity, csg::scad::Severity::Error);
    EXPECT_EQ(error.text, row.message);
    EXPECT_EQ(std::count_if(parsed.messages.begin(), parsed.messages.end(),
                            [](const auto& m) { return m.severity == csg::scad::Severity::Error; }),
              1);
    const std::string shown = render(error, parsed.program.sources);
    EXPECT_NE(shown.find(".scad" + row.place + ": error: "), std::string::npos) << shown;
    EXPECT_NE(shown.find('^'), std::string::npos) << shown;
}

INSTANTIATE_TEST_SUITE_P(Scad, BrokenFile, testing::ValuesIn(table()),
                         [](const auto& info) { return info.param.file; });

TEST(BrokenFiles, EveryFileIsInTheTable) {
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(kFolder)) {
        files.push_back(entry.path().stem().string());
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> listed;
    for (const Row& row : table()) {
        listed.push_back(row.file);
    }
    EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end()));
    EXPECT_EQ(files, listed);
}

}  // namespace
