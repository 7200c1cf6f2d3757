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
#include "ui/command_line/call_place.h"
#include "ui/command_line/check.h"
#include "ui/command_line/compare.h"
#include "ui/command_line/depicting.h"
#include "ui/command_line/export.h"
#include "ui/command_line/files.h"
#include "ui/command_line/film.h"
#include "ui/command_line/film_frames.h"
#include "ui/command_line/language_run.h"
#include "ui/command_line/measure.h"
#include "ui/command_line/medium_options.h"
#include "ui/command_line/motion.h"
#include "ui/command_line/move.h"
#include "ui/command_line/options.h"
#include "ui/command_line/part_style_options.h"
#include "ui/command_line/pick.h"
#include "ui/command_line/picture_maker.h"
#include "ui/command_line/run_checks.h"
#include "ui/command_line/standard_streams.h"
#include "ui/command_line/summary.h"
#include "ui/command_line/time_limit.h"
#include "ui/command_line/window_run.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/mesh/outline.h"
#include "ui/pipeline/motion/key_times.h"
#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/picture/exact_bounds.h"
#include "ui/pipeline/picture/radiograph.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/picture/storyboard.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/sections.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

namespace {

/// One run: the source, what became of it, and the figures.
class Run {
  public:
    explicit Run(Options options)
        : options_(std::move(options)),
          limit_(options_.time_limit),
          language_(options_, limit_, make_measures()),

          frames_(options_),
          depicting_(options_, limit_, language_),
          pictures_(options_, limit_, language_, builder_, depicting_) {}

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
        depicting_.read();
        language_.read();
        if (options_.storyboard != 0) {
            return storyboard();
        }
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
        if (!make_tree()) {
            return false;
        }
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

    /// What is to be drawn of what the program made; false where an error ended that.
    bool make_tree() {
        tree_ = language_.evaluation().tree;
        if (!options_.changes_from.empty()) {
            const auto before = language_.evaluate_other(options_.changes_from);
            if (before == nullptr) {
                return false;
            }
            tree_ = std::make_shared<const csg::Tree>(csg::changes(*before, *tree_));
        }
        explain();
        if (depicting_.depicts()) {
            stage_ = "looking for what moves";
        }
        tree_ = depicting_.depicted(tree_, time_);
        return true;
    }

    /// One picture of several times, from one place.
    bool storyboard() {
        language_.messages().each_once();
        set_time(0);
        if (!language_() || language_.evaluation().tree == nullptr) {
            return false;
        }
        struct Panel {
            std::shared_ptr<const Model> model;
            Annotations annotations;
            std::vector<GlyphStyle> styles;
            csg::scad::ViewSettings view;
        };
        std::vector<Panel> panels;
        std::vector<std::string> captions;
        csg::Box box;
        const std::vector<double> times = key_times(depicting_.motion(), options_.storyboard);
        for (std::size_t i = 0; i < times.size(); ++i) {
            set_time(times[i]);
            if (!language_() || !make_tree()) {
                return false;
            }
            build();
            panels.push_back({model_, depicting_.annotations(), depicting_.styles(), language_.evaluation().view});
            box = csg::enclose(box, box_.empty() ? model_->box : box_);
            const double end = i + 1 < times.size() ? times[i + 1] : depicting_.motion().times.back();
            const std::string moves = what_moves(depicting_.motion(), times[i], end);
            captions.push_back(fmt::format("{}   $t = {:.3g}{}{}", i + 1, times[i], moves.empty() ? "" : ":  ", moves));
        }
        const glm::ivec2 size = picture_.size;
        const SheetLayout layout = sheet_layout(size, options_.storyboard);
        picture_.size = layout.panel;
        CameraRequest request = camera_request();
        request.aspect = static_cast<double>(layout.panel.x) / layout.panel.y;
        const base::Image sheet = draw_sheet(size, layout, captions, picture_.scheme, [&](std::size_t i) {
            model_ = exported_ = panels[i].model;
            depicting_.set(panels[i].annotations, panels[i].styles);
            picture_.camera = choose_camera(request, panels[i].view, box);
            cut();
            begin("Drawing…", "drawing");
            return pictures_.image(subject(), picture_, renderer());
        });
        language_.progress().say("");
        write_outputs(options_, Format::Png, base::encode_png(sheet, limit_.token(), picture_.dots_per_inch));
        picture_json_ = to_json(renderer().statistics());
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

    [[nodiscard]] bool wants_picture() const {
        return wants(options_, Format::Exr) ||
               std::any_of(options_.outputs.begin(), options_.outputs.end(),
                           [](const Output& output) { return is_picture(output.format); });
    }

    void build() {
        begin("Building the model…", "building the model");
        builder_.show(options_.preview ? csg::Showing::Preview : csg::Showing::Result);
        builder_.divide(options_.parts);
        builder_.cut(picture_.sections);
        const auto build_it = [&] { return builder_.build(tree_, limit_.token(), language_.evaluation().program); };
        model_ = exported_ = frames_.follow(tree_, picture_.sections, renderer_ ? &*renderer_ : nullptr);
        if (model_ == nullptr) {
            model_ = exported_ = build_it();
            frames_.built(model_, tree_);
        }
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
        const CameraRequest request = camera_request();
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

    [[nodiscard]] CameraRequest camera_request() const {
        return {options_.camera,   options_.projection,
                options_.view_all, options_.autocenter,
                options_.margin,   static_cast<double>(options_.picture.size.x) / options_.picture.size.y};
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

    [[nodiscard]] PictureSubject subject() const { return {*model_, *shown_, box_}; }

    void draw() {
        begin("Drawing…", "drawing");
        Stopwatch watch;
        Renderer& renderer = this->renderer();
        const double context_ms = watch.lap();
        if (wants(options_, Format::Exr)) {
            pictures_.set_full_tone(subject(), picture_, renderer);
            const PictureRequest request = PictureMaker::request_of(subject(), picture_);
            write_outputs(
                options_, Format::Exr,
                base::encode_exr(is_radiograph(picture_) ? thickness(renderer, *shown_, request, limit_.token())
                                                         : light(renderer, *shown_, request, limit_.token())));
        }
        if (std::none_of(options_.outputs.begin(), options_.outputs.end(),
                         [](const Output& output) { return is_picture(output.format); })) {
            language_.progress().say("");
            return;
        }
        if (const std::string ignored = ignored_transparency(picture_); !ignored.empty()) {
            language_.messages().warn(ignored);
        }
        const base::Image* image = depicting_.annotations().any() ? nullptr : frames_.same_image(picture_);
        if (image == nullptr) {
            base::Image made = pictures_.image(subject(), picture_, renderer);
            image = &frames_.drew(std::move(made), picture_);
            png_.clear();
        }
        (void)watch.lap();
        film_.add(options_, *image, picture_.dots_per_inch, limit_.token());
        if (wants(options_, Format::Png) && png_.empty()) {
            png_ = base::encode_png(*image, limit_.token(), picture_.dots_per_inch);
        }
        picture_json_ = to_json(renderer.statistics());
        picture_json_["ms"]["context"] = context_ms;
        picture_json_["ms"]["encode"] = watch.lap();
        const gl::Context* used = renderer.context();
        picture_json_["context"] = used != nullptr ? gl::name(used->kind()) : "none";
        picture_json_["renderer"] = used != nullptr ? used->renderer() : "";
        picture_json_["opengl"] = used != nullptr ? used->version() : "";
        language_.progress().say("");
        write_outputs(options_, Format::Png, png_);
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
        if (options_.frames != 0) {
            all["film"] = frames_.figures();
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
    FilmFrames frames_;
    std::string png_;  ///< The last picture as a file, where one was wanted.
    Depicting depicting_;
    ModelBuilder builder_;
    PictureMaker pictures_;
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
