#include "ui/pipeline/program_runner.h"

#include <stop_token>

#include "ui/pipeline/stopwatch.h"

namespace ui {

namespace {

using csg::scad::Evaluation;
using csg::scad::EvaluationSink;
using csg::scad::Request;

template <typename Evaluate>
ProgramRun run_with(const Evaluate& evaluate, Request& request, bool hard_warnings, const ShowMessage& show) {
    Stopwatch watch;
    ProgramRun run;
    std::stop_source stop;
    const std::stop_callback forward(request.stop, [&stop] { stop.request_stop(); });
    request.stop = stop.get_token();
    run.evaluation = evaluate(request, [&](const auto& message, const auto& sources) {
        if (run.stopped_by_warning) {
            return;  // The stopped evaluation says so; the warning has said why.
        }
        if (show(message, sources) != 0 && hard_warnings) {
            run.stopped_by_warning = true;
            stop.request_stop();
        }
    });
    run.milliseconds = watch.lap();
    return run;
}

}  // namespace

ProgramRun ProgramRunner::run(Request request, bool hard_warnings, const ShowMessage& show) {
    request.measures = measures_;
    return run_with([this](const Request& r, const EvaluationSink& sink) { return programs_.evaluate(r, sink); },
                    request, hard_warnings, show);
}

ProgramRun ProgramRunner::run_once(Request request, bool hard_warnings, const ShowMessage& show) {
    request.measures = measures_;
    return run_with([](const Request& r, const EvaluationSink& sink) { return csg::scad::evaluate(r, sink); }, request,
                    hard_warnings, show);
}

std::shared_ptr<csg::scad::LoadedProgram> ProgramRunner::load(const Request& request, const ShowMessage& show) {
    return programs_.load(request, [&show](const auto& message, const auto& sources) { (void)show(message, sources); });
}

}  // namespace ui
