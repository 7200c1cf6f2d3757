#include "tests/pictures/conformance_pictures.h"

#include <sys/wait.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "gl/image.h"
#include "tests/pictures/silhouette.h"
#include "tests/support/temporary_folder.h"

namespace pictures {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRecordedIn = "/tmp/tmpykqbtbon";

void replace_all(std::string& text, std::string_view from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

std::string quoted(std::string text) {
    replace_all(text, "'", "'\\''");
    return "'" + text + "'";
}

}  // namespace

fs::path data_folder() {
    return fs::path(CSGSCOPE_SOURCE_DIR).parent_path() / "shared/conformance";
}

std::vector<Case> cases() {
    std::vector<Case> result;
    std::ifstream in(data_folder() / "manifest.json");
    if (!in) {
        return result;
    }
    for (const auto& row : nlohmann::json::parse(in)) {
        if (row["kind"] == "render") {
            result.push_back({row["name"], row["input"], row["args"],
                              data_folder() / "openscad/expected" / row["expected"].get<std::string>()});
        }
    }
    return result;
}

WorkingCopy::WorkingCopy() {
    std::string name = (fs::temp_directory_path() / "csgscope-pictures-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw std::runtime_error("cannot make a folder " + name);
    }
    root_ = name;
    for (const char* part : {"tests", "examples"}) {
        fs::copy(data_folder() / "openscad" / part, root_ / part, fs::copy_options::recursive);
    }
    fs::create_directories(root_ / "build/tests");
    for (const auto& entry : fs::recursive_directory_iterator(root_)) {
        if (entry.path().extension() != ".scad") {
            continue;
        }
        std::string text = test_support::read_file(entry.path());
        if (text.find(kRecordedIn) != std::string::npos) {
            replace_all(text, kRecordedIn, root_.string());
            fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
            std::ofstream(entry.path(), std::ios::binary) << text;
        }
    }
}

WorkingCopy::~WorkingCopy() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
}

Result draw(const std::string& program, const Case& c, const WorkingCopy& copy, const fs::path& picture) {
    const std::string root = copy.root().string();
    std::string command = "cd " + quoted(root + "/build/tests") +
                          " && OPENSCAD_FONT_PATH=" + quoted(root + "/tests/data/ttf") +
                          " OPENSCADPATH=" + quoted(root + "/libraries") + " timeout 60 " + quoted(program) + " " +
                          quoted(root + "/" + c.input);
    for (std::string argument : c.arguments) {
        replace_all(argument, "@ROOT@", root);
        command += " " + quoted(argument);
    }
    command += " -o " + quoted(picture.string()) + " >/dev/null 2>&1";
    fs::remove(picture);
    Result result;
    const auto begin = std::chrono::steady_clock::now();
    const int status = std::system(command.c_str());
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        result.problem = WIFEXITED(status) && WEXITSTATUS(status) != 124
                             ? "exit status " + std::to_string(WEXITSTATUS(status))
                             : "no end after a minute, or a crash";
        return result;
    }
    try {
        result.overlap = overlap(gl::read_png(c.expected), gl::read_png(picture));
    } catch (const std::exception& error) {
        result.problem = error.what();
    }
    return result;
}

std::vector<Result> draw(const std::string& program, const std::vector<Case>& cases, const fs::path& folder) {
    const WorkingCopy copy;
    std::vector<Result> results(cases.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < cases.size(); i = next++) {
            results[i] = draw(program, cases[i], copy, folder / (cases[i].name + ".png"));
        }
    };
    {
        const std::jthread helper(work);
        work();
    }
    return results;
}

}  // namespace pictures
