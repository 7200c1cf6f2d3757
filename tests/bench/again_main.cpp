// What a second run of a program takes beside the first: with nothing changed, another $t, another value of a variable,
// an edit of the main file, and of one of those that it is made of. Processor time, the best of several.
//
//     csgscope_again [--repeat N] FILE.scad …
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "csg/scad/program/program_cache.h"

namespace {

namespace fs = std::filesystem;
using namespace csg::scad;

double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Copies of all that a program is made of, at the same paths below a folder of their own: they may be edited.
class Copies {
  public:
    explicit Copies(const std::string& program) {
        Request request;
        request.path = fs::absolute(program).lexically_normal().string();
        const Evaluation evaluation = evaluate(request, {});
        std::string name = (fs::temp_directory_path() / "csgscope-again-XXXXXX").string();
        folder_ = mkdtemp(name.data());
        for (const std::string& file : evaluation.files) {
            const fs::path absolute = fs::absolute(file).lexically_normal();
            if (fs::is_regular_file(absolute) && !fs::exists(copy_of(absolute))) {
                fs::create_directories(copy_of(absolute).parent_path());
                fs::copy_file(absolute, copy_of(absolute));
                files_.push_back(copy_of(absolute).string());
            }
        }
        request_.path = copy_of(request.path).string();
        for (std::string& path : request_.search_path) {
            path = copy_of(path).string();
        }
    }
    ~Copies() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Copies(const Copies&) = delete;
    Copies& operator=(const Copies&) = delete;

    [[nodiscard]] const Request& request() const { return request_; }
    [[nodiscard]] std::size_t size() const { return files_.size(); }
    void edit_main() const { edit(request_.path); }
    /// One that is not the main file, if there is one: in the middle of the list.
    [[nodiscard]] bool edit_other() const {
        const std::string& file = files_[files_.size() / 2];
        edit(file);
        return file != request_.path;
    }

  private:
    [[nodiscard]] fs::path copy_of(const fs::path& path) const { return folder_ / fs::absolute(path).relative_path(); }
    static void edit(const std::string& file) { std::ofstream(file, std::ios::app) << "\n"; }

    fs::path folder_;
    Request request_;
    std::vector<std::string> files_;
};

/// The name of a number that the main file sets at top level.
std::optional<std::string> variable_of(const LoadedProgram& program) {
    return program.look([](const Program& p) -> std::optional<std::string> {
        for (const Argument& a : p.assignments_of(p.blocks[p.units[0].block])) {
            if (a.where.file == p.units[0].file && p[a.value].kind == ExprKind::Number) {
                return fmt::format("{}={}", p.symbols.text(a.name), p[a.value].number);
            }
        }
        return std::nullopt;
    });
}

struct Row {
    double first = 1e9, again = 1e9, time = 1e9, variable = 1e9, main = 1e9, other = 1e9;
};

void take(double& best, ProgramCache& cache, const Request& request) {
    const double before = processor_ms();
    (void)cache.evaluate(request, {});
    best = std::min(best, processor_ms() - before);
}

void measure(const Copies& copies, Row& row) {
    ProgramCache cache;
    Request request = copies.request();
    take(row.first, cache, request);
    const auto program = cache.load(request, {});
    take(row.again, cache, request);
    request.time = 0.5;
    take(row.time, cache, request);
    if (const auto definition = program->well_formed() ? variable_of(*program) : std::nullopt) {
        request.definitions = {*definition};
        (void)cache.evaluate(request, {});
        request.definitions = {*definition + " + 0"};
        take(row.variable, cache, request);
        request.definitions.clear();
        (void)cache.evaluate(request, {});
    }
    copies.edit_main();
    take(row.main, cache, request);
    if (copies.edit_other()) {
        take(row.other, cache, request);
    }
}

std::string shown(double ms, double first) {
    return ms > 1e8 ? "—" : fmt::format("{:.2f} ({:.1f} ×)", ms, first / ms);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> files(argv + 1, argv + argc);
    int repeat = 5;
    if (files.size() >= 2 && files[0] == "--repeat") {
        repeat = std::max(1, std::atoi(files[1].c_str()));
        files.erase(files.begin(), files.begin() + 2);
    }
    std::cout << "| program | files | first, ms | again | other $t | other variable | main file edited | another file "
                 "edited |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const std::string& file : files) {
        const Copies copies(file);
        std::this_thread::sleep_for(std::chrono::seconds(4));  // Files that have just been written are not trusted.
        Row row;
        for (int i = 0; i < repeat; ++i) {
            measure(copies, row);
        }
        std::cout << fmt::format("| {} | {} | {:.2f} | {} | {} | {} | {} | {} |\n", fs::path(file).filename().string(),
                                 copies.size(), row.first, shown(row.again, row.first), shown(row.time, row.first),
                                 shown(row.variable, row.first), shown(row.main, row.first),
                                 shown(row.other, row.first))
                  << std::flush;
    }
}
