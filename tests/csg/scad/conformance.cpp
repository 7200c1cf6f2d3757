#include "tests/csg/scad/conformance.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/camera.h"
#include "csg/scad/scad.h"
#include "csg/scad/text/csg_text.h"
#include "tests/support/suite.h"
#include "tests/support/temporary_folder.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/picture/camera.h"

namespace conformance {

namespace {

namespace fs = std::filesystem;
using namespace csg::scad;

std::string without_timestamps(std::string text) {
    constexpr std::string_view kWord = ", timestamp = ";
    for (std::size_t at = text.find(kWord); at != std::string::npos; at = text.find(kWord, at)) {
        text.erase(at, text.find_first_not_of("-0123456789", at + kWord.size()) - at);
    }
    return text;
}

/// Without what depends on the machine, and without the lines that the suite leaves out.
std::vector<std::string> lines(const std::string& text) {
    static const std::string kExcluded = "TRACE:   *** Excluding ";
    std::istringstream in(without_timestamps(text));
    std::vector<std::string> result;
    for (std::string line; std::getline(in, line);) {
        if (!line.empty() && line.back() == '\r') {
            line.pop_back();
        }
        if (!line.starts_with(kExcluded)) {
            result.push_back(line);
        }
    }
    const auto blank = [](const std::string& line) { return line.empty(); };
    result.erase(result.begin(), std::find_if_not(result.begin(), result.end(), blank));
    result.erase(std::find_if_not(result.rbegin(), result.rend(), blank).base(), result.end());
    return result;
}

ReadResult read_in_place(const std::string& path) {
    ReadResult result = read_source_file(path);
    if (auto* const text = std::get_if<std::string>(&result)) {
        suite::move_to(*text, (suite::folder() / "openscad").string());
    }
    return result;
}

Request request_for(const Case& c) {
    Request request;
    request.path = c.input.string();
    request.reader = read_in_place;
    request.measures = ui::make_measures();
    request.search_path = {(suite::folder() / "openscad/libraries").string()};
    for (std::size_t i = 0; i < c.arguments.size(); ++i) {
        if (c.arguments[i] == "-D" && i + 1 < c.arguments.size()) {
            request.definitions.push_back(c.arguments[i + 1]);
        } else if (c.arguments[i] == "--trace-usermodule-parameters=false") {
            request.trace_parameters = false;
        } else if (c.arguments[i] == "--enable=discretization-by-error") {
            request.by_error = true;
        } else if (c.arguments[i] == "--enable=lazy-union") {
            request.lazy_union = true;
        } else if (c.arguments[i] == "--check-parameter-ranges=on") {
            request.check_ranges = true;
        } else if (c.arguments[i] == "--camera" && i + 1 < c.arguments.size()) {
            std::istringstream in(c.arguments[i + 1]);
            std::vector<double> numbers;
            for (std::string number; std::getline(in, number, ',');) {
                numbers.push_back(std::stod(number));
            }
            if (numbers.size() == 6) {
                request.view = ui::scad_view(
                    base::camera_between({numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}));
            }
            if (numbers.size() == 7) {
                request.view.translation = {numbers[0], numbers[1], numbers[2]};
                request.view.rotation = {numbers[3], numbers[4], numbers[5]};
                request.view.distance = numbers[6];
            }
        }
    }
    return request;
}

}  // namespace

std::vector<Case> cases() {
    std::vector<Case> result;
    for (const auto& row : suite::cases()) {
        const std::string kind = row["kind"];
        const bool text_of_lazy_union = kind == "lazyunion" && row["suffix"] == "csg";
        if (kind == "echo" || kind == "csg" || text_of_lazy_union) {
            result.push_back({row["name"], kind, suite::input(row), suite::expected(row), row["args"]});
        }
    }
    return result;
}

std::string difference(const Case& c) {
    std::string got;
    const bool quiet = std::find(c.arguments.begin(), c.arguments.end(), "--quiet") != c.arguments.end();
    const Evaluation evaluation = evaluate(request_for(c), [&](const Message& message, const SourceSet& sources) {
        if (c.kind == "echo" && (!quiet || message.severity == Severity::Error)) {
            got += render_openscad(message, sources, c.input.parent_path().string()) + '\n';
        }
    });
    if (c.kind != "echo") {
        got = evaluation.ok ? csg_text(*evaluation.tree) : "";  // A failed run writes nothing.
    }
    std::string expected = test_support::read_file(c.expected);
    suite::replace_all(expected, "../../tests", fs::proximate(suite::folder() / "openscad/tests").string());
    const auto want = lines(expected), have = lines(got);
    for (std::size_t i = 0; i < std::max(want.size(), have.size()); ++i) {
        const std::string w = i < want.size() ? want[i] : "(end)", h = i < have.size() ? have[i] : "(end)";
        if (w != h) {
            return fmt::format("line {}: expected {:.200}\n{:>24} {:.200}", i + 1, w, "got", h);
        }
    }
    return {};
}

}  // namespace conformance
