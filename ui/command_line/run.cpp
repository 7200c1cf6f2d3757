#include "ui/command_line/run.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <new>
#include <thread>

#include <fmt/format.h>

#include "csg/scad/ast_text.h"
#include "csg/scad/csg_text.h"
#include "csg/scad/parser.h"
#include "csg/scad/scad.h"
#include "csg/scad/value.h"
#include "gl/error.h"
#include "ui/command_line/compare.h"
#include "ui/command_line/files.h"
#include "ui/command_line/messages.h"
#include "ui/command_line/options.h"
#include "ui/command_line/parameters.h"
#include "ui/pipeline/camera.h"
#include "ui/pipeline/mesh_cache.h"
#include "ui/pipeline/renderer.h"
#include "ui/pipeline/stopwatch.h"
#include "ui/viewer/window.h"

namespace ui {

namespace {

using Json = nlohmann::ordered_json;

/// Says on a terminal what is going on; nothing elsewhere.
class Progress {
  public:
    explicit Progress(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) == 1) {}
    ~Progress() { say(""); }
    void say(const char* stage) const {
        if (shown_) {
            fmt::print(stderr, "\r\033[K{}", stage);
            std::fflush(stderr);
        }
    }

  private:
    bool shown_;
};

/// Asks for a stop once the time is over, unless it is destroyed before.
class TimeLimit {
  public:
    TimeLimit(double seconds, std::stop_source stop) {
        if (seconds > 0) {
            thread_ = std::jthread([this, seconds, stop = std::move(stop)](const std::stop_token& done) mutable {
                std::unique_lock lock(mutex_);
                std::condition_variable_any never;
                if (!never.wait_for(lock, done, std::chrono::duration<double>(seconds), [] { return false; }) &&
                    !done.stop_requested()) {
                    passed_ = true;
                    stop.request_stop();
                }
            });
        }
    }
    [[nodiscard]] bool passed() const { return passed_; }

  private:
    std::mutex mutex_;
    std::atomic<bool> passed_ = false;
    std::jthread thread_;
};

/// An angle in degrees from 0 up to 360, as OpenSCAD gives them in $vpr.
double turned(double degrees) {
    return degrees < 0 ? degrees + 360 : degrees;
}

bool wants(const Options& options, Format format) {
    return std::any_of(options.outputs.begin(), options.outputs.end(),
                       [&](const Output& output) { return output.format == format; });
}

void write_outputs(const Options& options, Format format, const std::string& bytes) {
    for (const Output& output : options.outputs) {
        if (output.format == format) {
            write_output(output.path, bytes);
        }
    }
}

/// How to draw, whatever the view and the size.
PictureRequest picture_of(const Options& options) {
    PictureRequest request;
    request.style = options.style;
    request.settings = options.settings;
    request.scheme = options.scheme;
    request.layers = options.layers.value_or(-1);
    request.samples = options.samples;
    request.transparent_background = options.transparent_background;
    return request;
}

/// One run: the source, what became of it, and the figures.
class Run {
  public:
    explicit Run(Options options)
        : options_(std::move(options)), messages_(options_.quiet), progress_(options_.quiet) {}

    /// False where an error in the file ended it; the messages have said why.
    bool operator()() {
        check();
        read();
        if (only({Format::Ast, Format::Param})) {
            return write_syntax(true);  // Nothing needs to run.
        }
        if (wants(options_, Format::Ast) || wants(options_, Format::Param)) {
            (void)write_syntax(false);  // What is wrong with the text, evaluate() tells.
        }
        if (!evaluate()) {
            return only({Format::Echo}) && evaluation_.parsed && !evaluation_.stopped && !options_.hard_warnings;
        }
        if (wants(options_, Format::Csg)) {
            write_outputs(options_, Format::Csg, csg::scad::csg_text(*evaluation_.tree));
        }
        if (wants(options_, Format::Mesh)) {
            // OpenSCAD evaluates with $preview false where a mesh is wanted; so did evaluate().
            build();
            export_mesh();
        } else if (wants(options_, Format::Png) || options_.statistics || options_.summary || options_.summary_file) {
            build();
        }
        if (wants(options_, Format::Png)) {
            draw();
        }
        report();
        return true;
    }

  private:
    /// Outputs that need the text to be read only; none where it has errors.
    bool write_syntax(bool tell) {
        const csg::scad::Parsed parsed = parse();
        if (tell) {
            for (const csg::scad::Message& message : parsed.messages) {
                messages_.add(message, parsed.program.sources);
            }
        }
        if (!parsed.ok || (tell && options_.hard_warnings && messages_.warnings() != 0)) {
            return false;
        }
        if (wants(options_, Format::Ast)) {
            write_outputs(options_, Format::Ast, csg::scad::ast_text(parsed.program));
        }
        if (wants(options_, Format::Param)) {
            const std::string title = std::filesystem::path(options_.input).stem().string();
            write_outputs(options_, Format::Param, parameters_json(parsed.program, title));
        }
        return true;
    }

    /// Whether nothing but outputs of these formats is asked for. (Where that is what the console shows, a failed
    /// assertion is but a line of it.)
    [[nodiscard]] bool only(std::initializer_list<Format> formats) const {
        return !options_.outputs.empty() && !options_.statistics && !options_.summary && !options_.summary_file &&
               !options_.dependencies &&
               std::all_of(options_.outputs.begin(), options_.outputs.end(), [&](const Output& output) {
                   return std::find(formats.begin(), formats.end(), output.format) != formats.end();
               });
    }

    void check() const {
        std::vector<std::string> to_standard_output;
        for (const Output& output : options_.outputs) {
            if (output.path == "-") {
                to_standard_output.emplace_back("-o");
            }
        }
        for (const auto& [name, path] :
             {std::pair("--stats", options_.statistics), std::pair("--summary-file", options_.summary_file)}) {
            if (path == "-") {
                to_standard_output.emplace_back(name);
            }
        }
        if (to_standard_output.size() > 1) {
            throw UsageError(
                fmt::format("only one of {} can go to standard output", fmt::join(to_standard_output, ", ")));
        }
        check_picture(picture_request({}));
    }

    void read() {
        request_.path = options_.input == "-" ? "<stdin>" : options_.input;
        request_.text = options_.input == "-" ? read_standard_input() : read_source(options_.input);
        request_.definitions = options_.definitions;
        request_.preview = options_.preview && !wants(options_, Format::Mesh);
        request_.check_ranges = options_.check_ranges;
        request_.trace_parameters = options_.trace_parameters;
        request_.trace_depth = static_cast<std::size_t>(options_.trace_depth);
        if (options_.memory_limit != 0) {
            limit_memory();
        }
        if (!options_.parameter_file.empty() && !options_.parameter_set.empty()) {
            take_parameter_set();
        }
        if (options_.camera) {
            const gl::Camera& camera = *options_.camera;
            request_.view = {{camera.target.x, camera.target.y, camera.target.z},
                             {turned(camera.rotation.x), turned(camera.rotation.y), turned(camera.rotation.z)},
                             camera.distance,
                             camera.fov};
        }
    }

    /// The kernel refuses more, which ends in std::bad_alloc; lists say first, and with a place, that they are too
    /// long.
    void limit_memory() {
        const std::size_t bytes = static_cast<std::size_t>(options_.memory_limit) << 20;
        auto& most = request_.limits.list_elements;
        most = std::min(most, bytes / sizeof(csg::scad::Value) / 2);
        const rlim_t data = bytes + request_.limits.stack_bytes;  // The deep stack is reserved, not used.
        rlimit limit{};
        if (getrlimit(RLIMIT_DATA, &limit) == 0) {
            limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? data : std::min(data, limit.rlim_max);
            (void)setrlimit(RLIMIT_DATA, &limit);
        }
    }

    /// As OpenSCAD does, goes on with the file's own values where the set is not to be had. -D counts above a set.
    void take_parameter_set() {
        auto text = csg::scad::read_source_file(options_.parameter_file);
        if (const auto* error = std::get_if<csg::scad::ReadError>(&text)) {
            messages_.warn(fmt::format("Can't open parameter file: {}", error->text));
            return;
        }
        ParameterSet set = read_parameter_set(parse().program, std::get<std::string>(text), options_.parameter_file,
                                              options_.parameter_set);
        if (!set.problem.empty()) {
            messages_.warn(set.problem);
        }
        request_.definitions.insert(request_.definitions.begin(), std::make_move_iterator(set.definitions.begin()),
                                    std::make_move_iterator(set.definitions.end()));
    }

    [[nodiscard]] bool evaluate() {
        progress_.say("Evaluating…");
        Stopwatch watch;
        std::stop_source stop;
        request_.stop = stop.get_token();
        bool stopped_by_warning = false;
        const TimeLimit limit(options_.time_limit, stop);
        evaluation_ = csg::scad::evaluate(request_, [&](const auto& message, const auto& sources) {
            if (stopped_by_warning) {
                return;  // The stopped evaluation says so; the warning has said why.
            }
            progress_.say("");
            messages_.add(message, sources);
            if (options_.hard_warnings && messages_.warnings() != 0) {
                stopped_by_warning = true;
                stop.request_stop();
            }
        });
        evaluate_ms_ = watch.lap();
        if (limit.passed() && evaluation_.stopped) {
            print_error(fmt::format("--time-limit: not done after {} seconds", options_.time_limit));
        }
        write_outputs(options_, Format::Echo, messages_.echo_text());
        return evaluation_.ok && !stopped_by_warning;
    }

    void build() {
        progress_.say("Building the model…");
        ModelBuilder builder;
        if (!options_.preview) {
            builder.set_flat_thickness(0x1p-10);  // --render: outlines are flat.
        }
        model_ = builder.build(evaluation_.tree);
        for (const std::string& warning : model_->warnings) {
            messages_.warn(warning);
        }
        if (options_.hard_warnings && !model_->warnings.empty()) {
            throw ModelError("stopped at a warning");
        }
        camera_ = choose_camera({options_.camera, options_.projection, options_.view_all, options_.autocenter},
                                evaluation_.view, model_->box);
    }

    [[nodiscard]] PictureRequest picture_request(const gl::Camera& camera) const {
        PictureRequest request = picture_of(options_);
        request.camera = camera;
        request.size = options_.size;
        return request;
    }

    void draw() {
        progress_.say("Drawing…");
        Stopwatch watch;
        const auto context = gl::create_context(options_.context);
        Renderer renderer(*context, options_.engine);
        const double context_ms = watch.lap();
        const gl::Image image = renderer.render(*model_, picture_request(camera_));
        (void)watch.lap();
        const std::string png = gl::encode_png(image);
        picture_json_ = to_json(renderer.statistics());
        picture_json_["ms"]["context"] = context_ms;
        picture_json_["ms"]["encode"] = watch.lap();
        picture_json_["context"] = gl::name(context->kind());
        picture_json_["renderer"] = context->renderer();
        picture_json_["opengl"] = context->version();
        progress_.say("");
        write_outputs(options_, Format::Png, png);
    }

    void export_mesh() {
        progress_.say("Computing the mesh…");
        MeshCache cache(options_.cache);
        mesh_ = cache.get(*model_);
        mesh_known_ = cache.hit();
        progress_.say("");
        if (!cache.problem().empty()) {
            messages_.warn(cache.problem());
        }
        for (const Output& output : options_.outputs) {
            if (output.format == Format::Mesh) {
                write_output(output.path, encode_mesh(*model_, *mesh_, output.mesh));
            }
        }
    }

    /// What is written beside the outputs.
    void report() {
        if (options_.dependencies) {
            std::vector<std::string> targets;
            for (const Output& output : options_.outputs) {
                targets.push_back(output.path);
            }
            write_output(*options_.dependencies, dependency_rules(targets, evaluation_.files));
        }
        if (options_.statistics) {
            write_output(*options_.statistics, statistics().dump(2) + "\n");
        }
        if (options_.summary_file) {
            write_output(*options_.summary_file, summary().dump(2) + "\n");
        }
        if (options_.summary && !options_.quiet) {
            fmt::print(stderr, "{}\n", summary().dump(2));
        }
    }

    [[nodiscard]] Json statistics() const {
        Json all = to_json(model_->statistics);
        const Json model_ms = all["ms"];
        all.erase("ms");
        all["width"] = options_.size.x;
        all["height"] = options_.size.y;
        all["warnings"] = messages_.warnings();
        Json ms = {{"evaluate", evaluate_ms_}};
        ms.update(model_ms);
        if (mesh_) {
            ms["boolean"] = mesh_->boolean_ms;
            all["mesh"] = to_json(*mesh_);
            all["mesh"]["cached"] = mesh_known_;
        }
        if (!picture_json_.is_null()) {
            ms.update(picture_json_["ms"]);
            all.update(picture_json_);
        }
        all["ms"] = ms;
        return all;
    }

    [[nodiscard]] Json summary() const {
        const auto array = [](const glm::dvec3& v) { return Json{v.x, v.y, v.z}; };
        Json json = {{"camera", to_json(camera_)}, {"bounding_box", nullptr}};
        if (!model_->empty()) {
            json["bounding_box"] = {
                {"min", array(model_->box.lo)}, {"max", array(model_->box.hi)}, {"size", array(model_->box.size())}};
        }
        if (mesh_) {
            json["geometry"] = to_json(*mesh_);
        }
        return json;
    }

    [[nodiscard]] csg::scad::Parsed parse() const {
        return csg::scad::parse({request_.path, *request_.text, request_.definitions});
    }

    Options options_;
    Messages messages_;
    Progress progress_;
    csg::scad::Request request_;
    csg::scad::Evaluation evaluation_;
    std::shared_ptr<const Model> model_;
    std::shared_ptr<const ModelMesh> mesh_;
    bool mesh_known_ = false;  ///< From the cache.
    gl::Camera camera_;
    double evaluate_ms_ = 0;
    Json picture_json_;
};

int open_window(const Options& options) {
    WindowOptions window;
    window.source.path = options.input;
    if (options.input == "-") {
        window.source.text = read_standard_input();
    } else {
        (void)read_source(options.input);  // A file that is not there is told before a window opens.
    }
    window.source.definitions = options.definitions;
    window.source.preview = options.preview;
    window.source.hard_warnings = options.hard_warnings;
    window.camera = {options.camera, options.projection, options.view_all, options.autocenter};
    window.picture = picture_of(options);
    window.engine = options.engine;
    window.frames_log = options.frames_log;
    return run_window(window);
}

std::string information(gl::ContextKind kind) {
    std::string text = "csgscope version " CSGSCOPE_VERSION "\n";
    for (const gl::ContextKind each : {gl::ContextKind::Egl, gl::ContextKind::Osmesa}) {
        if (kind != gl::ContextKind::Auto && kind != each) {
            continue;
        }
        try {
            const auto context = gl::create_context(each);
            text += fmt::format("{}: {}, OpenGL {}{}\n", gl::name(each), context->renderer(), context->version(),
                                context->software() ? " (software)" : "");
        } catch (const gl::Error& error) {
            text += fmt::format("{}: not to be had: {}\n", gl::name(each), error.what());
        }
    }
    return text;
}

int run_or_throw(const std::vector<std::string>& arguments) {
    if (!arguments.empty() && arguments[0] == "compare") {
        return run_compare({arguments.begin() + 1, arguments.end()});
    }
    CommandLine line = read_command_line(arguments);
    Options& options = line.options;
    if (line.text || options.information) {
        write_output("-", line.text ? *line.text : information(options.context));
        return 0;
    }
    if (options.input.empty()) {
        throw UsageError("no input file; see csgscope --help");
    }
    if (options.outputs.empty() && !options.statistics && !options.summary && !options.summary_file) {
        return open_window(options);
    }
    return Run(std::move(options))() ? 0 : 1;
}

}  // namespace

int run(const std::vector<std::string>& arguments) {
    try {
        return run_or_throw(arguments);
    } catch (const std::bad_alloc&) {
        print_error("out of memory");
    } catch (const std::exception& error) {
        print_error(error.what());
    }
    return 1;
}

}  // namespace ui
