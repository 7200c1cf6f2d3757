#include "ui/command_line/run.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/tree/changes.h"
#include "csg/tree/explain.h"
#include "csg/tree/out_of_memory.h"
#include "gl/error.h"
#include "npr/styles/radiograph.h"
#include "ui/command_line/call_place.h"
#include "ui/command_line/check.h"
#include "ui/command_line/compare.h"
#include "ui/command_line/export.h"
#include "ui/command_line/files.h"
#include "ui/command_line/film.h"
#include "ui/command_line/language_run.h"
#include "ui/command_line/measure.h"
#include "ui/command_line/medium_options.h"
#include "ui/command_line/motion.h"
#include "ui/command_line/move.h"
#include "ui/command_line/options.h"
#include "ui/command_line/part_style_options.h"
#include "ui/command_line/pick.h"
#include "ui/command_line/run_checks.h"
#include "ui/command_line/standard_streams.h"
#include "ui/command_line/summary.h"
#include "ui/command_line/thin_places.h"
#include "ui/command_line/time_limit.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/mesh/outline.h"
#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/picture/center_lines.h"
#include "ui/pipeline/picture/exact_bounds.h"
#include "ui/pipeline/picture/flat_lines.h"
#include "ui/pipeline/picture/legend.h"
#include "ui/pipeline/picture/plan.h"
#include "ui/pipeline/picture/radiograph.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/picture/thickness_map.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/sections.h"
#include "ui/pipeline/stopwatch.h"
#include "ui/viewer/window.h"

namespace ui {

namespace {

/// One run: the source, what became of it, and the figures.
class Run {
  public:
    explicit Run(Options options)
        : options_(std::move(options)), limit_(options_.time_limit), language_(options_, limit_, make_measures()) {}

    /// False where an error in the file or the time ended it; the messages have said why.
    bool operator()() {
        try {
            const bool done = run();
            limit_.end();
            return done;
        } catch (const base::Stopped&) {
            limit_.tell();
            return false;
        } catch (const csg::OutOfMemory&) {
            throw;
        } catch (const std::bad_alloc&) {
            throw csg::OutOfMemory(stage_);
        } catch (const std::length_error&) {
            throw csg::OutOfMemory(stage_);
        }
    }

  private:
    bool run() {
        picture_ = picture_of(options_.picture, options_.picture_texts);
        check_combinations(options_, picture_);
        language_.read();
        if (options_.time != 0) {
            set_time(options_.time);
        }
        if (options_.frames == 0) {
            const bool made = make_outputs();
            film_.finish();
            return made;
        }
        const std::vector<Output> outputs = options_.outputs;
        for (int frame = options_.first_frame; frame < options_.end_frame; ++frame) {
            const double part = static_cast<double>(frame) / options_.frames;
            std::transform(outputs.begin(), outputs.end(), options_.outputs.begin(),
                           [frame](const Output& output) { return output_of_frame(output, frame); });
            if (options_.turntable && frame > options_.first_frame) {
                picture_.camera.rotation.z = first_rotation_ + 360 * part;
                draw();
                continue;
            }
            if (options_.turntable) {
                turned_by_ = 360 * part;
            } else {
                set_time(part);
            }
            if (!make_outputs()) {
                return false;
            }
        }
        film_.finish();
        if (options_.statistics && options_.turntable && model_) {
            write_output(*options_.statistics, text_of(statistics()));
        }
        return true;
    }

    void set_time(double time) {
        language_.set_time(time);
        time_ = time;
    }

    bool make_outputs() {
        if (!language_()) {
            return false;
        }
        if (language_.evaluation().tree == nullptr) {
            return true;  // Nothing needed to run, or an error is what the console was to show.
        }
        tree_ = language_.evaluation().tree;
        if (!options_.changes_from.empty()) {
            const auto before = language_.evaluate_other(options_.changes_from);
            if (before == nullptr) {
                return false;
            }
            tree_ = std::make_shared<const csg::Tree>(csg::changes(*before, *tree_));
        }
        explain();
        depict();
        if (needs_geometry(options_) || wants_picture() || options_.statistics || options_.summary ||
            options_.summary_file || options_.pick || options_.measure) {
            build();
        }
        if (options_.pick) {
            pick();
        }
        if (options_.measure) {
            measure();
        }
        if (needs_geometry(options_)) {
            begin("Computing the geometry…", "computing the geometry");
            geometry_ = make_geometry(options_, *exported_, builder_, language_.messages(), limit_.token());
            language_.progress().say("");
            stage_ = "writing the geometry";
            write_geometry(options_, *exported_, geometry_, picture_.camera, language_.messages(), limit_.token());
        }
        if (wants_picture()) {
            draw();
        }
        report();
        return true;
    }

    /// Puts what a call does, or the model without it, in the place of the model.
    void explain() {
        if (!options_.explain.empty()) {
            const auto where =
                call_at(*tree_, csg::explainable(*tree_), "--explain", options_.explain, "difference or intersection");
            tree_ = std::make_shared<const csg::Tree>(csg::explained(*tree_, where));
        } else if (!options_.without.empty()) {
            const auto where = call_at(*tree_, all_calls(*tree_), "--without", options_.without, "call");
            tree_ = std::make_shared<const csg::Tree>(csg::without(*tree_, where));
        }
    }

    /// Puts the glyphs of what moves beside the model.
    void depict() {
        if (options_.depictions.empty()) {
            return;
        }
        if (!motion_) {
            MotionRequest request;
            request.derivatives = false;
            for (const Depiction& d : options_.depictions) {
                request.from = std::min(request.from, d.times ? d.times->first : 0);
                request.to = std::max(request.to, d.times ? d.times->second : 1);
            }
            begin("Looking for what moves…", "looking for what moves");
            motion_ = find_motion([this](double time) { return language_.evaluate_at(time); }, request, limit_.token());
            language_.progress().say("");
        }
        try {
            tree_ = std::make_shared<const csg::Tree>(ui::depict(*tree_, *motion_, options_.depictions, time_));
        } catch (const std::runtime_error& problem) {
            throw UsageError(fmt::format("--depict: {}", problem.what()));
        }
    }

    [[nodiscard]] bool wants_picture() const {
        return wants(options_, Format::Png) || wants(options_, Format::Apng) || wants(options_, Format::Exr);
    }

    void build() {
        begin("Building the model…", "building the model");
        builder_.show(options_.preview ? csg::Showing::Preview : csg::Showing::Result);
        builder_.divide(options_.parts);
        builder_.cut(picture_.sections);
        const auto build_it = [&] { return builder_.build(tree_, limit_.token(), language_.evaluation().program); };
        model_ = exported_ = build_it();
        if (needs_geometry(options_) && options_.preview && shows_misplaced(*model_)) {
            builder_.show(csg::Showing::Result);
            exported_ = build_it();
            if (!wants_picture()) {
                model_ = exported_;
            }
        }
        need_parts(picture_.media, model_->scene);
        need_parts(picture_.part_styles, model_->scene);
        need_parts(picture_.reveal, model_->scene);
        for (const std::string& warning : exported_->warnings) {
            language_.messages().warn(warning);
        }
        if (needs_geometry(options_)) {
            need_whole(*exported_);
        }
        for (const std::string& failure : exported_->failures) {
            language_.messages().warn(failure);  // A picture shows what there is.
        }
        if (options_.hard_warnings && !(exported_->warnings.empty() && exported_->failures.empty())) {
            throw ModelError("stopped at a warning");
        }
        const CameraRequest request{
            options_.camera,   options_.projection,
            options_.view_all, options_.autocenter,
            options_.margin,   static_cast<double>(options_.picture.size.x) / options_.picture.size.y};
        const bool framed =
            needs_box(request, language_.evaluation().view) || options_.summary || options_.summary_file;
        // As OpenSCAD: previews go by the boxes of products, results by what is left.
        box_ = (framed && !options_.preview) || !options_.plan.empty() ? exact_bounds(*model_, limit_.token())
                                                                       : model_->box;
        picture_.camera = choose_camera(request, language_.evaluation().view, box_);
        cut();
        first_rotation_ = picture_.camera.rotation.z;
        picture_.camera.rotation.z += turned_by_;
    }

    /// What is drawn and picked: the camera is chosen for the whole model, so that a section moves nothing.
    void cut() {
        picture_.sections = resolved(std::move(picture_.sections), model_->box, picture_.camera);
        const std::vector<std::string> warnings = section_warnings(*model_, picture_.sections);
        for (const std::string& warning : warnings) {
            language_.messages().warn(warning);
        }
        if (options_.hard_warnings && !warnings.empty()) {
            throw ModelError("stopped at a warning");
        }
        shown_ = &sectioned_.cut(model_, picture_.sections);
    }

    /// Null where a picture is not to wait for OpenGL before it is known to need it.
    [[nodiscard]] std::unique_ptr<gl::Context> wanted_context() const {
        const bool asked = options_.context && *options_.context != gl::ContextKind::Auto;
        const bool perhaps = options_.context == gl::ContextKind::Auto && gl::gpu_possible();
        return asked || perhaps ? gl::create_context(*options_.context) : nullptr;
    }
    [[nodiscard]] Painter painter() const {
        if (!options_.context) {
            return Painter::Cpu;
        }
        return *options_.context == gl::ContextKind::Auto ? Painter::Auto : Painter::OpenGl;
    }

    /// The same for all pictures of the run.
    Renderer& renderer() {
        if (!renderer_) {
            context_ = wanted_context();
            context_ ? renderer_.emplace(*context_, options_.engine, painter())
                     : renderer_.emplace(options_.engine, painter());
        }
        return *renderer_;
    }

    std::vector<PickedSurface> surfaces_at(glm::ivec2 pixel, int layers) {
        const base::Camera camera = pixel_camera(picture_.camera, picture_.size, glm::dvec2(pixel) + 0.5);
        return shown_->empty() ? std::vector<PickedSurface>() : renderer().pick(*shown_, camera, layers);
    }

    void pick() {
        begin("Picking…", "picking");
        const glm::ivec2 at = options_.pick->at;
        const int layers = picture_.layers == npr::kLayersOfStyle ? goldfeather::kAllLayers : picture_.layers;
        const PickReport report{*shown_,         *language_.evaluation().sources, at, picture_.size,
                                picture_.camera, surfaces_at(at, layers)};
        language_.progress().say("");
        write_output("-", options_.pick->json ? text_of(pick_json(report)) : printable(pick_text(report)));
    }

    void measure() {
        begin("Measuring…", "measuring");
        const std::string text =
            measured_output(*options_.measure, *shown_, *language_.evaluation().sources,
                            [this](glm::ivec2 pixel, int layers) { return surfaces_at(pixel, layers); });
        language_.progress().say("");
        write_output("-", text);
    }

    template <typename Value>
    [[nodiscard]] Value setting(std::string_view name) const {
        return std::get<Value>(picture_.parameters.at(picture_.parameters.find(name).value()));
    }

    /// That of the thickest place, where none is given.
    void set_full_tone(Renderer& renderer) {
        if (setting<float>("range") > 0) {
            return;
        }
        const double most = most_thickness(renderer, *shown_, PictureRequest(picture_), limit_.token());
        if (most > 0) {
            picture_.parameters.set("range", static_cast<float>(round_up(most)));
        }
    }

    /// The picture without colors, tinted by what was measured.
    base::Image thickness_image(Renderer& renderer, PictureRequest request) {
        if (extent_of(*model_) == Extent::Flat) {
            throw UsageError("--thickness: an outline in the plane has no walls; extrude it first");
        }
        if (!request.reveal.empty()) {
            throw UsageError("--thickness measures what the model hides and what it does not; leave --reveal out");
        }
        request.scheme.face = request.scheme.cut = glm::vec3(1);
        const auto plain = without_colors(*shown_);
        base::Image image = renderer.render(*plain, request, limit_.token());
        const ThicknessMap map = thickness_map(renderer, *model_, *plain, request, *options_.thickness, limit_.token());
        draw_thickness(image, map, picture_.scheme.background);
        if (!options_.quiet) {
            language_.progress().say("");
            say(printable(thin_places_text(*model_, *language_.evaluation().sources, map)));
        }
        return image;
    }

    base::Image plan_image(Renderer& renderer, const PictureRequest& request) {
        return draw_plan(options_.plan, request, box_, [&](const PictureRequest& view) {
            base::Image image = renderer.render(*shown_, view, limit_.token());
            draw_centers(image, view);
            return image;
        });
    }

    void draw() {
        begin("Drawing…", "drawing");
        Stopwatch watch;
        Renderer& renderer = this->renderer();
        const double context_ms = watch.lap();
        if (is_radiograph(picture_)) {
            set_full_tone(renderer);
        }
        const bool lines =
            extent_of(*model_) == Extent::Flat && is_flat_picture(*model_, picture_) && picture_.samples == 1;
        const PictureRequest request(lines ? flat_picture(picture_, false) : picture_);
        if (wants(options_, Format::Exr)) {
            const bool radiograph = is_radiograph(picture_);
            write_outputs(options_, Format::Exr,
                          base::encode_exr(radiograph ? thickness(renderer, *shown_, request, limit_.token())
                                                      : light(renderer, *shown_, request, limit_.token())));
        }
        if (!wants(options_, Format::Png) && !wants(options_, Format::Apng)) {
            language_.progress().say("");
            return;
        }
        if (const std::string ignored = ignored_transparency(picture_); !ignored.empty()) {
            language_.messages().warn(ignored);
        }
        base::Image image = options_.thickness      ? thickness_image(renderer, request)
                            : options_.plan.empty() ? renderer.render(*shown_, request, limit_.token())
                                                    : plan_image(renderer, request);
        if (lines && options_.plan.empty()) {
            draw_flat_lines(image, *builder_.outline(*model_, limit_.token()), picture_.camera,
                            picture_.scheme.edge_2d);
        }
        if (is_radiograph(picture_) && setting<bool>("legend")) {
            const auto colors = setting<int>("colors");
            draw_legend(image, setting<float>("range"),
                        [&](float share) { return npr::radiograph_tone(colors, share); });
        }
        if (options_.plan.empty()) {
            draw_centers(image, picture_);
        }
        if (options_.marks.any()) {
            draw_marks(image);
        }
        if (const std::string& fallback = renderer.statistics().walk.fallback; !fallback.empty()) {
            language_.messages().warn(fmt::format("lists-cpu has drawn instead of the engine meant: {}", fallback));
        }
        (void)watch.lap();
        film_.add(options_, image, picture_.dots_per_inch, limit_.token());
        const std::string png = wants(options_, Format::Png)
                                    ? base::encode_png(image, limit_.token(), picture_.dots_per_inch)
                                    : std::string();
        picture_json_ = to_json(renderer.statistics());
        picture_json_["ms"]["context"] = context_ms;
        picture_json_["ms"]["encode"] = watch.lap();
        const gl::Context* used = renderer.context();
        picture_json_["context"] = used != nullptr ? gl::name(used->kind()) : "none";
        picture_json_["renderer"] = used != nullptr ? used->renderer() : "";
        picture_json_["opengl"] = used != nullptr ? used->version() : "";
        language_.progress().say("");
        write_outputs(options_, Format::Png, png);
    }

    void draw_centers(base::Image& image, const npr::Picture& picture) const {
        if (options_.marks.centers) {
            const csg::Box& box = shown_->geometry.box;
            draw_center_lines(image, center_lines(*shown_), picture,
                              base::View(picture.camera, picture.size, box.lo, box.hi));
        }
    }

    void draw_marks(base::Image& image) {
        const base::View view(picture_.camera, picture_.size, shown_->geometry.box.lo, shown_->geometry.box.hi);
        MarkColors colors;
        const glm::vec3& b = picture_.scheme.background;
        colors.axes = glm::vec3(b.r + b.g + b.b < 1.5F ? 1.0F : 0.0F);
        const auto first = shown_->empty() ? nullptr : renderer().first_layer(*shown_, view);
        draw_view_marks(image, options_.marks, colors, view, shown_->geometry, first ? *first : layers::HostStack{});
    }

    /// What is written beside the outputs.
    void report() {
        language_.write_dependencies();
        if (options_.statistics && !options_.turntable) {  // Which has more to tell when it is through.
            write_output(*options_.statistics, text_of(statistics()));
        }
        if (options_.summary_file) {
            write_output(*options_.summary_file, text_of(summary()));
        }
        if (options_.summary && !options_.quiet) {
            say(printable(text_of(summary())));
        }
    }

    /// `said`: on a terminal; `stage`: what memory was for, where it runs out.
    void begin(const char* said, const char* stage) {
        stage_ = stage;
        language_.progress().say(said);
        language_.hold_memory_limit();
    }

    [[nodiscard]] Json statistics() const {
        Json all = to_json(model_->statistics);
        const Json model_ms = all["ms"];
        all.erase("ms");
        all["width"] = picture_.size.x;
        all["height"] = picture_.size.y;
        all["warnings"] = language_.messages().warnings();
        Json ms = {{"evaluate", language_.evaluate_ms()}};
        ms.update(model_ms);
        if (geometry_.mesh) {
            ms["boolean"] = geometry_.mesh->boolean_ms;
            all["mesh"] = *geometry_.figures();
            all["mesh"]["cached"] = geometry_.mesh_known;
        } else if (geometry_.outline) {
            all["outline"] = *geometry_.figures();
        }
        if (!picture_json_.is_null()) {
            ms.update(*picture_json_.find("ms"));
            all.update(picture_json_);
        }
        all["ms"] = ms;
        return all;
    }

    [[nodiscard]] Json summary() const {
        SummaryFigures figures;
        figures.camera = picture_.camera;
        figures.box = box_;
        figures.cache = builder_.cache_size();
        figures.milliseconds = 1000 * limit_.spent();
        figures.geometry = geometry_.figures();
        figures.parts = parts_json(*model_);
        if (options_.summary_parts.measures) {
            figures.measures = measures_json(*model_, options_.precision, limit_.token());
        }
        return summary_json(options_.summary_parts, figures);
    }

    const char* stage_ = "the evaluation";
    Options options_;
    TimeLimit limit_;
    LanguageRun language_;
    std::shared_ptr<const csg::Tree> tree_;  ///< That is drawn, or written.
    double time_ = 0;                        ///< $t
    Film film_;
    std::optional<Motion> motion_;  ///< Once something of it was to be drawn.
    ModelBuilder builder_;
    std::unique_ptr<gl::Context> context_;
    std::optional<Renderer> renderer_;               ///< Once it was needed.
    std::shared_ptr<const Model> model_, exported_;  ///< Two where the preview shows what the result leaves out.
    Geometry geometry_;                              ///< Once it was needed.
    SectionedModel sectioned_;
    const Model* shown_ = nullptr;  ///< model_, less what sections cut away.
    csg::Box box_;                  ///< Of model_.
    npr::Picture picture_;
    double first_rotation_ = 0, turned_by_ = 0;  ///< Degrees about z: of the camera chosen, and of its first picture.
    Json picture_json_;
};

bool has_display() {
    const auto is_set = [](const char* name) {
        const char* const value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

int open_window(const Options& options) {
    if (!options.changes_from.empty()) {
        throw UsageError("--changes-from is of pictures: write one with -o");
    }
    if (!(options.explain.empty() && options.without.empty() && options.depictions.empty()) || options.thickness) {
        throw UsageError("--explain, --without, --thickness and --depict are of pictures: write one with -o");
    }
    WindowOptions window;
    window.source.path = options.input;
    if (options.input == "-") {
        window.source.text = read_standard_input();
    } else if (!options.input.empty()) {
        (void)read_source(options.input);  // A file that is not there is told before a window opens.
    }
    window.source.definitions = options.definitions;
    window.source.preview = options.preview;
    window.source.hard_warnings = options.hard_warnings;
    window.source.by_error = options.by_error;
    window.source.lazy_union = options.lazy_union;
    window.source.parts = options.parts;
    window.source.sections = options.picture.sections;
    window.camera = {options.camera,   options.projection,
                     options.view_all, options.autocenter,
                     options.margin,   static_cast<double>(options.picture.size.x) / options.picture.size.y};
    window.picture = PictureRequest(picture_of(options.picture, options.picture_texts));  // Told before a window opens.
    window.picture.engine = options.engine.engine;
    window.engine = options.engine;
    window.frames_log = options.frames_log;
    window.settings = settings_file();
    if (run_window(window) == WindowEnd::StillDrawing) {
        std::_Exit(0);  // Nobody waits for that picture any more.
    }
    return 0;
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
    if (!arguments.empty() && arguments[0] == "check") {
        return run_check({arguments.begin() + 1, arguments.end()});
    }
    if (!arguments.empty() && arguments[0] == "move") {
        return run_move({arguments.begin() + 1, arguments.end()});
    }
    if (!arguments.empty() && arguments[0] == "motion") {
        return run_motion({arguments.begin() + 1, arguments.end()});
    }
    CommandLine line = read_command_line(arguments, style_names());
    Options& options = line.options;
    if (line.text || options.information) {
        write_output("-", line.text ? *line.text : information(options.context.value_or(gl::ContextKind::Auto)));
        return 0;
    }
    const bool window = !options.pick && !options.measure && options.outputs.empty() && !options.statistics &&
                        !options.summary && !options.summary_file;
    if (options.input.empty() && !(window && has_display())) {
        throw UsageError("no input file; see csgscope --help");
    }
    if (window) {
        return open_window(options);
    }
    return Run(std::move(options))() ? 0 : 1;
}

}  // namespace

int run(const std::vector<std::string>& arguments) {
    return or_error(arguments, [&] { return run_or_throw(arguments); });
}

}  // namespace ui
