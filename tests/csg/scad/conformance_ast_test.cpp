// OpenSCAD's own cases of the .ast output, those of its customizer included. The data is not part of the project: it
// is looked for beside it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "csg/scad/text/ast_text.h"
#include "tests/csg/scad/parsing.h"
#include "tests/support/suite.h"

namespace {

namespace fs = std::filesystem;

/// Names of cases that are known to differ; the rest of each line says why.
std::set<std::string> exceptions() {
    std::set<std::string> names;
    std::ifstream file(std::string(CSGSCOPE_SOURCE_DIR) + "/tests/csg/scad/conformance_ast_exceptions.txt");
    EXPECT_TRUE(file);
    for (std::string line; std::getline(file, line);) {
        if (!line.empty() && line[0] != '#') {
            names.insert(line.substr(0, line.find(' ')));
        }
    }
    return names;
}

/// Without carriage returns and blank lines at both ends, as the suite compares.
std::string trimmed(std::string text) {
    std::erase(text, '\r');
    const std::size_t first = text.find_first_not_of('\n');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of('\n') - first + 1);
}

bool takes_part(const nlohmann::json& row) {
    const std::string kind = row.at("kind");
    const std::vector<std::string> arguments = row.at("args");
    return (kind == "ast" || kind == "customizer") &&
           std::find(arguments.begin(), arguments.end(), "-p") == arguments.end();  // Sets of parameters: not here.
}

TEST(Conformance, SyntaxTrees) {
    const std::vector<nlohmann::json> rows = suite::cases();
    if (rows.empty()) {
        GTEST_SKIP() << "no conformance data at " << suite::folder();
    }
    const std::set<std::string> known = exceptions();
    std::size_t cases = 0;
    for (const nlohmann::json& row : rows) {
        if (!takes_part(row)) {
            continue;
        }
        ++cases;
        const std::string name = row.at("name");
        csg::scad::ParseRequest request;
        request.path = suite::input(row).string();
        request.text = test::read_file(request.path);
        const csg::scad::Parsed parsed = csg::scad::parse(request);
        EXPECT_TRUE(parsed.ok) << name << '\n' << test::messages(parsed);
        const fs::path expected = suite::expected(row);
        const std::string text = trimmed(ast_text(parsed.program));
        if (known.count(name) == 0) {
            EXPECT_EQ(text, trimmed(test::read_file(expected))) << name;
        } else {
            EXPECT_NE(text, trimmed(test::read_file(expected))) << name << " passes: it is no exception any more";
        }
    }
    EXPECT_EQ(cases, 34U);
}

/// Every file of the suite parses, but those that are broken on purpose.
TEST(Conformance, AllInputsParse) {
    if (!fs::exists(suite::folder() / "openscad")) {
        GTEST_SKIP() << "no conformance data at " << suite::folder();
    }
    std::set<std::string> broken;
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(suite::folder() / "openscad")) {
        if (entry.path().extension() == ".scad") {
            ++files;
            csg::scad::ParseRequest request;
            request.path = entry.path().string();
            request.text = test::read_file(request.path);
            if (!csg::scad::parse(request).ok) {
                broken.insert(entry.path().filename().string());
            }
        }
    }
    EXPECT_GT(files, 600U);
    EXPECT_EQ(broken,
              (std::set<std::string>{"bad-include-synerr.scad", "bad-synerr.scad", "error.scad",
                                     "issue1890-comment.scad", "issue1890-include.scad", "issue1890-string.scad",
                                     "issue1890-use.scad", "mainincludingerror.scad", "syntax-error-in-line-2.scad"}));
}

}  // namespace
