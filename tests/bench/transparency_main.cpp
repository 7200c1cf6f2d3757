// Speed against error of the models of transparency, and of what people would otherwise take:
//   csgscope_transparency [--side N] [--repeat N] [--most TRIANGLES] [--plots FOLDER] [--models FOLDER] [--assembly
//   FILE]
// prints the tables of docs/TRANSPARENCY.md and writes its plots.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <deque>
#include <fstream>
#include <functional>
#include <limits>
#include <map>

#include "gl/error.h"
#include "tests/bench/measure.h"
#include "tests/bench/transparency_methods.h"
#include "tests/bench/transparency_scenes.h"
#include "tests/bench/worst_pixels.h"
#include "tests/npr/analytic.h"
#include "tests/plot/plot.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/picture/sorted_mesh.h"

namespace {

using bench::ClearScene;

struct Row {
    std::string scene, method;
    int depth = 0;
    analytic::Error error;
    double cpu = 0, bytes = 0, gpu = -1;  ///< No time on a GPU: below 0.
    bench::WorstPixel worst{};
};

struct Options {
    int side = 128, repeat = 3;
    const gl::Context* context = nullptr;  ///< Of a graphics card, where there is one.
    std::size_t most = 6000;
    std::string plots, models, assembly;
};

npr::Picture picture_of(const ClearScene& scene, std::string_view model, int side) {
    npr::Picture p;
    p.draw_as(*npr::find_style("shaded"));
    p.scheme = npr::color_schemes().front();
    p.camera = scene.camera;
    p.size = {side, side};
    p.samples = 1;
    p.see_through_as(*npr::find_transparency(model));
    return p;
}

/// Draws a scene by all methods.
class Table {
  public:
    Table(const ClearScene& scene, const Options& options, std::vector<Row>& rows)
        : scene_(scene), options_(options), rows_(rows) {}

    void fill() {
        const npr::Picture exact = picture_of(scene_, "exact", options_.side);
        ours("exact", exact);
        for (const int layers : {2, 4, 8}) {
            npr::Picture p = exact;
            p.layers = layers;
            ours(fmt::format("peeling, {} layers", layers), p);
        }
        for (const char* order : {"triangles", "parts"}) {
            npr::Picture p = picture_of(scene_, "sorted", options_.side);
            p.transparency_parameters.read("order", order);
            ours(fmt::format("sorted, by {}", order), p, 24);
        }
        for (const int samples : {16, 64}) {
            npr::Picture p = picture_of(scene_, "screen-door", options_.side);
            p.transparency_parameters.read("silhouettes", "off");
            p.samples = samples;
            doors(fmt::format("screen doors, {}", samples), p);
        }
        ours("volume", picture_of(scene_, "volume", options_.side));
        mesh_methods(exact);
    }

  private:
    void add(const std::string& method, const npr::Picture& truth, double bytes,
             const std::function<base::Image()>& draw) {
        base::Image image;
        const double cpu = bench::median(options_.repeat, [&] { image = draw(); }).cpu;
        note(method, truth, image, cpu, bytes);
    }

    void note(const std::string& method, const npr::Picture& picture, const base::Image& image, double cpu,
              double bytes) {
        const analytic::Truth& truth = truth_of(picture);
        const analytic::Error error = analytic::error_of(truth, image);
        rows_.push_back({scene_.name, method, scene_.depth, error, cpu, bytes});
        rows_.back().worst = bench::worst_pixel(truth, image, error);
    }

    /// Rays are cast once for each of the two integrals.
    const analytic::Truth& truth_of(const npr::Picture& picture) {
        analytic::Truth& known = picture.transparency == npr::Transparency::Volume ? volume_ : exact_;
        if (known.colors.empty()) {
            known = analytic::truth_of(*scene_.truth, picture);
        }
        return known;
    }

    /// Of a graphics card, where there is one.
    void time_on_gpu(const npr::Picture& p) {
        if (options_.context == nullptr || p.transparency == npr::Transparency::Sorted) {
            return;
        }
        ui::Renderer renderer(*options_.context, {}, ui::Painter::OpenGl);
        const ui::PictureRequest request(p);
        (void)renderer.render(*scene_.model, request);
        std::vector<double> times;
        for (int i = 0; i < options_.repeat; ++i) {
            (void)renderer.render(*scene_.model, request);
            times.push_back(renderer.statistics().peel_ms + renderer.statistics().style_ms);
        }
        std::sort(times.begin(), times.end());
        rows_.back().gpu = times[times.size() / 2];
    }

    /// `bytes` a pixel; 0: those of the layers, and 16 for the sum.
    void ours(const std::string& method, const npr::Picture& p, double bytes = 0) {
        ui::Renderer renderer({}, ui::Painter::Cpu);
        const ui::PictureRequest request(p);
        npr::Picture truth = p;
        if (p.transparency != npr::Transparency::Volume) {
            truth.transparency = npr::Transparency::Exact;
        }
        add(method, truth, bytes, [&] { return renderer.render(*scene_.model, request); });
        if (bytes == 0) {
            rows_.back().bytes = 12.0 * renderer.statistics().walk.layers + 16;
        }
        time_on_gpu(p);
    }

    /// Samples are averaged in linear light, while `exact` blends sRGB: the error is that of samples averaged as sRGB.
    void doors(const std::string& method, const npr::Picture& p) {
        ui::Renderer renderer({}, ui::Painter::Cpu);
        const ui::PictureRequest request(p);
        npr::Picture truth = p;
        truth.transparency = npr::Transparency::Exact;
        const double cpu = bench::median(options_.repeat, [&] { (void)renderer.render(*scene_.model, request); }).cpu;
        const auto pixels = static_cast<std::size_t>(p.size.x * p.size.y);
        std::vector<glm::vec4> sum(pixels, glm::vec4(0));
        std::vector<glm::vec3> mean(pixels, glm::vec3(0));
        for (int sample = 0; sample < p.samples; ++sample) {
            renderer.draw_sample(*scene_.model, request, sample);
            const std::vector<glm::vec4> light = renderer.light();
            for (std::size_t i = 0; i < pixels; ++i) {
                const glm::vec4 now = light[i] * static_cast<float>(sample + 1);
                for (int c = 0; c < 3; ++c) {
                    const float linear = std::max(now[c] - sum[i][c], 0.0F);
                    mean[i][c] += linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
                }
                sum[i] = now;
            }
        }
        base::Image image{p.size.x, p.size.y, std::vector<std::uint8_t>(4 * pixels, 255)};
        for (int y = 0; y < p.size.y; ++y) {
            for (int x = 0; x < p.size.x; ++x) {
                const auto from = static_cast<std::size_t>((p.size.y - 1 - y) * p.size.x + x),
                           to = static_cast<std::size_t>(y * p.size.x + x);
                for (int c = 0; c < 3; ++c) {
                    const float share = std::clamp(mean[from][c] / static_cast<float>(p.samples), 0.0F, 1.0F);
                    image.rgba[4 * to + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(share * 255 + 0.5F);
                }
            }
        }
        note(method, truth, image, cpu, 12.0 * renderer.statistics().walk.layers + 16);
        time_on_gpu(p);
    }

    void mesh_methods(const npr::Picture& exact) {
        const npr::ColoredMesh mesh = ui::colored_mesh(*scene_.model, exact.scheme);
        const base::View view = scene_.truth->view(exact.camera, exact.size);
        add("weighted blended", exact, 36,
            [&] { return bench::weighted_blended(bench::shade(mesh, view), exact, view); });
        for (const int samples : {4, 16, 64}) {
            add(fmt::format("stochastic, {}", samples), exact, 20.0 * samples,
                [&] { return bench::stochastic(bench::shade(mesh, view), exact, view, samples); });
        }
    }

    const ClearScene& scene_;
    const Options& options_;
    std::vector<Row>& rows_;
    analytic::Truth exact_, volume_;
};

/// RMS and maximum in bytes, time, memory; a row for each method.
void print_scene(const std::vector<Row>& rows, const std::string& scene, const Options& options) {
    const bool gpu = options.context != nullptr;
    fmt::print("\n**{}**\n\n| | RMS | maximum | CPU ms | bytes a pixel |{}\n| --- | --- | --- | --- | --- |{}\n", scene,
               gpu ? " GPU ms |" : "", gpu ? " --- |" : "");
    std::vector<bench::WorstPixel> worst;
    for (const Row& r : rows) {
        if (r.scene == scene) {
            fmt::print("| {} | {:.2f} | {:.0f} | {:.2f} | {:.0f} |", r.method, r.error.rms, r.error.most, r.cpu,
                       r.bytes);
            fmt::print("{}\n", !gpu ? "" : r.gpu < 0 ? " |" : fmt::format(" {:.2f} |", r.gpu));
            worst.push_back(r.worst);
        }
    }
    if (!options.plots.empty()) {
        std::ofstream(fmt::format("{}/worst_{}.png", options.plots, scene), std::ios::binary)
            << base::encode_png(bench::sheet_of(worst));
    }
}

/// A context that a graphics card computes; null where there is none.
std::unique_ptr<gl::Context> graphics_card() {
    try {
        auto context = gl::create_context(gl::ContextKind::Auto);
        return context->software() ? nullptr : std::move(context);
    } catch (const gl::Error&) {
        return nullptr;
    }
}

/// The scene `slabs` by depth: one column for each.
void print_depths(const std::vector<Row>& rows, const std::vector<int>& depths) {
    std::vector<std::string> methods;
    std::map<std::pair<std::string, int>, const Row*> by;
    for (const Row& r : rows) {
        if (r.scene == "slabs") {
            if (by.emplace(std::pair(r.method, r.depth), &r).second && r.depth == depths.front()) {
                methods.push_back(r.method);
            }
        }
    }
    fmt::print("| RMS (CPU ms) |");
    for (const int depth : depths) {
        fmt::print(" {} |", depth);
    }
    fmt::print("\n| --- |");
    for (std::size_t i = 0; i < depths.size(); ++i) {
        fmt::print(" --- |");
    }
    for (const std::string& method : methods) {
        fmt::print("\n| {} |", method);
        for (const int depth : depths) {
            const Row& r = *by.at({method, depth});
            fmt::print(" {:.2f} ({:.1f}) |", r.error.rms, r.cpu);
        }
    }
    fmt::print("\n");
}

/// Geometric mean of times, mean of errors, the worst pixel, over models of glass.
void print_gallery(const std::vector<Row>& rows, const std::vector<std::string>& models) {
    fmt::print("\n**{} models of the gallery, of glass**\n\n| | RMS | maximum | CPU ms |\n| --- | --- | --- | --- |\n",
               models.size());
    std::vector<std::string> methods;
    for (const Row& r : rows) {
        if (!models.empty() && r.scene == models.front()) {
            methods.push_back(r.method);
        }
    }
    for (const std::string& method : methods) {
        double rms = 0, most = 0, logarithm = 0;
        for (const Row& r : rows) {
            if (r.method == method && std::find(models.begin(), models.end(), r.scene) != models.end()) {
                rms += r.error.rms;
                most = std::max(most, r.error.most);
                logarithm += std::log(std::max(r.cpu, 1e-3));
            }
        }
        const auto count = static_cast<double>(models.size());
        fmt::print("| {} | {:.2f} | {:.0f} | {:.2f} |\n", method, rms / count, most, std::exp(logarithm / count));
    }
}

void write_plots(const std::vector<Row>& rows, const std::string& folder) {
    plot::Plot error{"slabs: error", {"surfaces behind a pixel", true, false}, {"RMS, of 255", true, false}, {}},
        time{"slabs: CPU ms", {"surfaces behind a pixel", true, false}, {"CPU ms", true, false}, {}},
        both{"nested balls: speed against error", {"CPU ms", true, false}, {"RMS, of 255", true, false}, {}, false};
    for (plot::Plot* each : {&error, &time, &both}) {
        each->width = 520;
        each->height = 340;
    }
    for (const Row& r : rows) {
        if (r.method == "peeling, 2 layers" || r.method == "sorted, by parts" || r.method == "stochastic, 4") {
            continue;  // So that each of the others has a color of its own.
        }
        const auto add = [&](plot::Plot& to, double x, double y) {
            auto found =
                std::find_if(to.series.begin(), to.series.end(), [&](const auto& s) { return s.name == r.method; });
            if (found == to.series.end()) {
                to.series.push_back({r.method, {}});
                found = to.series.end() - 1;
            }
            found->points.emplace_back(x, y);
        };
        if (r.scene == "slabs") {
            add(error, r.depth, std::max(r.error.rms, 0.1));
            add(time, r.depth, r.cpu);
        } else if (r.scene == "nested") {
            add(both, r.cpu, std::max(r.error.rms, 0.1));
        }
    }
    for (const auto& [name, each] : {std::pair("slabs_error", &error), {"slabs_time", &time}, {"nested", &both}}) {
        std::ofstream(fmt::format("{}/{}.svg", folder, name)) << plot::to_svg(*each);
    }
}

/// Milliseconds of making a model's mesh; below 0 where there is none.
double mesh_ms(const ui::Model& model, const npr::ColorScheme& scheme) {
    try {
        const bench::Time begin = bench::now();
        (void)ui::colored_mesh(model, scheme);
        return (bench::now() - begin).cpu;
    } catch (const ui::ModelError&) {
        return -1;
    }
}

/// What `exact` costs beside opaque pictures of all layers, and beside triangles that are sorted and drawn.
void print_goals(const Options& options) {
    fmt::print(
        "\n| the gallery, of glass | triangles | `exact` ms | of opaque `shaded`, all layers | of `sorted` | of it "
        "with "
        "its mesh |\n| --- | --- | --- | --- | --- | --- |\n");
    int models = 0, cheap = 0, quicker = 0, quicker_with_mesh = 0;
    for (const std::filesystem::path& file : bench::gallery(options.models)) {
        const auto scene = bench::of_glass(file, std::numeric_limits<std::size_t>::max());
        if (!scene) {
            continue;
        }
        const bench::Subject plain = bench::from_file(file.string());
        const int side = 2 * options.side;
        const npr::Picture exact = picture_of(*scene, "exact", side), sorted = picture_of(*scene, "sorted", side);
        npr::Picture opaque = exact;
        opaque.layers = npr::kAllLayersWanted;
        const double mesh = mesh_ms(*scene->model, exact.scheme);
        std::deque<ui::Renderer> renderers;
        std::vector<std::function<void()>> works;
        for (int i = 0; i < 3; ++i) {
            renderers.emplace_back(goldfeather::EngineOptions{}, ui::Painter::Cpu);
        }
        works.emplace_back([&] { (void)renderers[0].render(*scene->model, ui::PictureRequest(exact)); });
        works.emplace_back([&] { (void)renderers[1].render(*plain.model, ui::PictureRequest(opaque)); });
        if (mesh >= 0) {
            works.emplace_back([&] { (void)renderers[2].render(*scene->model, ui::PictureRequest(sorted)); });
        }
        const std::vector<bench::Time> times = bench::interleaved(options.repeat, works);
        const double ours = times[0].cpu;
        fmt::print("| {} | {} | {:.2f} | {:.2f} |", scene->name, scene->model->statistics.triangles, ours,
                   ours / times[1].cpu);
        ++models;
        cheap += ours <= 1.3 * times[1].cpu ? 1 : 0;
        if (mesh >= 0) {
            quicker += ours <= times[2].cpu ? 1 : 0;
            quicker_with_mesh += ours <= times[2].cpu + mesh ? 1 : 0;
            fmt::print(" {:.2f} | {:.3f} |\n", ours / times[2].cpu, ours / (times[2].cpu + mesh));
        } else {
            fmt::print(" no mesh | no mesh |\n");
        }
    }
    fmt::print(
        "\nOf {} models: at most 1.3 of opaque pictures {}; not slower than sorted triangles {}, and {} where their "
        "mesh counts.\n",
        models, cheap, quicker, quicker_with_mesh);
}

double picture_ms(const ClearScene& scene, npr::Picture p, int repeat) {
    ui::Renderer renderer({}, ui::Painter::Cpu);
    const ui::PictureRequest request(std::move(p));
    return bench::median(repeat, [&] { (void)renderer.render(*scene.model, request); }).cpu;
}

/// Their frames a second, as milliseconds, beside our CPU milliseconds.
void print_papers(const Options& options) {
    const std::map<int, std::pair<int, int>> theirs{{2, {90, 51}},  {4, {49, 27}}, {6, {32, 18}}, {8, {23, 13}},
                                                    {10, {18, 10}}, {12, {14, 8}}, {14, {12, 6}}, {16, {10, 5}}};
    fmt::print(
        "\n| layers: ms | 800 × 600: theirs | `volume` | `exact` | 1024 × 768: theirs | `volume` | `exact` |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n");
    for (const auto& [layers, fps] : theirs) {
        const ClearScene scene = bench::slabs(layers);
        fmt::print("| {} |", layers);
        for (const auto& [size, their_fps] :
             {std::pair(glm::ivec2(800, 600), fps.first), {glm::ivec2(1024, 768), fps.second}}) {
            fmt::print(" {:.0f} |", 1000.0 / their_fps);
            for (const char* model : {"volume", "exact"}) {
                npr::Picture p = picture_of(scene, model, 8);
                p.size = size;
                fmt::print(" {:.0f} |", picture_ms(scene, p, options.repeat));
            }
        }
        fmt::print("\n");
    }
    const ClearScene crank = bench::crank();
    fmt::print("\n| {} triangles, 512 × 512: ms | theirs | ours |\n| --- | --- | --- |\n",
               crank.model->statistics.triangles);
    for (const auto& [until, fps] : {std::pair("back-face", 21.4), {"front-face", 9.0}}) {
        npr::Picture p = picture_of(crank, "view-dependent", 512);
        p.transparency_parameters.read("until", until);
        fmt::print("| method {} | {:.0f} | {:.0f} |\n", until == std::string("back-face") ? "I" : "II", 1000 / fps,
                   picture_ms(crank, p, options.repeat));
    }
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app;
    app.add_option("--side", options.side, "Of pictures, in pixels");
    app.add_option("--repeat", options.repeat, "Times that each is drawn; the median is taken");
    app.add_option("--most", options.most, "Triangles of the gallery's models that are taken");
    app.add_option("--plots", options.plots, "Folder for plots");
    app.add_option("--models", options.models, "The gallery");
    app.add_option("--assembly", options.assembly,
                   "A program whose colors are parts of glass, such as one of NopSCADlib");
    bool quick = false, goals = false;
    bool papers = false;
    app.add_flag("--papers", papers, "The papers' tables and nothing else");
    app.add_flag("--goals", goals, "What exact costs on the gallery's models, and nothing else");
    app.add_flag("--quick", quick, "Two depths and no papers' tables");
    CLI11_PARSE(app, argc, argv);
    if (papers) {
        print_papers(options);
        return 0;
    }
    if (goals) {
        print_goals(options);
        return 0;
    }
    const std::unique_ptr<gl::Context> card = graphics_card();
    options.context = card.get();
    std::vector<Row> rows;
    const std::vector<int> depths = quick ? std::vector{2, 8} : std::vector{2, 4, 8, 16, 32, 64};
    for (const int depth : depths) {
        const ClearScene scene = bench::slabs(depth);
        Table(scene, options, rows).fill();
    }
    print_depths(rows, depths);
    for (const ClearScene& scene : {bench::crossing(), bench::nested(), bench::inside()}) {
        Table(scene, options, rows).fill();
        print_scene(rows, scene.name, options);
    }
    if (!options.assembly.empty()) {
        const auto scene = bench::of_glass(options.assembly, std::numeric_limits<std::size_t>::max(), true);
        Table(*scene, options, rows).fill();
        fmt::print("\n{} triangles, {} parts", scene->model->statistics.triangles, scene->model->scene.parts.size());
        print_scene(rows, scene->name, options);
    }
    if (!options.models.empty()) {
        std::vector<std::string> taken;
        for (const std::filesystem::path& file : bench::gallery(options.models)) {
            try {
                if (const auto scene = bench::of_glass(file, options.most)) {
                    std::vector<Row> own;
                    Table(*scene, options, own).fill();
                    rows.insert(rows.end(), own.begin(), own.end());
                    taken.push_back(scene->name);
                }
            } catch (const std::exception& error) {
                fmt::print(stderr, "{}: {}\n", file.string(), error.what());
            }
        }
        print_gallery(rows, taken);
        print_goals(options);
    }
    if (!quick) {
        print_papers(options);
    }
    if (!options.plots.empty()) {
        write_plots(rows, options.plots);
    }
    return 0;
}
