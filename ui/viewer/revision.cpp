#include "ui/viewer/revision.h"

#include <mutex>
#include <new>

#include "base/stop.h"
#include "csg/tree/out_of_memory.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

namespace {

using Measures = std::shared_ptr<csg::scad::Measures>;

/// Reads files and notes what it was asked for. The evaluation calls it from its own thread.
class NotingReader {
  public:
    csg::scad::ReadResult operator()(const std::string& path) {
        {
            std::scoped_lock lock(mutex_);
            files_.try_emplace(path, stamp_of(path));  // Before it is read: a change in between is a change.
        }
        return csg::scad::read_source_file(path);
    }
    [[nodiscard]] std::map<std::string, FileStamp> files() const { return files_; }

  private:
    std::mutex mutex_;
    std::map<std::string, FileStamp> files_;
};

void evaluate_and_build(Revision& revision, const Source& source, const csg::scad::View& camera, ModelBuilder& builder,
                        const Measures& measures, const std::stop_token& stop) {
    Stopwatch watch;
    NotingReader reader;
    std::stop_source ended;
    const std::stop_callback forward(stop, [&] { ended.request_stop(); });
    bool stopped_by_warning = false;

    csg::scad::Request request;
    request.path = source.path;
    request.text = source.text;
    request.definitions = source.definitions;
    request.preview = source.preview;
    request.by_error = source.by_error;
    request.view = camera;
    request.measures = measures;
    request.stop = ended.get_token();
    request.reader = [&](const std::string& path) { return reader(path); };
    const auto evaluation =
        csg::scad::evaluate(request, [&](const csg::scad::Message& message, const csg::scad::SourceSet& sources) {
            if (stopped_by_warning) {
                return;  // The stopped evaluation says so; the warning has said why.
            }
            revision.messages.add(message, sources);
            if (source.hard_warnings && revision.messages.warnings() != 0) {
                stopped_by_warning = true;
                ended.request_stop();
            }
        });
    revision.files = reader.files();
    // Files of import() and surface() go past the reader. Sources that are no files, such as the definitions of the
    // command line, are listed as well; and the first is the main file, which may be none.
    for (std::size_t i = source.text ? 1 : 0; i < evaluation.files.size(); ++i) {
        if (const FileStamp stamp = stamp_of(evaluation.files[i]); stamp.exists) {
            revision.files.try_emplace(evaluation.files[i], stamp);
        }
    }
    revision.view = evaluation.view;
    revision.evaluate_ms = watch.lap();
    if (stopped_by_warning) {
        revision.messages.add(LineKind::Error, "stopped at a warning");
    }
    if (!evaluation.ok || ended.stop_requested()) {
        return;
    }
    auto model = builder.build(evaluation.tree, ended.get_token());
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

Revision make_revision(const Source& source, const csg::scad::View& camera, ModelBuilder& builder,
                       const Measures& measures, const std::stop_token& stop) {
    Revision revision;
    try {
        evaluate_and_build(revision, source, camera, builder, measures, stop);
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

Evaluate make_evaluate() {
    return [builder = std::make_shared<ModelBuilder>(), measures = make_measures()](
               const Source& source, const csg::scad::View& camera, const std::stop_token& stop) {
        return make_revision(source, camera, *builder, measures, stop);
    };
}

}  // namespace ui
