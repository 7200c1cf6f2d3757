// The shape of the source tree: which folder includes and links which, and how long files are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

using test_support::read_file;

const fs::path kRoot = CSGSCOPE_SOURCE_DIR;

/// What each folder may include besides itself and base/, which is below all.
const std::map<std::string, Names> kMayInclude = {
    {"base", {}},
    {"csg/tree", {}},
    {"csg/scad", {"csg/tree"}},
    {"csg/solid", {"csg/tree"}},
    {"csg/reference", {"csg/tree", "csg/solid"}},
    {"gl", {}},
    {"layers", {"gl"}},
    {"peel", {"gl", "layers"}},
    {"npr", {"gl", "layers", "peel"}},
    {"goldfeather", {"csg/tree", "csg/solid", "gl", "layers", "peel"}},
    {"ui/pipeline",
     {"csg/tree", "csg/scad", "csg/solid", "csg/reference", "gl", "layers", "goldfeather", "peel", "npr"}},
    {"ui/viewer", {"csg/tree", "csg/scad", "csg/solid", "gl", "layers", "goldfeather", "peel", "npr", "ui/pipeline"}},
    {"ui/command_line",
     {"csg/tree", "csg/scad", "csg/solid", "gl", "layers", "goldfeather", "peel", "npr", "ui/pipeline", "ui/viewer"}},
    {"ui", {"gl", "ui/command_line", "ui/pipeline"}},
};

/// The library of a folder, as its CMakeLists.txt names it.
const std::map<std::string, std::string> kFolderOfLibrary = {
    {"csg_tree", "csg/tree"},
    {"csg_scad", "csg/scad"},
    {"csg_solid", "csg/solid"},
    {"csg_reference", "csg/reference"},
    {"csgscope_gl", "gl"},
    {"layers", "layers"},
    {"peel", "peel"},
    {"goldfeather", "goldfeather"},
    {"npr", "npr"},
    {"ui_pipeline", "ui/pipeline"},
    {"csgscope_viewer", "ui/viewer"},
    {"ui_command_line", "ui/command_line"},
};

/// What the files under a path may not reach, not even through files that they include. Shader files that are C++ too
/// need no OpenGL.
struct OutOfReach {
    std::string from;
    Names never;
};
const std::vector<OutOfReach> kOutOfReach = {
    // Styles know nothing of CSG, nor do stacks of layers.
    {"layers/", {"csg/", "goldfeather/"}},
    {"peel/", {"csg/", "goldfeather/"}},
    {"npr/", {"csg/", "goldfeather/"}},
    // What draws without OpenGL includes none.
    {"base/", {"gl/"}},
    {"csg/", {"gl/"}},
    {"layers/host_stack", {"gl/"}},
    {"layers/stack.h", {"gl/"}},
    {"goldfeather/engine", {"gl/"}},
    {"goldfeather/choice", {"gl/"}},
    {"goldfeather/products", {"gl/"}},
    {"goldfeather/surface_table", {"gl/"}},
    {"goldfeather/lists_cpu/", {"gl/"}},
    {"npr/painter/", {"gl/"}},
    {"npr/picture", {"gl/"}},
    {"npr/samples", {"gl/"}},
    {"npr/shader_frame", {"gl/"}},
    {"ui/pipeline/comparison/", {"gl/"}},
    {"ui/pipeline/mesh/", {"gl/"}},
    // Nor do meshes know of pictures.
    {"csg/", {"layers/", "peel/", "npr/", "goldfeather/", "ui/"}},
};

/// What each room of csg/scad may include besides itself; "" is what stands in csg/scad itself. Machine and built-ins
/// are one level: a call runs the one from the other.
const std::map<std::string, Names> kLanguageMayInclude = {
    {"value", {}},
    {"source", {}},
    {"syntax", {"source", "value"}},
    {"customizer", {"syntax", "value"}},
    {"text", {"customizer", "syntax", "value"}},
    {"machine", {"", "builtin", "customizer", "source", "syntax", "text", "value"}},
    {"builtin", {"machine", "source", "syntax", "value"}},
    {"program", {"", "machine", "source", "syntax"}},
    {"", {"builtin", "program", "source"}},
};
/// All that the machine knows of the built-ins: their tables, and the files that they read once for a run.
const Names kKnownOfBuiltins = {"csg/scad/builtin/builtin_functions.h", "csg/scad/builtin/builtin_modules.h",
                                "csg/scad/builtin/data_file.h"};

/// The longest key of kMayInclude that is a folder of `path`, relative to the root; "" where there is none.
std::string folder_of(const std::string& path) {
    std::string folder = fs::path(path).parent_path().string();
    while (!folder.empty() && !kMayInclude.contains(folder)) {
        folder = fs::path(folder).parent_path().string();
    }
    return folder;
}

/// All files with one of `extensions` under the folders of the program and tests, relative to the root.
std::vector<std::string> files_of(const Names& tops, const Names& extensions) {
    std::vector<std::string> found;
    for (const std::string& top : tops) {
        if (!fs::exists(kRoot / top)) {
            continue;
        }
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
            if (entry.is_regular_file() && extensions.contains(entry.path().extension().string())) {
                found.push_back(entry.path().lexically_relative(kRoot).string());
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

const Names kProgram = {"base", "csg", "gl", "layers", "goldfeather", "peel", "npr", "ui"};
const Names kSources = {".cpp", ".h", ".glsl", ".vert", ".frag", ".comp"};

TEST(Architecture, IncludesGoDownOnly) {
    const std::regex include("(?:^|\n)[ \t]*#[ \t]*include[ \t]+\"([^\"]+)\"");
    int checked = 0;
    for (const std::string& file : files_of(kProgram, kSources)) {
        const std::string from = folder_of(file);
        ASSERT_FALSE(from.empty()) << file << " is in a folder that this test does not know";
        const std::string text = read_file(kRoot / file);
        for (std::sregex_iterator at(text.begin(), text.end(), include), end; at != end; ++at) {
            const std::string to = folder_of((*at)[1]);
            ASSERT_FALSE(to.empty()) << file << " includes " << (*at)[1] << ": name it from the root";
            EXPECT_TRUE(to == from || to == "base" || kMayInclude.at(from).contains(to))
                << file << " may not include " << (*at)[1];
            ++checked;
        }
    }
    EXPECT_GT(checked, 50);
}

TEST(Architecture, IncludesGoDownWithinTheLanguage) {
    const std::regex include("(?:^|\n)#include \"(csg/scad/[^\"]+)\"");
    const auto room_of = [](const std::string& file) {
        const std::string rest = file.substr(std::string("csg/scad/").size());
        return rest.substr(0, rest.find('/') == std::string::npos ? 0 : rest.find('/'));
    };
    int checked = 0;
    for (const std::string& file : files_of({"csg/scad"}, {".cpp", ".h"})) {
        const std::string from = room_of(file), text = read_file(kRoot / file);
        ASSERT_TRUE(kLanguageMayInclude.contains(from)) << file << " is in a room that this test does not know";
        for (std::sregex_iterator at(text.begin(), text.end(), include), end; at != end; ++at) {
            const std::string to = room_of((*at)[1]);
            EXPECT_TRUE(to == from || kLanguageMayInclude.at(from).contains(to))
                << file << " may not include " << (*at)[1];
            EXPECT_TRUE(from != "machine" || to != "builtin" || kKnownOfBuiltins.contains((*at)[1])) << file;
            ++checked;
        }
    }
    EXPECT_GT(checked, 100);
}

/// Files by the file that includes them first, of all that `file` includes, and what these include.
std::map<std::string, std::string> reached_from(const std::string& file) {
    static const std::regex include("(?:^|\n)[ \t]*#[ \t]*include[ \t]+\"([^\"]+)\"");
    static std::map<std::string, std::vector<std::string>> included;
    const auto includes_of = [](const std::string& name) -> const std::vector<std::string>& {
        const auto [at, is_new] = included.try_emplace(name);
        if (is_new && fs::exists(kRoot / name)) {
            const std::string text = read_file(kRoot / name);
            for (std::sregex_iterator i(text.begin(), text.end(), include), end; i != end; ++i) {
                at->second.push_back((*i)[1]);
            }
        }
        return at->second;
    };
    std::map<std::string, std::string> reached;
    std::vector<std::string> open{file};
    while (!open.empty()) {
        const std::string from = open.back();
        open.pop_back();
        for (const std::string& to : includes_of(from)) {
            if (reached.try_emplace(to, from).second) {
                open.push_back(to);
            }
        }
    }
    return reached;
}

TEST(Architecture, IncludesDoNotReachRoundTheWalls) {
    for (const auto& [prefix, never] : kOutOfReach) {
        int checked = 0;
        for (const std::string& file : files_of(kProgram, {".cpp", ".h"})) {
            if (!file.starts_with(prefix)) {
                continue;
            }
            ++checked;
            for (const auto& [reached, through] : reached_from(file)) {
                EXPECT_FALSE(reached.ends_with(".h") &&
                             std::any_of(never.begin(), never.end(),
                                         [&](const auto& wall) { return reached.starts_with(wall); }))
                    << file << " may not reach " << reached << ", as it does through " << through;
            }
        }
        EXPECT_GT(checked, 0) << prefix;
    }
}

TEST(Architecture, ProgramDoesNotIncludeTests) {
    for (const std::string& file : files_of(kProgram, kSources)) {
        EXPECT_EQ(read_file(kRoot / file).find("#include \"tests/"), std::string::npos) << file;
    }
}

TEST(Architecture, OnlyTheReferenceIncludesCgal) {
    for (const std::string& file : files_of(kProgram, kSources)) {
        if (folder_of(file) != "csg/reference") {
            EXPECT_EQ(read_file(kRoot / file).find("#include <CGAL/"), std::string::npos) << file;
        }
    }
}

TEST(Architecture, WindowLibrariesStayInTheViewer) {
    const std::regex window("#include [<\"](GLFW/|imgui)");
    for (const std::string& file : files_of(kProgram, kSources)) {
        if (folder_of(file) != "ui/viewer") {
            EXPECT_FALSE(std::regex_search(read_file(kRoot / file), window)) << file;
        }
    }
}

TEST(Architecture, LibrariesLinkWhatTheirFolderMayInclude) {
    const std::regex library("(?:csgscope_library|target_link_libraries)\\(([^)]*)\\)");
    const std::regex word("[A-Za-z_]+");
    int checked = 0;
    for (const std::string& file : files_of(kProgram, {".txt"})) {
        if (fs::path(file).filename() != "CMakeLists.txt") {
            continue;
        }
        const std::string from = fs::path(file).parent_path().string();
        const std::string text = read_file(kRoot / file);
        for (std::sregex_iterator at(text.begin(), text.end(), library), end; at != end; ++at) {
            const std::string arguments = (*at)[1];
            for (std::sregex_iterator name(arguments.begin(), arguments.end(), word); name != end; ++name) {
                const auto linked = kFolderOfLibrary.find(name->str());
                if (linked == kFolderOfLibrary.end() || linked->second == from) {
                    continue;
                }
                EXPECT_TRUE(kMayInclude.at(from).contains(linked->second)) << file << " may not link " << name->str();
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 8);
}

/// docs/ARCHITECTURE.md, "The picture": whoever only hands a wish on does not name it.
TEST(Architecture, AWishOfAllStylesIsNamedByThoseWhoReadItOnly) {
    Names found;
    for (const std::string& file : files_of(kProgram, kSources)) {
        if (read_file(kRoot / file).find("transparent_background") != std::string::npos) {
            found.insert(file);
        }
    }
    EXPECT_EQ(found, (Names{"npr/picture.h", "npr/frame_values.h", "npr/frame_values.cpp", "npr/part_notes.cpp",
                            "npr/sorted/sorted_painter.cpp", "npr/surface_color.glsl", "npr/styles/blueprint.glsl",
                            "npr/styles/blueprint_lines.glsl", "npr/styles/radiograph.glsl", "npr/styles/sketch.glsl",
                            "ui/command_line/option_declarations.cpp", "ui/viewer/save_form.cpp",
                            "ui/viewer/view_state.cpp"}));
}

/// clang-tidy finds more (readability-braces-around-statements); this is quick, and sees headers on one line.
TEST(Architecture, BodiesHaveBraces) {
    const std::regex unbraced("(?:^|\n) *(?:\\} )?(?:else|(?:else )?(?:if|for|while) [^\n]*\\))(?=\n)");
    Names all = kProgram;
    all.insert("tests");
    for (const std::string& file : files_of(all, {".cpp", ".h"})) {
        const std::string text = read_file(kRoot / file);
        for (std::sregex_iterator at(text.begin(), text.end(), unbraced), end; at != end; ++at) {
            const std::string line = at->str();
            EXPECT_NE(std::count(line.begin(), line.end(), '('), std::count(line.begin(), line.end(), ')'))
                << file << ":" << line;
        }
    }
}

TEST(Architecture, FilesAreShort) {
    Names all = kProgram;
    all.insert("tests");
    for (const std::string& file : files_of(all, kSources)) {
        const std::string text = read_file(kRoot / file);
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 600) << file;
    }
}

/// A test of one folder of the program is where that folder's path leads below tests/; the others concern several.
TEST(Architecture, TestsMirrorTheProgram) {
    const Names concern_several = {"architecture", "bench",    "edges", "fuzz",   "gallery",   "models",  "opencsg",
                                   "outlines",     "pictures", "plot",  "random", "stability", "support", "truth"};
    int mirrored = 0;
    for (const std::string& file : files_of({"tests"}, {".cpp", ".h"})) {
        const fs::path folder = fs::path(file).parent_path().lexically_relative("tests");
        if (folder == "." || concern_several.contains(folder.begin()->string())) {
            continue;
        }
        EXPECT_TRUE(fs::is_directory(kRoot / folder)) << file << " tests a folder that is not there";
        ++mirrored;
    }
    EXPECT_GT(mirrored, 100);
}

TEST(Architecture, TheManifestNamesEveryModel) {
    const std::string manifest = read_file(kRoot / "models/manifest.json");
    for (const std::string& file : files_of({"models"}, {".scad"})) {
        EXPECT_NE(manifest.find('"' + fs::path(file).filename().string() + '"'), std::string::npos) << file;
    }
}

}  // namespace
