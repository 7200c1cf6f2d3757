#include "ui/command_line/compare.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "csg/scad/csg_text.h"
#include "csg/scad/scad.h"
#include "gl/context.h"
#include "goldfeather/lists_cpu.h"
#include "peel/peeler.h"
#include "ui/command_line/compare_openscad.h"
#include "ui/command_line/compare_options.h"
#include "ui/command_line/compare_report.h"
#include "ui/command_line/files.h"
#include "ui/command_line/messages.h"
#include "ui/command_line/options.h"
#include "ui/pipeline/camera.h"
#include "ui/pipeline/errors.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/mesh.h"
#include "ui/pipeline/renderer.h"
#include "ui/pipeline/solid_scene.h"

namespace ui {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Loaded {
    std::shared_ptr<const Model> model;
    csg::scad::ViewSettings view;
};

/// `preview`: $preview, which is true for pictures and trees, and false for meshes.
csg::scad::Evaluation evaluate(const CompareOptions& o, bool preview) {
    csg::scad::Request request;
    request.path = o.input;
    request.text = read_source(o.input);
    request.preview = preview;
    request.measures = make_measures();
    Messages messages(true);
    auto evaluation =
        csg::scad::evaluate(request, [&](const auto& message, const auto& sources) { messages.add(message, sources); });
    if (!evaluation.ok) {
        throw ModelError("the model has errors");
    }
    return evaluation;
}

Loaded load(const CompareOptions& o) {
    const csg::scad::Evaluation evaluation = evaluate(o, !o.reference.empty());
    return {ModelBuilder().build(evaluation.tree), evaluation.view};
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    if (!file || !(bytes << file.rdbuf())) {
        throw UsageError(fmt::format("{}: cannot be read", path));
    }
    return bytes.str();
}

csg::reference::Mesh reference_mesh(const CompareOptions& o, const Model& model) {
    if (o.against == "cgal") {
        return make_mesh(model).mesh;
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

/// The solid with the engine that draws it from all views.
class Drawer {
  public:
    Drawer(const SolidScene& solid, const std::string& engine) : solid_(solid) {
        if (engine == "lists-cpu") {
            return;
        }
        context_ = gl::create_context(gl::ContextKind::Auto);
        std::vector<csg::Box> boxes;
        for (const auto& leaf : solid.geometry.leaves) {
            boxes.push_back(leaf.box);
        }
        goldfeather::NormalizationStats normalization;
        auto normalized = goldfeather::normalize(solid.scene, solid.scene.parts[0], boxes, {}, normalization);
        if (std::holds_alternative<goldfeather::OverBudget>(normalized)) {
            throw ModelError("the model needs more products than the engine goldfeather takes");
        }
        auto* sum = std::get_if<goldfeather::SumOfProducts>(&normalized);
        peeler_.emplace(context_->functions());
        model_.emplace(context_->functions(), solid.scene, solid.geometry,
                       std::vector<std::vector<goldfeather::Product>>{sum ? std::move(sum->products)
                                                                          : std::vector<goldfeather::Product>{}});
    }

    [[nodiscard]] goldfeather::HostLayers layers(const gl::View& view) {
        if (!model_) {
            return goldfeather::peel_to_host(solid_.scene, solid_.geometry, view);
        }
        peel::WalkStats stats;
        return peel::read_back(context_->functions(), peeler_->peel(view, *model_, peel::kAllLayers, stats));
    }

  private:
    const SolidScene& solid_;
    // Only for goldfeather. The context goes last.
    std::unique_ptr<gl::Context> context_;
    std::optional<peel::Peeler> peeler_;
    std::optional<peel::PeelModel> model_;
};

/// Views evenly spread (on a spiral), perspective and orthographic in turn; the first is OpenSCAD's default.
gl::Camera camera_of(int view, int views, const csg::Box& box) {
    gl::Camera camera;
    if (view > 0) {
        const double z = 1 - 2 * (view + 0.5) / views;
        camera.rotation = {std::acos(z) * 57.29577951308232, 0, std::fmod(view * 137.50776405003785, 360.0)};
    }
    camera.projection = view % 2 == 0 ? gl::Projection::Perspective : gl::Projection::Orthographic;
    gl::view_all(camera, box.lo, box.hi, true);
    return camera;
}

gl::Image blank(glm::ivec2 size) {
    gl::Image image{size.x, size.y, {}};
    image.rgba.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4, 255);
    return image;
}

void set(gl::Image& image, int x, int y, const glm::dvec3& color) {
    const std::size_t at = 4 * (static_cast<std::size_t>(image.height - 1 - y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(x));
    for (int c = 0; c < 3; ++c) {
        image.rgba[at + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[c], 0.0, 1.0)));
    }
}

/// The same plain light for both sides, so that what differs is the geometry.
glm::dvec3 shade(const glm::dvec3& normal, const gl::View& view) {
    const double light = std::abs((glm::dmat3(view.eye_from_world()) * normal).z);
    return glm::dvec3(0.95, 0.8, 0.35) * (0.3 + 0.7 * light);
}

/// Grey where all agrees; blue in the band, red outside it, the darker the more layers differ.
glm::dvec3 heat(const Comparison& comparison, std::size_t pixel) {
    if (comparison.wrong[pixel] == 0) {
        return glm::dvec3(0.85);
    }
    const double much = 1 - std::exp2(-static_cast<double>(comparison.wrong_layers[pixel]));
    return glm::mix(glm::dvec3(0.85), comparison.wrong[pixel] == 1 ? glm::dvec3(0.0, 0.2, 0.8) : glm::dvec3(0.8, 0, 0),
                    0.3 + 0.7 * much);
}

ComparedView compared_view(const SolidScene& solid, const csg::reference::Mesh& mesh, const gl::View& view,
                           const goldfeather::HostLayers& stack, const MeshLayers& truth,
                           const Comparison& comparison) {
    ComparedView result{{},
                        blank(view.size()),
                        blank(view.size()),
                        blank(view.size()),
                        to_json(comparison.all),
                        to_json(comparison.outside)};
    for (int y = 0; y < view.size().y; ++y) {
        for (int x = 0; x < view.size().x; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(view.size().x) + static_cast<std::size_t>(x);
            const bool drawn = stack.layers > 0 && stack.at(0, x, y).depth > 0;
            if (drawn) {
                set(result.drawn, x, y, shade(solid.geometry.planes.planes()[stack.at(0, x, y).plane].normal, view));
            }
            if (!truth.of[i].empty()) {
                set(result.expected, x, y, shade(normal_of(mesh, truth.of[i][0].triangle), view));
            }
            if (drawn || !truth.of[i].empty()) {
                set(result.difference, x, y, heat(comparison, i));
            }
        }
    }
    return result;
}

int compare_with_mesh(const CompareOptions& o) {
    const Loaded loaded = load(o);
    const SolidScene solid = solid_scene(loaded.model->scene, loaded.model->geometry);
    if (solid.scene.parts.empty()) {
        throw ModelError("the model is empty: there is nothing to compare");
    }
    const csg::reference::Mesh mesh = reference_mesh(o, *loaded.model);
    const csg::reference::MeshFacts facts = csg::reference::facts(mesh);
    csg::Box box = csg::enclose(solid.geometry.box, facts.box);
    Errors all, outside;
    std::vector<ComparedView> views;
    Drawer drawer(solid, o.engine);
    for (int i = 0; i < o.views; ++i) {
        const gl::Camera camera = o.camera ? *o.camera : camera_of(i, o.views, facts.box.empty() ? box : facts.box);
        const gl::View view(camera, {o.size, o.size}, box.lo, box.hi);
        const auto stack = drawer.layers(view);
        const MeshLayers truth = mesh_layers(mesh, view);
        const Comparison comparison = compare_layers(stack, solid.geometry, mesh, truth, view, box.diagonal());
        all.add(comparison.all);
        outside.add(comparison.outside);
        if (!o.report.empty()) {
            views.push_back(compared_view(solid, mesh, view, stack, truth, comparison));
            views.back().title =
                fmt::format("View {} of {}, {}", i + 1, o.views, view.orthographic() ? "orthographic" : "perspective");
        }
    }
    const double worst = std::max({outside.coverage(), outside.layers(), outside.normals()});
    bool good = worst <= o.tolerance;
    Json openscad;
    if (o.against == "openscad") {
        const gl::Camera camera = o.camera ? *o.camera : camera_of(0, 1, facts.box);
        openscad = compare_with_openscad(OpenscadProcess(o.input), csg::scad::csg_text(*evaluate(o, true).tree),
                                         *loaded.model, facts, camera, o.size);
        good = good && openscad["volume"]["agrees"].get<bool>() && openscad["tree_agrees"].get<bool>();
    }
    Json json = {{"model", o.input},
                 {"against", o.against},
                 {"engine", o.engine},
                 {"views", o.views},
                 {"mesh", {{"triangles", mesh.triangles.size()}, {"volume", facts.volume}}},
                 {"all", to_json(all)},
                 {"without_band", to_json(outside)},
                 {"tolerance", o.tolerance},
                 {"within_tolerance", good}};
    if (!openscad.is_null()) {
        json["openscad"] = openscad;
    }
    fmt::print("{}\n", json.dump(2));
    if (!o.report.empty()) {
        fs::create_directories(o.report);
        const fs::path folder = o.report;
        for (std::size_t i = 0; i < views.size(); ++i) {
            write_output((folder / fmt::format("difference_{}.png", i + 1)).string(),
                         gl::encode_png(views[i].difference));
        }
        write_output((folder / "report.json").string(), json.dump(2) + "\n");
        write_output((folder / "report.html").string(),
                     report_page(fmt::format("{} against {}", o.input, o.against),
                                 fmt::format("Engine {}, {} views of {} × {} pixels, all layers. {}", o.engine, o.views,
                                             o.size, o.size, good ? "Within the tolerance." : "Beyond the tolerance."),
                                 views));
    }
    return good ? 0 : 1;
}

int compare_with_picture(const CompareOptions& o) {
    const gl::Image reference = gl::read_png(o.reference);
    const Loaded loaded = load(o);
    const auto context = gl::create_context(gl::ContextKind::Auto);
    Renderer renderer(
        *context, o.engine == "goldfeather" ? goldfeather::EngineKind::Goldfeather : goldfeather::EngineKind::ListsCpu);
    PictureRequest request;
    request.camera = choose_camera({}, loaded.view, loaded.model->box);
    request.size = {reference.width, reference.height};
    const gl::Image drawn = renderer.render(*loaded.model, request);
    std::size_t differ = 0;
    gl::Image difference = blank(request.size);
    for (std::size_t i = 0; i < drawn.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            most = std::max(most, std::abs(int{drawn.rgba[i + c]} - int{reference.rgba[i + c]}));
        }
        differ += most > 32 ? 1 : 0;  // an eighth of the range
        difference.rgba[i + 1] = difference.rgba[i + 2] = static_cast<std::uint8_t>(255 - most);
    }
    const double share = 4.0 * static_cast<double>(differ) / static_cast<double>(drawn.rgba.size());
    const bool good = share <= o.reference_threshold;
    const Json json = {{"model", o.input},
                       {"reference", o.reference},
                       {"pixels_that_differ", share},
                       {"threshold", o.reference_threshold},
                       {"within_threshold", good}};
    fmt::print("{}\n", json.dump(2));
    if (!o.report.empty()) {
        fs::create_directories(o.report);
        write_output((fs::path(o.report) / "difference_1.png").string(), gl::encode_png(difference));
        write_output((fs::path(o.report) / "report.json").string(), json.dump(2) + "\n");
        write_output((fs::path(o.report) / "report.html").string(),
                     report_page(fmt::format("{} against {}", o.input, o.reference), "Picture to picture.",
                                 {{"The picture", drawn, reference, difference, json, {}}}));
    }
    return good ? 0 : 1;
}

}  // namespace

int run_compare(const std::vector<std::string>& arguments) {
    const CompareOptions options = read_compare_options(arguments);
    if (options.input.empty()) {
        return 0;
    }
    return options.reference.empty() ? compare_with_mesh(options) : compare_with_picture(options);
}

}  // namespace ui
