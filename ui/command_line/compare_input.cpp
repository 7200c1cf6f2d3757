#include "ui/command_line/compare_input.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/file.h"
#include "base/stop.h"
#include "ui/command_line/files.h"
#include "ui/command_line/messages.h"
#include "ui/command_line/openscad_process.h"
#include "ui/command_line/usage_error.h"
#include "ui/pipeline/mesh/mesh.h"

namespace ui {

namespace {

std::string read_file(const std::string& path) {
    std::optional<std::string> bytes = base::read_regular_file(path);
    if (!bytes) {
        throw UsageError(fmt::format("{}: cannot be read, or is no regular file", path));
    }
    return std::move(*bytes);
}

}  // namespace

csg::scad::Evaluation evaluate(const CompareOptions& o, bool preview) {
    csg::scad::Request request;
    request.path = o.input;
    // So git names a version that there is not.
    request.text = o.input == "/dev/null" ? "" : read_source(o.input);
    request.preview = preview;
    request.stop = o.stop;
    Messages messages(true);
    ProgramRun run = o.runner->run(request, false, [&](const auto& message, const auto& sources) {
        messages.add(message, sources);
        return messages.warnings();
    });
    base::end_if_asked(o.stop);
    if (!run.good()) {
        throw ModelError("the model has errors");
    }
    return std::move(run.evaluation);
}

ComparedModel load(const CompareOptions& o) {
    const csg::scad::Evaluation evaluation = evaluate(o, !o.reference.empty());
    return {ModelBuilder().build(evaluation.tree, o.stop, evaluation.program), evaluation.view};
}

csg::reference::Mesh reference_mesh(const CompareOptions& o, const Model& model) {
    if (o.against == "cgal") {
        return make_mesh(model, o.stop).mesh;
    }
    if (o.against == "openscad") {
        return OpenscadProcess(o.input).mesh();
    }
    try {
        return csg::reference::decode_mesh(read_file(o.against));
    } catch (const UsageError&) {
        throw;
    } catch (const std::exception& error) {
        throw UsageError(fmt::format("{}: {}", o.against, error.what()));
    }
}

}  // namespace ui
