// One spelling: American, as OpenSCAD's own words are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = CSGSCOPE_SOURCE_DIR;

/// Stems of British spellings that have been used here, in any case and within names. Not "grey" within a word, which
/// names of colors have in both spellings.
const std::regex kBritish(
    "colour|neighbour|behaviour|favour|cent(?:re|red|ring)(?![a-z])|metre(?![a-z])|metres|\\bgrey\\b|"
    "(?:raster|normal|optim|minim|maxim|initial|serial|recogn|quant|regular)is(?:e|ing|ation)|"
    "label(?:led|ling)|model(?:led|ling)|signal(?:led|ling)|cancel(?:led|ling)|draughts|\\blicence\\b",
    std::regex::icase | std::regex::optimize);

/// Places, relative to the root, that are data, or have the words of others.
bool excepted(const std::string& path) {
    static const std::regex data(
        "^models/|/(?:golden|cases|corpus|bad|meshes|language|pictures)/|^csg/scad/builtin/color_names\\.cpp$|"
        "^CHANGELOG\\.md$|spelling_test\\.cpp$");
    return std::regex_search(path, data);
}

TEST(Spelling, IsAmerican) {
    int read = 0;
    for (const char* const top : {"base", "cmake", "csg", "docs", "gl", "goldfeather", "layers", "npr", "peel", "tests",
                                  "tools", "ui", "CONTRIBUTING.md", "README.md"}) {
        std::vector<fs::path> files;
        if (fs::is_regular_file(kRoot / top)) {
            files.push_back(kRoot / top);
        } else {
            for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
                files.push_back(entry.path());
            }
        }
        for (const fs::path& file : files) {
            static const std::vector<std::string> kTexts = {".cpp", ".h",   ".glsl", ".vert",  ".frag", ".comp",
                                                            ".md",  ".txt", ".py",   ".cmake", ".1",    ""};
            const std::string name = file.lexically_relative(kRoot).string();
            if (!fs::is_regular_file(file) || excepted(name) ||
                std::find(kTexts.begin(), kTexts.end(), file.extension().string()) == kTexts.end()) {
                continue;
            }
            ++read;
            const std::string text = test_support::read_file(file);
            std::smatch found;
            if (std::regex_search(text, found, kBritish)) {
                ADD_FAILURE() << name << ":" << 1 + std::count(text.begin(), found[0].first, '\n') << ": " << found[0];
            }
        }
    }
    EXPECT_GT(read, 700);
}

}  // namespace
