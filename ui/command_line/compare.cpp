#include "ui/command_line/compare.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "base/file.h"
#include "base/stop.h"
#include "csg/scad/text/csg_text.h"
#include "ui/command_line/compare_drawer.h"
#include "ui/command_line/compare_input.h"
#include "ui/command_line/compare_openscad.h"
#include "ui/command_line/compare_options.h"
#include "ui/command_line/compare_picture.h"
#include "ui/command_line/compare_report.h"
#include "ui/command_line/compare_table.h"
#include "ui/command_line/compare_versions.h"
#include "ui/command_line/compare_views.h"
#include "ui/command_line/files.h"
#include "ui/command_line/time_limit.h"
#include "ui/pipeline/comparison/errors.h"
#include "ui/pipeline/comparison/layer_volume.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

namespace fs = std::filesystem;

/// Those that an engine finds which finds `most` (goldfeather::kAllLayers: all).
MeshLayers first_layers(MeshLayers layers, int most) {
    if (most != goldfeather::kAllLayers) {
        for (std::vector<MeshSurface>& pixel : layers.of) {
            pixel.resize(std::min(pixel.size(), static_cast<std::size_t>(most)));
        }
    }
    return layers;
}

/// The volume by a picture of all layers: by the view where least may lie between the samples.
class PictureVolume {
  public:
    void look(const layers::HostStack& stack, const base::View& view) {
        const LayerVolume seen = layer_volume(stack, view);
        if (!known_ || seen.uncertainty < known_->uncertainty) {
            known_ = seen;
        }
    }
    [[nodiscard]] bool known() const { return known_.has_value(); }
    [[nodiscard]] bool agrees(double volume, double tolerance) const {
        return !known_ ||
               std::abs(known_->volume - volume) <=
                   known_->uncertainty + (tolerance + kRounding) * std::max(known_->volume, std::abs(volume));
    }
    [[nodiscard]] Json to_json(double volume, double tolerance) const {
        return !known_ ? Json(nullptr)
                       : Json{{"picture", known_->volume},
                              {"uncertainty", known_->uncertainty},
                              {"agrees", agrees(volume, tolerance)}};
    }

  private:
    static constexpr double kRounding = 1e-4;  ///< Of depths in single precision.
    std::optional<LayerVolume> known_;
};

int compare_with_mesh(const CompareOptions& o) {
    const ComparedModel loaded = load(o);
    need_whole(*loaded.model);
    const SolidScene solid = solid_scene(loaded.model->scene, loaded.model->geometry);
    if (solid.scene.parts.empty()) {
        throw ModelError("the model is empty: there is nothing to compare");
    }
    const csg::reference::Mesh mesh = reference_mesh(o, *loaded.model);
    const csg::reference::MeshFacts facts = csg::reference::facts(mesh);
    csg::Box box = csg::enclose(solid.geometry.box, facts.box);
    Errors all, outside;
    PictureVolume volume;
    std::vector<ComparedView> views;
    Drawer drawer(solid, *o.engine);
    for (int i = 0; i < o.views; ++i) {
        base::end_if_asked(o.stop);
        const base::Camera camera =
            o.camera ? *o.camera : spread_camera(i, o.views, facts.box.empty() ? box : facts.box);
        const base::View view(camera, o.size, box.lo, box.hi);
        const auto stack = drawer.layers(view);
        const MeshLayers truth = first_layers(mesh_layers(mesh, view), drawer.most_layers());
        const Comparison comparison = compare_layers(*stack, solid.geometry, mesh, truth, view, box.diagonal());
        if (view.orthographic() && drawer.most_layers() == goldfeather::kAllLayers && !o.camera) {
            volume.look(*stack, view);
        }
        all.add(comparison.all);
        outside.add(comparison.outside);
        if (!o.report.empty()) {
            views.push_back(compared_view(solid, mesh, view, *stack, truth, comparison));
            views.back().title =
                fmt::format("View {} of {}, {}", i + 1, o.views, view.orthographic() ? "orthographic" : "perspective");
        }
    }
    if (!volume.known() && drawer.most_layers() == goldfeather::kAllLayers) {
        const base::View view(spread_camera(1, 2, facts.box.empty() ? box : facts.box), o.size, box.lo, box.hi);
        volume.look(*drawer.layers(view), view);
    }
    const double worst = std::max({outside.coverage(), outside.layers(), outside.order(), outside.normals()});
    bool good = worst <= o.tolerance && volume.agrees(facts.volume, o.tolerance);
    Json openscad;
    if (o.against == "openscad") {
        const base::Camera camera = o.camera ? *o.camera : spread_camera(0, 1, facts.box);
        openscad = compare_with_openscad(OpenscadProcess(o.input), csg::scad::csg_text(*evaluate(o, true).tree),
                                         *loaded.model, facts, camera, o.size);
        good = good && openscad["volume"]["agrees"].truth() && openscad["tree_agrees"].truth();
    }
    Json json = {{"model", o.input},
                 {"against", o.against},
                 {"engine", o.engine->name},
                 {"layers", drawer.most_layers() == goldfeather::kAllLayers ? Json("all") : Json(drawer.most_layers())},
                 {"views", o.views},
                 {"size", {o.size.x, o.size.y}},
                 {"mesh", {{"triangles", mesh.triangles.size()}, {"volume", facts.volume}}},
                 {"volume", volume.to_json(facts.volume, o.tolerance)},
                 {"all", to_json(all)},
                 {"without_band", to_json(outside)},
                 {"tolerance", o.tolerance},
                 {"within_tolerance", good}};
    if (!openscad.is_null()) {
        json["openscad"] = openscad;
    }
    write_output("-", o.json ? text_of(json) : printable(compare_table(json)));
    if (!o.report.empty()) {
        base::make_folder(o.report);
        const fs::path folder = o.report;
        for (std::size_t i = 0; i < views.size(); ++i) {
            write_output((folder / fmt::format("difference_{}.png", i + 1)).string(),
                         base::encode_png(views[i].difference));
        }
        write_output((folder / "report.json").string(), text_of(json));
        write_output(
            (folder / "report.html").string(),
            report_page(fmt::format("{} against {}", o.input, o.against),
                        fmt::format("Engine {}, {} views of {} × {} pixels, {}. {}", o.engine->name, o.views, o.size.x,
                                    o.size.y,
                                    drawer.most_layers() == goldfeather::kAllLayers ? "all layers" : "the first layer",
                                    good ? "Within the tolerance." : "Beyond the tolerance."),
                        views));
    }
    return good ? 0 : 1;
}

}  // namespace

int run_compare(const std::vector<std::string>& arguments) {
    CompareOptions options = read_compare_options(arguments);
    options.runner = std::make_shared<ProgramRunner>(make_measures());
    if (options.input.empty()) {
        return 0;
    }
    TimeLimit limit(options.time_limit);
    options.stop = limit.token();
    try {
        const int status = !options.later.empty()      ? compare_versions(options)
                           : options.reference.empty() ? compare_with_mesh(options)
                                                       : compare_with_picture(options);
        limit.end();
        return status;
    } catch (const base::Stopped&) {
        limit.tell();
        return 1;
    }
}

}  // namespace ui
