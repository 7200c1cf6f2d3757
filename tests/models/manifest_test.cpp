// Every model of the gallery is what the manifest says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "csg/scad/scad.h"
#include "goldfeather/lists_cpu/lists_cpu.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/picture/camera.h"

namespace {

namespace fs = std::filesystem;
const fs::path kModels = fs::path(CSGSCOPE_SOURCE_DIR) / "models";

nlohmann::json manifest() {
    std::ifstream file(kModels / "manifest.json");
    return nlohmann::json::parse(file).at("models");
}

layers::HostStack peel(const ui::Model& model, const base::View& view) {
    return goldfeather::peel_to_host(model.scene, model.geometry, view);
}

/// The volume as the picture knows it: along each ray of an orthographic view the solid lies between an entering and a
/// leaving layer.
double volume(const ui::Model& model) {
    base::Camera camera;
    camera.projection = base::Projection::Orthographic;
    camera.rotation = {57, 0, 23};  // along no axis of a model
    base::view_all(camera, model.geometry.box.lo, model.geometry.box.hi, true);
    const int side = 1024;
    const base::View view(camera, glm::ivec2(side), model.geometry.box.lo, model.geometry.box.hi);
    const auto stack = peel(model, view);
    double length = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0; ++layer) {
                const layers::Surface& s = stack.at(layer, x, y);
                EXPECT_EQ(s.leaving, layer % 2 == 1) << "layers enter and leave in turn";
                length += (s.leaving ? 1 : -1) * view.distance(s.depth);
            }
        }
    }
    const double pixel = 2 * view.half_height() / side;
    return length * pixel * pixel;
}

TEST(Manifest, ModelsAreWhatItSays) {
    for (const auto& row : manifest()) {
        const std::string file = row.at("file");
        SCOPED_TRACE(file);
        csg::scad::Request request;
        request.path = (kModels / file).string();
        std::string messages;
        const auto evaluation = csg::scad::evaluate(request, [&](const auto& message, const auto& sources) {
            messages += csg::scad::render(message, sources);
        });
        ASSERT_TRUE(evaluation.ok) << messages;
        EXPECT_EQ(messages, "");
        const auto model = ui::ModelBuilder().build(evaluation.tree);
        EXPECT_EQ(model->warnings.size(), 0U);
        EXPECT_EQ(model->statistics.leaves, row.at("leaves"));
        EXPECT_EQ(model->statistics.products, row.at("products"));
        const base::Camera camera = ui::choose_camera({}, evaluation.view, model->box);
        const base::View view(camera, {512, 512}, model->geometry.box.lo, model->geometry.box.hi);
        EXPECT_EQ(peel(*model, view).layers, row.at("layers"));
        // A pixel on an outline is counted wholly or not at all, which is right to within half of it at random: with
        // some ten thousand of them among a few hundred thousand, about 3e-4 of the whole.
        const double expected = row.at("volume");
        EXPECT_NEAR(volume(*model), expected, 1e-3 * expected);
        EXPECT_GT(row.at("shows").get<std::string>().size(), 20U);
    }
}

}  // namespace
