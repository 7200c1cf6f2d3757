// csgscope_conformance_pictures PROGRAM FOLDER [PART_OF_A_NAME]: draws OpenSCAD's rendered pictures with the program,
// prints a table of how much the silhouettes share, and writes FOLDER/index.html for looking at them side by side.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "base/file.h"
#include "base/image.h"
#include "tests/pictures/conformance_pictures.h"
#include "tests/pictures/silhouette.h"
#include "tests/support/suite.h"

namespace {

namespace fs = std::filesystem;
using pictures::Case;
using pictures::Result;

/// Expected, drawn and difference, those that differ most first.
std::string html(const std::vector<Case>& cases, const std::vector<Result>& results, const fs::path& folder) {
    std::vector<std::size_t> order(cases.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return results[a].overlap < results[b].overlap; });
    std::string text =
        "<!doctype html><meta charset=\"utf-8\"><title>OpenSCAD's pictures and csgscope's</title>\n"
        "<style>body{font:14px sans-serif}img{width:240px;height:240px;margin:2px}td{vertical-align:top}</style>\n"
        "<p>Expected, drawn, and where silhouettes differ (red: missing, green: too much).\n<table>\n";
    for (const std::size_t i : order) {
        const std::string name = cases[i].name;
        fs::copy_file(cases[i].expected, folder / (name + ".expected.png"), fs::copy_options::overwrite_existing);
        text += fmt::format("<tr><td>{}<br>{}<td><img src=\"{}.expected.png\">", name,
                            results[i].problem.empty() ? fmt::format("{:.4f}", results[i].overlap) : results[i].problem,
                            name);
        if (results[i].problem.empty()) {
            base::write_file(folder / (name + ".difference.png"),
                             base::encode_png(pictures::difference(base::read_png(cases[i].expected),
                                                                   base::read_png(folder / (name + ".png")))));
            text += fmt::format("<td><img src=\"{0}.png\"><td><img src=\"{0}.difference.png\">", name);
        }
        text += "\n";
    }
    return text + "</table>\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3 || argc > 4) {
        fmt::print(stderr, "usage: {} PROGRAM FOLDER [PART_OF_A_NAME]\n", argv[0]);
        return 2;
    }
    std::vector<Case> cases = pictures::cases();
    if (cases.empty()) {
        fmt::print(stderr, "no conformance data in {}\n", suite::folder().string());
        return 1;
    }
    if (argc == 4) {
        std::erase_if(cases, [&](const Case& c) { return c.name.find(argv[3]) == std::string::npos; });
    }
    const fs::path folder = fs::absolute(argv[2]);
    fs::create_directories(folder);
    const std::vector<Result> results = pictures::draw(fs::absolute(argv[1]).string(), cases, folder);
    std::size_t good = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        good += results[i].good() ? 1 : 0;
        fmt::print("{} {:.4f} {:6.2f} s  {}  {}\n", results[i].good() ? "ok  " : "FAIL", results[i].overlap,
                   results[i].seconds, cases[i].name, results[i].problem);
    }
    base::write_file(folder / "index.html", html(cases, results, folder));
    fmt::print("{} of {} silhouettes overlap by 0.99 or more; {}\n", good, cases.size(),
               (folder / "index.html").string());
    return 0;
}
