// Measures frames of the gallery by stage, beside the floor. See tools/benchmark and docs/PERFORMANCE.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <functional>
#include <iostream>
#include <utility>

#include "goldfeather/engine_set.h"
#include "goldfeather/surface_table.h"
#include "layers/upload.h"
#include "tests/bench/floor.h"
#include "tests/bench/report.h"
#include "tests/bench/subject.h"
#include "tests/support/output.h"
#include "ui/pipeline/heap.h"
#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/stopwatch.h"

namespace bench {
namespace {

constexpr std::array kEngines{"lists-cpu", "lists", "goldfeather"};

struct Settings {
    std::string models = "models", engine, json, markdown, context = "auto";
    std::vector<std::string> only;
    std::vector<int> sizes{512, 1024}, layers{1, 4, 0};
    int repeat = 5;
};

/// Names of the gallery's models, in the manifest's order.
std::vector<std::string> model_names(const Settings& settings) {
    if (!settings.only.empty()) {
        return settings.only;
    }
    std::vector<std::string> names;
    for (const std::filesystem::path& file : gallery(settings.models)) {
        names.push_back(file.stem().string());
    }
    return names;
}

/// A model made ready for an engine.
struct Prepared {
    const goldfeather::EngineInfo& engine;
    std::unique_ptr<goldfeather::PreparedScene> scene;
};

class Bench {
  public:
    Bench(const Settings& settings, const gl::Context& context)
        : settings_(settings), context_(context), gl_(context.functions()), engines_({&gl_}), upload_(gl_) {
        report_.renderer = context.renderer();
        report_.opengl = context.version();
        report_.repeat = settings.repeat;
    }

    void run(const std::string& name) {
        ui::Stopwatch watch;
        const auto evaluation = evaluate((std::filesystem::path(settings_.models) / (name + ".scad")).string());
        Preparation preparation{name, watch.lap(), 0, 0, 0};
        const auto model = ui::ModelBuilder().build(evaluation.tree);
        preparation.place = model->statistics.place_ms;
        preparation.normalize = model->statistics.normalize_ms;
        const base::Camera camera = ui::choose_camera({}, evaluation.view, model->box);
        bool first = true;
        for (const char* const name_of_engine : kEngines) {
            if (!settings_.engine.empty() && settings_.engine != name_of_engine) {
                continue;
            }
            (void)watch.lap();
            const goldfeather::EngineInfo& engine = *goldfeather::find_engine(name_of_engine);
            const layers::SurfaceBuffers table(gl_, *goldfeather::surface_table(model->scene, model->geometry));
            const Prepared prepared{engine, engines_.prepare({model->scene, model->geometry, model->products}, engine)};
            gl_.Finish();
            if (std::exchange(first, false)) {
                preparation.upload = watch.lap();
                report_.preparations.push_back(preparation);
            }
            ui::Renderer renderer(context_, &engine);
            for (const int size : settings_.sizes) {
                measure(name, *model, prepared, renderer, camera, size);
            }
        }
    }

    [[nodiscard]] const Report& report() const { return report_; }

  private:
    /// Floor, engine and frame for all numbers of layers, in turn: their ratios are what counts.
    void measure(const std::string& name, const ui::Model& model, const Prepared& prepared, ui::Renderer& renderer,
                 const base::Camera& camera, int size) {
        const base::View view(camera, glm::ivec2(size), model.geometry.box.lo, model.geometry.box.hi);
        Floor floor(gl_, model.geometry, glm::ivec2(size));
        const std::size_t count = settings_.layers.size();
        std::vector<goldfeather::WalkStats> stats(count);
        std::vector<std::function<void()>> works{[&] { floor.draw(view); }};
        for (std::size_t i = 0; i < count; ++i) {
            works.emplace_back([&, i] { peel(prepared, view, settings_.layers[i], stats[i]); });
        }
        for (const int layers : settings_.layers) {
            works.emplace_back([&, layers] {
                ui::PictureRequest request;
                request.camera = camera;
                request.size = glm::ivec2(size);
                request.draw_as(*npr::find_style(style(layers)));
                request.layers = layers;
                request.samples = 1;
                (void)renderer.render(model, request);
            });
        }
        const std::vector<Time> times = interleaved(settings_.repeat, works);
        for (std::size_t i = 0; i < count; ++i) {
            Row row;
            row.model = name;
            row.engine = prepared.engine.name;
            row.size = size;
            row.layers = settings_.layers[i];
            row.leaves = model.statistics.leaves;
            row.products = model.statistics.products;
            row.triangles = model.statistics.triangles;
            row.style = style(row.layers);
            row.passes = stats[i].passes;
            row.found_layers = stats[i].layers;
            row.floor = times[0];
            row.peel = times[1 + i];
            row.frame = times[1 + count + i];
            std::cerr << fmt::format("{} {} {}² layers {}: floor {:.1f}, peel {:.1f}, frame {:.1f} CPU ms\n", name,
                                     row.engine, size, row.layers, row.floor.cpu, row.peel.cpu, row.frame.cpu);
            report_.rows.push_back(std::move(row));
        }
    }

    static const char* style(int layers) { return layers == 1 ? "shaded" : "blueprint"; }

    /// On software OpenGL lists of the CPU end in main memory, as in frames that the CPU paints.
    void peel(const Prepared& prepared, const base::View& view, int layers, goldfeather::WalkStats& stats) {
        stats = {};
        const layers::Stack stack = prepared.scene->draw(view, layers, stats);
        if (prepared.engine.capabilities.needs_opengl || !context_.software()) {
            (void)upload_.textures(stack);
            gl_.Finish();
        }
    }

    const Settings& settings_;
    const gl::Context& context_;
    const gl::Functions& gl_;
    goldfeather::EngineSet engines_;
    layers::Upload upload_;
    Report report_;
};

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
    ui::keep_freed_memory();
    bench::Settings settings;
    CLI::App app("Milliseconds per frame by stage, beside one plain z-buffer draw of all leaves (the floor).");
    app.add_option("--models", settings.models, "Folder with manifest.json")->capture_default_str();
    app.add_option("--only", settings.only, "Names of models instead of all")->delimiter(',');
    app.add_option("--engine", settings.engine, "Only this engine");
    app.add_option("--sizes", settings.sizes, "Sides of the picture in pixels")->delimiter(',')->capture_default_str();
    app.add_option("--layers", settings.layers, "Layers; 0 stands for all")->delimiter(',')->capture_default_str();
    app.add_option("--repeat", settings.repeat, "Frames per figure")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--context", settings.context, "auto, egl or osmesa")->capture_default_str();
    app.add_option("--json", settings.json, "Write JSON; - is standard output");
    app.add_option("--markdown", settings.markdown, "Write tables; - is standard output");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto kind = settings.context == "egl"      ? gl::ContextKind::Egl
                          : settings.context == "osmesa" ? gl::ContextKind::Osmesa
                                                         : gl::ContextKind::Auto;
        const auto context = gl::create_context(kind);
        bench::Bench bench(settings, *context);
        for (const std::string& name : bench::model_names(settings)) {
            bench.run(name);
        }
        test_support::write_output(settings.json, to_json(bench.report()).dump(2));
        test_support::write_output(settings.markdown, to_markdown(bench.report()));
    } catch (const std::exception& error) {
        std::cerr << "csgscope_bench: error: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
