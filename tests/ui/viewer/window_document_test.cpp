// The keys in docs/WINDOW.md are those of the program. CSGSCOPE_UPDATE_GOLDENS=1 in the environment writes them anew.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/file.h"
#include "tests/support/temporary_folder.h"
#include "ui/viewer/commands.h"

namespace ui {
namespace {

std::string table_of_keys() {
    std::string table = "| menu | action | keys |\n| --- | --- | --- |\n";
    for (const ActionInfo& each : actions()) {
        std::string keys;
        for (const Chord& chord : each.keys) {
            keys += chord.key == 0 ? "" : (keys.empty() ? "`" : ", `") + text(chord) + "`";
        }
        table += std::string("| ") + each.menu + " | " + each.label + " | " + keys + " |\n";
    }
    return table;
}

TEST(WindowDocument, HasTheKeysOfThisProgram) {
    const std::filesystem::path path = std::filesystem::path(CSGSCOPE_SOURCE_DIR) / "docs/WINDOW.md";
    const std::string document = test_support::read_file(path);
    const std::size_t mark = document.find("<!-- keys:");
    ASSERT_NE(mark, std::string::npos);
    const std::size_t begin = document.find('\n', mark) + 1;
    if (std::getenv("CSGSCOPE_UPDATE_GOLDENS") != nullptr) {
        base::write_file(path, document.substr(0, begin) + table_of_keys());
        return;
    }
    EXPECT_EQ(document.substr(begin), table_of_keys());
}

}  // namespace
}  // namespace ui
