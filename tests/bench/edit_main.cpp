// What it takes to move a leaf among thousands, beside the frame that shows it: a plate with holes, one of which is
// moved from frame to frame. Processor time, medians.
//
//     csgscope_edit [--holes N] [--size PIXELS] [--frames N]
#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <iostream>

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "goldfeather/engines.h"
#include "npr/style.h"
#include "tests/bench/measure.h"
#include "ui/pipeline/editable_model.h"
#include "ui/pipeline/picture/renderer.h"

namespace {

/// A square plate with holes of 32 sides in rows; they are 2 wide and 4 apart.
std::shared_ptr<const ui::Model> plate(int holes) {
    const int side = static_cast<int>(std::ceil(std::sqrt(holes)));
    csg::TreeBuilder builder;
    std::vector<csg::NodeId> all{builder.leaf(csg::Cube{{4.0 * side, 4.0 * side, 2}, false}, {})};
    const csg::NodeId hole = builder.leaf(csg::Cylinder{4, 1, 1, true, {32, 12, 2}}, {});
    for (int i = 0; i < holes; ++i) {
        const glm::dvec3 at(4 * (i % side) + 2, 4 * (i / side) + 2, 1);
        all.push_back(builder.transform(glm::translate(glm::dmat4(1.0), at), std::array{hole}, {}));
    }
    const csg::NodeId root = builder.combine(csg::Operation::Difference, all, {});
    return ui::ModelBuilder().build(std::make_shared<const csg::Tree>(builder.finish(root)));
}

double middle(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

struct Stages {
    std::vector<double> scene, products, renderer, frame;
};

void measure(const ui::Model& model, const goldfeather::EngineInfo& engine, int holes, int size, int frames) {
    ui::EditableModel edited(model);
    ui::Renderer renderer(&engine, engine.capabilities.needs_opengl ? ui::Painter::OpenGl : ui::Painter::Cpu);
    ui::PictureRequest request;
    request.size = {size, size};
    request.samples = 1;
    base::view_all(request.camera, model.box.lo, model.box.hi, true);
    (void)renderer.render(edited.model(), request);

    const auto moved = static_cast<csg::LeafId>(holes / 2 + 1);
    const glm::dmat4 rest = edited.model().scene.leaves[moved].to_world;
    Stages stages;
    for (int i = 0; i <= frames; ++i) {
        const bench::Time start = bench::now();
        const double angle = 0.1 * (i + 1);
        edited.scene().move(moved, glm::translate(rest, {0.7 * std::cos(angle), 0.7 * std::sin(angle), 0}));
        const csg::solid::SceneChange change = edited.commit();
        const bench::Time committed = bench::now();
        renderer.update(edited.model(), change);
        const bench::Time updated = bench::now();
        (void)renderer.render(edited.model(), request);
        const bench::Time drawn = bench::now();
        if (i == 0) {
            continue;  // To warm up.
        }
        const ui::ModelStatistics& times = edited.model().statistics;
        const double both = (committed - start).cpu, share = times.place_ms / (times.place_ms + times.normalize_ms);
        stages.scene.push_back(both * share);
        stages.products.push_back(both * (1 - share));
        stages.renderer.push_back((updated - committed).cpu);
        stages.frame.push_back((drawn - updated).cpu);
    }
    const double scene = middle(stages.scene), products = middle(stages.products), rest_of_it = middle(stages.renderer),
                 frame = middle(stages.frame);
    fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.1f} | {:.1f} % |\n", engine.name, scene, products,
               rest_of_it, scene + products + rest_of_it, frame, 100 * (scene + products + rest_of_it) / frame);
}

}  // namespace

int main(int argc, char** argv) {
    int holes = 3000, size = 512, frames = 25;
    CLI::App app{"Moves one hole of a plate from frame to frame."};
    app.add_option("--holes", holes)->check(CLI::PositiveNumber);
    app.add_option("--size", size, "Of the picture, in pixels")->check(CLI::PositiveNumber);
    app.add_option("--frames", frames)->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);

    const bench::Time start = bench::now();
    const std::shared_ptr<const ui::Model> model = plate(holes);
    const double built = (bench::now() - start).cpu;
    fmt::print(
        "{} holes, {} triangles, {}²; the model from nothing: {:.1f} ms.\n\n"
        "| engine | scene | products | renderer | update | frame | update of the frame |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n",
        holes, model->statistics.triangles, size, built);
    for (const goldfeather::EngineInfo& engine : goldfeather::engines()) {
        if (engine.cost != nullptr) {
            measure(*model, engine, holes, size, frames);
        }
    }
}
