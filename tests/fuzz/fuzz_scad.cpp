// libFuzzer target: any bytes are a program. Parsing, printing, and evaluating it within small limits must neither
// crash, nor hang, nor take memory without bound. tests/fuzz/run builds and runs it.
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "csg/scad/ast_text.h"
#include "csg/scad/csg_text.h"
#include "csg/scad/customizer.h"
#include "csg/scad/parser.h"
#include "csg/scad/scad.h"

namespace {

using namespace csg::scad;

ReadResult no_files(const std::string& path) {
    return ReadError{true, "cannot read " + path + ": there are no files here"};
}

void evaluate_bounded(const std::string& text) {
    Request request;
    request.path = "fuzz.scad";
    request.text = text;
    request.reader = no_files;
    request.search_path.clear();
    request.limits.stack_bytes = std::size_t{32} << 20;
    request.limits.list_elements = 100'000;
    request.limits.nodes = 2'000;
    request.limits.tail_calls = 1'000;
    std::stop_source stop;
    request.stop = stop.get_token();
    constexpr auto kLongest = std::chrono::seconds(2);
    std::mutex mutex;
    std::condition_variable_any never;
    const std::jthread watchdog([&](const std::stop_token& done) {
        std::unique_lock lock(mutex);
        if (!never.wait_for(lock, done, kLongest, [] { return false; }) && !done.stop_requested()) {
            stop.request_stop();
        }
    });
    std::size_t bytes = 0;
    const Evaluation evaluation = evaluate(request, [&](const Message& message, const SourceSet& sources) {
        bytes += render_openscad(message, sources).size() + render(message, sources).size();
    });
    if (evaluation.ok) {
        bytes += csg_text(*evaluation.tree).size();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const Parsed parsed = parse({"fuzz.scad", text, {}, no_files, {}});
    if (parsed.ok) {
        (void)ast_text(parsed.program);
        for (const CustomizerParameter& parameter : customizer_parameters(parsed.program)) {
            (void)fitted_expression(parameter, std::string_view(text).substr(0, 100));
        }
    }
    evaluate_bounded(text);
    return 0;
}
