#include "ui/viewer/revision.h"

#include <new>

#include "base/stop.h"
#include "csg/scad/syntax/appended_text.h"
#include "csg/tree/changes.h"
#include "csg/tree/explain.h"
#include "csg/tree/left_over.h"
#include "csg/tree/out_of_memory.h"
#include "ui/pipeline/following_builder.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/program_runner.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

namespace {

/// The tree itself where the call is not there any more, which a message tells.
std::shared_ptr<const csg::Tree> explained_tree(const std::shared_ptr<const csg::Tree>& tree, const CallAt& call,
                                                MessageLog& messages) {
    for (const csg::Statement* statement : csg::explainable(*tree)) {
        const csg::SourceLocation& where = statement->where;
        if (where.line == call.line && where.column == call.column && tree->files()[where.file] == call.file) {
            return std::make_shared<const csg::Tree>(csg::explained(*tree, where));
        }
    }
    messages.add(LineKind::Note, "The " + call.name + " that was explained is not there any more.");
    return tree;
}

/// What a customizer shows. What the parser has to say is told by the run.
std::optional<std::vector<csg::scad::CustomizerParameter>> parameters_of(ProgramRunner& runner,
                                                                         const csg::scad::Request& request) {
    const auto program = runner.load(request, [](const auto&, const auto&) { return std::size_t{0}; });
    return program && program->well_formed() ? std::optional(program->look(csg::scad::customizer_parameters))
                                             : std::nullopt;
}

std::optional<csg::SourceLocation> place_in(const csg::Tree& tree, const CallAt& call) {
    for (const csg::Statement& statement : tree.statements()) {
        const csg::SourceLocation& where = statement.where;
        if (where.line == call.line && where.column == call.column && tree.files()[where.file] == call.file) {
            return where;
        }
    }
    return std::nullopt;
}

/// What is to be seen of it; calls that are not there any more do not count.
std::shared_ptr<const csg::Tree> shown_tree(const std::shared_ptr<const csg::Tree>& tree, const Source& source) {
    std::vector<csg::SourceLocation> hidden;
    for (const CallAt& call : source.hidden) {
        if (const auto where = place_in(*tree, call)) {
            hidden.push_back(*where);
        }
    }
    const auto alone = source.alone ? place_in(*tree, *source.alone) : std::nullopt;
    return hidden.empty() && !alone ? tree : std::make_shared<const csg::Tree>(csg::left_over(*tree, hidden, alone));
}

/// That of the file, with the same definitions; null, with messages, where it has errors.
std::shared_ptr<const csg::Tree> tree_of(const Baseline& before, csg::scad::Request request, ProgramRunner& runner,
                                         Revision& revision) {
    if (before.tree) {
        return before.tree;
    }
    request.path = before.path;
    request.text.reset();
    const ProgramRun run = runner.run(request, false, [&](const auto& message, const auto& sources) {
        revision.messages.add(message, sources);
        return revision.messages.warnings();
    });
    revision.files.insert(run.evaluation.looked_for.begin(), run.evaluation.looked_for.end());
    return run.good() ? run.evaluation.tree : nullptr;
}

/// The tree with glyphs of the program's motion, where that is known.
std::shared_ptr<const csg::Tree> depicted_tree(const std::shared_ptr<const csg::Tree>& tree, const Source& source,
                                               const ProgramRun& run, const csg::scad::Request& request,
                                               ProgramRunner& runner, const std::stop_token& stop, Revision& revision) {
    const auto& wanted = source.depicted;
    if (!wanted || wanted->depictions.empty() || !wanted->motion || source.before || source.explained ||
        wanted->of.program != run.evaluation.program || wanted->of.customized != source.customized) {
        return tree;
    }
    const auto camera_at = [&](double time) {
        csg::scad::Request at = request;
        at.time = time;
        const auto view = runner.run(at, false, [](const auto&, const auto&) { return std::size_t{0}; });
        base::end_if_asked(stop);
        return choose_camera({}, view.evaluation.view, {});
    };
    Depicted made = depict_what_can({*tree, *wanted->motion, source.time, camera_at, wanted->aspect},
                                    wanted->depictions, revision.depiction_problems, stop);
    revision.depicted = wanted;
    revision.bubbles = std::move(made.bubbles);
    revision.frames = std::move(made.frames);
    revision.styles = std::move(made.styles);
    return std::make_shared<const csg::Tree>(std::move(made.tree));
}

void evaluate_and_build(Revision& revision, const Source& source, const csg::scad::View& camera,
                        FollowingBuilder& builder, ProgramRunner& runner, const std::stop_token& stop) {
    if (csg::scad::has_statements(source.definitions) && !source.text && !source.edited) {
        revision.files.emplace(source.path, csg::scad::disk_state(source.path));
    }
    csg::scad::Request request = request_of(source, camera, stop);
    revision.parameters = parameters_of(runner, request);
    request.definitions.insert(request.definitions.end(), source.customized.begin(), source.customized.end());
    const ProgramRun run = runner.run(request, source.hard_warnings, [&](const auto& message, const auto& sources) {
        revision.messages.add(message, sources);
        return revision.messages.warnings();
    });
    const csg::scad::Evaluation& evaluation = run.evaluation;
    revision.files.insert(evaluation.looked_for.begin(), evaluation.looked_for.end());
    revision.sources = evaluation.sources;
    revision.view = evaluation.view;
    revision.evaluate_ms = run.milliseconds;
    if (run.stopped_by_warning) {
        revision.messages.add(LineKind::Error, "stopped at a warning");
    }
    if (!run.good() || stop.stop_requested()) {
        return;
    }
    revision.tree = evaluation.tree;
    if (source.before) {
        revision.before = tree_of(*source.before, request, runner, revision);
        if (!revision.before) {
            return;
        }
    }
    Stopwatch watch;
    const std::shared_ptr<const csg::Tree> tree =
        source.before ? std::make_shared<const csg::Tree>(csg::changes(*revision.before, *evaluation.tree))
        : source.explained
            ? explained_tree(evaluation.tree, *source.explained, revision.messages)
            : depicted_tree(shown_tree(evaluation.tree, source), source, run, request, runner, stop, revision);
    builder.show(source.showing);
    builder.divide(source.parts);
    builder.cut(source.sections);
    auto model = builder.build(tree, stop, evaluation.program);
    revision.build_ms = watch.lap();
    for (const auto* texts : {&model->warnings, &model->failures}) {
        for (const std::string& text : *texts) {
            revision.messages.add(LineKind::Warning, "WARNING: " + text);
        }
    }
    if (source.hard_warnings && !(model->warnings.empty() && model->failures.empty())) {
        revision.messages.add(LineKind::Error, "stopped at a warning");
        return;
    }
    revision.model = std::move(model);
}

Revision make_revision(const Source& source, const csg::scad::View& camera, FollowingBuilder& builder,
                       ProgramRunner& runner, const std::stop_token& stop) {
    Revision revision;
    try {
        evaluate_and_build(revision, source, camera, builder, runner, stop);
    } catch (const base::Stopped&) {
        // Another revision takes its place.
    } catch (const csg::OutOfMemory& out) {
        revision.messages.add(LineKind::Error, std::string("ERROR: out of memory for ") + out.what());
    } catch (const std::bad_alloc&) {
        revision.messages.add(LineKind::Error, "ERROR: out of memory");
    } catch (const std::exception& error) {
        revision.messages.add(LineKind::Error, std::string("ERROR: ") + error.what());
    }
    return revision;
}

}  // namespace

csg::scad::Request request_of(const Source& source, const csg::scad::View& camera, const std::stop_token& stop) {
    csg::scad::Request request;
    request.path = source.path;
    request.text = source.edited ? source.edited : source.text;
    request.definitions = source.definitions;
    if (csg::scad::has_statements(request.definitions)) {
        auto text = request.text ? csg::scad::ReadResult(*request.text) : csg::scad::read_source_file(source.path);
        if (auto* const read = std::get_if<std::string>(&text)) {  // Why there is none, the run tells.
            csg::scad::append_statements(*read, request.definitions);
            request.text = std::move(*read);
        }
    }
    request.preview = source.preview;
    request.by_error = source.by_error;
    request.lazy_union = source.lazy_union;
    request.view = camera;
    request.stop = stop;
    request.time = source.time;
    return request;
}

Evaluate make_evaluate() {
    return [builder = std::make_shared<FollowingBuilder>(), runner = std::make_shared<ProgramRunner>(make_measures())](
               const Source& source, const csg::scad::View& camera, const std::stop_token& stop) {
        return make_revision(source, camera, *builder, *runner, stop);
    };
}

}  // namespace ui
