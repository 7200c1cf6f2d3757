// No two things of a library have one name: its files may be compiled together (cmake/parse_once.cmake), and readers
// need not ask which is meant.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = CSGSCOPE_SOURCE_DIR;

/// A function's name with the types of its parameters, from the line that its body begins on; "" where it is none.
std::string function_of(const std::string& line) {
    static const std::regex function("(?:\\[\\[\\w+\\]\\] )?[\\w:]+(?:<.*>)?[&*]* (\\w+)\\(([^()]*)\\) \\{");
    static const std::regex parameter("([&*> ])\\w+(,|$)");
    std::smatch found;
    if (!std::regex_match(line, found, function) || line.starts_with("else ")) {
        return "";
    }
    return found.str(1) + "(" + std::regex_replace(found.str(2), parameter, "$1$2") + ")";
}

/// What a line at the left margin gives a name to: a type, a constant, a function; "" where it is none of these.
std::string named_by(const std::string& line) {
    static const std::regex type("(?:struct|class|enum class|enum) (\\w+)(?: final)?(?: :[^;]*)? \\{.*");
    static const std::regex alias("using (\\w+) = .*");
    static const std::regex constant("(?:inline )?(?:constexpr|const) [^()]*?\\b(k[A-Z]\\w*)(?: = |\\{|\\[|\\().*");
    std::smatch found;
    for (const std::regex* const pattern : {&type, &alias, &constant}) {
        if (std::regex_match(line, found, *pattern)) {
            return found[1];
        }
    }
    return function_of(line);
}

struct Named {
    std::string name;  ///< With its namespace.
    std::string line;
};

/// What a file has names for in its library: a header all, a source those of its unnamed namespace.
std::vector<Named> names_of(const fs::path& file) {
    static const std::regex opening("namespace ([\\w:]+) \\{");
    const bool header = file.extension() == ".h";
    std::vector<Named> names;
    std::istringstream text(test_support::read_file(file));
    bool unnamed = false;
    std::string space;
    std::smatch found;
    for (std::string line; std::getline(text, line);) {
        if (std::regex_match(line, found, opening)) {
            space = found[1];
        }
        unnamed = line == "namespace {" || (unnamed && !line.starts_with("}  // namespace"));
        if (unnamed || (header && function_of(line).empty())) {
            if (const std::string name = named_by(line); !name.empty()) {
                names.push_back({space + "::" + name, line});
            }
        }
    }
    return names;
}

TEST(Architecture, NamesAreOnceInALibrary) {
    EXPECT_EQ(named_by("struct Row {"), "Row");
    EXPECT_EQ(named_by("class Painter : public Tool {"), "Painter");
    EXPECT_EQ(named_by("constexpr std::array<int, 2> kNone{1, 2};"), "kNone");
    EXPECT_EQ(named_by("constexpr double kInfinity = std::numeric_limits<double>::infinity();"), "kInfinity");
    EXPECT_EQ(named_by("struct Row;"), "");
    EXPECT_EQ(named_by("ImVec2 im(const glm::dvec2& p) {"), "im(const glm::dvec2& )");
    EXPECT_EQ(named_by("std::vector<int> all(int most, const Box& box) {"), "all(int , const Box& )");
    EXPECT_EQ(named_by("    if (done) {"), "");
    for (const char* const library : {"base", "csg/tree", "csg/scad", "csg/solid", "gl", "layers", "goldfeather",
                                      "peel", "npr", "ui/pipeline", "ui/viewer", "ui/command_line"}) {
        std::map<std::string, std::pair<std::string, std::string>> first;  // From a name to its file and line.
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / library)) {
            const std::string file = entry.path().lexically_relative(kRoot).string();
            // Styles have Settings, each of its own, and are compiled one by one.
            if ((entry.path().extension() != ".cpp" && entry.path().extension() != ".h") ||
                file.starts_with("npr/styles/")) {
                continue;
            }
            for (const Named& named : names_of(entry.path())) {
                const auto [at, fresh] = first.emplace(named.name, std::pair(file, named.line));
                const auto& [other, line] = at->second;
                // The same alias may stand twice.
                EXPECT_TRUE(fresh || other == file || (line == named.line && line.starts_with("using ")))
                    << named.name << " stands in " << other << " and in " << file;
            }
        }
        EXPECT_FALSE(first.empty()) << library;
    }
}

}  // namespace
