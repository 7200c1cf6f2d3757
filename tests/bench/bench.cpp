// Measures frames of the gallery by stage, beside the floor. See tools/benchmark and docs/PERFORMANCE.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "csg/scad/scad.h"
#include "goldfeather/choice.h"
#include "tests/bench/floor.h"
#include "tests/bench/report.h"
#include "ui/pipeline/camera.h"
#include "ui/pipeline/heap.h"
#include "ui/pipeline/renderer.h"
#include "ui/pipeline/stopwatch.h"

namespace bench {
namespace {

struct Settings {
    std::string models = "models", json, markdown, context = "auto";
    std::vector<std::string> only;
    std::vector<int> sizes{512, 1024}, layers{1, 4, 0};
    int repeat = 5;
};

/// Names of the gallery's models, in the manifest's order.
std::vector<std::string> model_names(const Settings& settings) {
    if (!settings.only.empty()) {
        return settings.only;
    }
    std::ifstream file(std::filesystem::path(settings.models) / "manifest.json");
    std::vector<std::string> names;
    const auto manifest = nlohmann::json::parse(file);
    for (const auto& model : manifest.at("models")) {
        names.push_back(std::filesystem::path(model.at("file").get<std::string>()).stem().string());
    }
    return names;
}

class Bench {
  public:
    Bench(const Settings& settings, const gl::Context& context)
        : settings_(settings),
          software_(context.software()),
          gl_(context.functions()),
          renderer_(context),
          peeler_(gl_) {
        report_.renderer = context.renderer();
        report_.opengl = context.version();
        report_.repeat = settings.repeat;
    }

    void run(const std::string& name) {
        ui::Stopwatch watch;
        csg::scad::Request request;
        request.path = (std::filesystem::path(settings_.models) / (name + ".scad")).string();
        const csg::scad::Evaluation evaluation =
            csg::scad::evaluate(request, [](const csg::scad::Message& message, const csg::scad::SourceSet& sources) {
                std::cerr << csg::scad::render(message, sources);
            });
        if (!evaluation.ok) {
            throw std::runtime_error(request.path + " does not evaluate");
        }
        Preparation preparation{name, watch.lap(), 0, 0, 0};
        const auto model = ui::ModelBuilder().build(evaluation.tree);
        preparation.place = model->statistics.place_ms;
        preparation.normalize = model->statistics.normalize_ms;
        const gl::Camera camera = ui::choose_camera({}, evaluation.view, model->box);
        (void)watch.lap();
        const auto choice = goldfeather::choose_engine({}, {software_, !model->over_budget.empty()});
        peel::PeelModel peel_model(gl_, model->scene, model->geometry, model->products, choice.engine);
        gl_.Finish();
        preparation.upload = watch.lap();
        report_.preparations.push_back(preparation);
        for (const int size : settings_.sizes) {
            for (const int layers : settings_.layers) {
                report_.rows.push_back(measure(name, *model, peel_model, camera, size, layers));
            }
        }
    }

    [[nodiscard]] const Report& report() const { return report_; }

  private:
    Row measure(const std::string& name, const ui::Model& model, peel::PeelModel& peel_model, const gl::Camera& camera,
                int size, int layers) {
        Row row{name,
                size,
                layers,
                model.statistics.leaves,
                model.statistics.products,
                model.statistics.triangles,
                0,
                0,
                layers == 1 ? "shaded" : "blueprint",
                {},
                {},
                {}};
        const gl::View view(camera, glm::ivec2(size), model.geometry.box.lo, model.geometry.box.hi);
        Floor floor(gl_, model.geometry, glm::ivec2(size));
        row.floor = median(4 * settings_.repeat, [&] { floor.draw(view); });
        peel::WalkStats stats;
        row.peel = median(settings_.repeat, [&] {
            stats = {};
            peeler_.give_back(peeler_.peel(view, peel_model, layers, stats));
            gl_.Finish();
        });
        row.passes = stats.passes;
        row.found_layers = stats.layers;
        ui::PictureRequest request;
        request.camera = camera;
        request.size = glm::ivec2(size);
        request.style = row.style;
        request.layers = layers;
        request.samples = 1;
        row.frame = median(settings_.repeat, [&] { (void)renderer_.render(model, request); });
        std::cerr << fmt::format("{} {}² layers {}: floor {:.1f}, peel {:.1f}, frame {:.1f} CPU ms\n", name, size,
                                 layers, row.floor.cpu, row.peel.cpu, row.frame.cpu);
        return row;
    }

    const Settings& settings_;
    bool software_;
    const gl::Functions& gl_;
    ui::Renderer renderer_;
    peel::Peeler peeler_;
    Report report_;
};

void write(const std::string& path, const std::string& text) {
    if (path == "-") {
        std::cout << text << '\n';
    } else if (!path.empty()) {
        gl::write_file(path, text);
    }
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
    ui::keep_freed_memory();
    bench::Settings settings;
    CLI::App app("Milliseconds per frame by stage, beside one plain z-buffer draw of all leaves (the floor).");
    app.add_option("--models", settings.models, "Folder with manifest.json")->capture_default_str();
    app.add_option("--only", settings.only, "Names of models instead of all")->delimiter(',');
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
        bench::write(settings.json, to_json(bench.report()).dump(2));
        bench::write(settings.markdown, to_markdown(bench.report()));
    } catch (const std::exception& error) {
        std::cerr << "csgscope_bench: error: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
