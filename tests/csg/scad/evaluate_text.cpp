#include "tests/csg/scad/evaluate_text.h"

#include <gtest/gtest.h>

#include "csg/scad/text/csg_text.h"

namespace test {

namespace {

using namespace csg::scad;

template <typename Evaluate>
Run run_with(const Evaluate& evaluate, const std::string& text, const std::map<std::string, std::string>& files,
             Request request) {
    Run result;
    request.path = kMainFile;
    request.text = text;
    request.search_path.clear();
    request.reader = [&files](const std::string& path) -> ReadResult {
        const auto found = files.find(path);
        return found == files.end() ? ReadResult(ReadError{true, "no file " + path}) : ReadResult(found->second);
    };
    result.evaluation = evaluate(request, [&](const Message& message, const SourceSet& sources) {
        result.console += render_openscad(message, sources) + '\n';
    });
    if (result.evaluation.ok) {
        result.csg = csg_text(*result.evaluation.tree);
    }
    return result;
}

}  // namespace

Run run(const std::string& text, const std::map<std::string, std::string>& files, Request request) {
    return run_with([](const Request& r, const EvaluationSink& sink) { return evaluate(r, sink); }, text, files,
                    std::move(request));
}

Run run_kept(ProgramCache& cache, const std::string& text, const std::map<std::string, std::string>& files,
             Request request) {
    return run_with([&](const Request& r, const EvaluationSink& sink) { return cache.evaluate(r, sink); }, text, files,
                    std::move(request));
}

void expect_same(const Run& run, const Run& expected) {
    EXPECT_EQ(run.console, expected.console);
    EXPECT_EQ(run.csg, expected.csg);
    const Evaluation &a = run.evaluation, &b = expected.evaluation;
    EXPECT_EQ(a.files, b.files);
    EXPECT_EQ(std::tie(a.ok, a.parsed, a.stopped, a.out_of_memory, a.errors, a.warnings),
              std::tie(b.ok, b.parsed, b.stopped, b.out_of_memory, b.errors, b.warnings));
    EXPECT_EQ(std::tie(a.view.translation, a.view.rotation, a.view.distance, a.view.fov),
              std::tie(b.view.translation, b.view.rotation, b.view.distance, b.view.fov));
}

}  // namespace test
