#include "tests/pictures/conformance_pictures.h"

#include <sys/wait.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "base/image.h"
#include "tests/pictures/silhouette.h"
#include "tests/support/suite.h"

namespace pictures {

namespace {

namespace fs = std::filesystem;

std::string quoted(std::string text) {
    suite::replace_all(text, "'", "'\\''");
    return "'" + text + "'";
}

}  // namespace

std::vector<Case> cases() {
    std::vector<Case> result;
    for (const auto& row : suite::cases()) {
        if (row["kind"] == "render") {
            result.push_back({row["name"], row["input"], row["args"], suite::expected(row)});
        }
    }
    return result;
}

WorkingCopy::WorkingCopy() {
    const fs::path root = this->root();
    fs::create_directories(root / "build/tests");
    for (const char* part : {"tests", "examples"}) {
        fs::copy(suite::folder() / "openscad" / part, root / part, fs::copy_options::recursive);
    }
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".scad") {
            continue;
        }
        const std::string recorded = test_support::read_file(entry.path());
        std::string text = recorded;
        suite::move_to(text, root.string());
        if (text != recorded) {
            fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
            std::ofstream(entry.path(), std::ios::binary) << text;
        }
    }
}

Result draw(const std::string& program, const Case& c, const WorkingCopy& copy, const fs::path& picture) {
    const std::string root = copy.root();
    std::string command = "cd " + quoted(root + "/build/tests") +
                          " && OPENSCAD_FONT_PATH=" + quoted(root + "/tests/data/ttf") +
                          " OPENSCADPATH=" + quoted(root + "/libraries") + " timeout 60 " + quoted(program) + " " +
                          quoted(root + "/" + c.input);
    for (std::string argument : c.arguments) {
        suite::replace_all(argument, "@ROOT@", root);
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
        result.overlap = overlap(base::read_png(c.expected), base::read_png(picture));
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
