// Meshes of the gallery: closed, as large as OpenSCAD's, and what the picture shows.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "csg/reference/self_intersection.h"
#include "csg/scad/scad.h"
#include "tests/csg/reference/meshes.h"

namespace {

using Json = nlohmann::json;

const std::string kModels = CSGSCOPE_SOURCE_DIR "/models/";

std::vector<Json> gallery() {
    std::ifstream file(kModels + "manifest.json");
    return Json::parse(file).at("models").get<std::vector<Json>>();
}

std::shared_ptr<const ui::Model> load(const std::string& path) {
    csg::scad::Request request;
    request.path = path;
    request.preview = false;
    const auto evaluation = csg::scad::evaluate(request, [](const auto&, const auto&) {});
    if (!evaluation.ok) {
        throw std::runtime_error(path + " has errors");
    }
    return ui::ModelBuilder().build(evaluation.tree);
}

/// What OpenSCAD's files can be wrong by: it writes six digits, so that each point moves by up to half a unit of the
/// last place of each coordinate, and the volume by at most the area times that way.
double rounding(const ui::ModelMesh& mesh) {
    const glm::dvec3 largest = glm::max(glm::abs(mesh.facts.box.lo), glm::abs(mesh.facts.box.hi));
    double way2 = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double half = 0.5 * std::pow(10.0, std::floor(std::log10(largest[axis])) - 5);
        way2 += half * half;
    }
    return mesh.facts.area * std::sqrt(way2);
}

TEST(GalleryMeshes, AreClosedAndAsLargeAsOpenScads) {
    for (const Json& entry : gallery()) {
        const std::string file = entry.at("file");
        SCOPED_TRACE(file);
        const auto model = load(kModels + file);
        const ui::ModelMesh mesh = ui::make_mesh(*model);
        EXPECT_NE(mesh.method, "exact") << mesh.reason;
        EXPECT_TRUE(mesh.facts.manifold);
        const double expected = entry.at("volume");
        EXPECT_LE(std::abs(mesh.facts.volume - expected), rounding(mesh) + 1e-6 * expected);
        EXPECT_EQ(csg::reference::count_self_intersections(mesh.mesh, 1e-8 * mesh.facts.box.diagonal()), 0u);
    }
}

/// Ten and one larger models (tests/bench/meshes), 14 to 1,163 leaves, which OpenSCAD takes minutes for.
class LargerMeshes : public testing::TestWithParam<const char*> {};

TEST_P(LargerMeshes, AreClosedAndAsLargeAsOpenScads) {
    const std::string folder = CSGSCOPE_SOURCE_DIR "/tests/bench/meshes/";
    std::ifstream volumes(folder + "volumes.txt");
    double expected = 0;
    for (std::string line; std::getline(volumes, line);) {
        std::istringstream words(line);
        if (std::string name; words >> name && name == GetParam()) {
            words >> expected;
        }
    }
    const ui::ModelMesh mesh = ui::make_mesh(*load(folder + GetParam() + ".scad"));
    EXPECT_NE(mesh.method, "exact") << mesh.reason;
    EXPECT_TRUE(mesh.facts.manifold);
    EXPECT_LE(std::abs(mesh.facts.volume - expected), rounding(mesh) + 1e-6 * expected);
}

INSTANTIATE_TEST_SUITE_P(Benchmark, LargerMeshes,
                         testing::Values("bored_block", "engraved_plate", "fluted_vase", "gear_train", "heat_sink",
                                         "hull_chain", "lattice", "menger_3", "minkowski_case", "perforated_panel",
                                         "threaded_rod"),
                         [](const auto& info) { return std::string(info.param); });

TEST(GalleryMeshes, AreWhatThePictureShows) {
    for (const Json& entry : gallery()) {
        const std::string file = entry.at("file");
        SCOPED_TRACE(file);
        const auto model = load(kModels + file);
        const auto [all, outside] =
            meshes::picture_errors(model->scene, model->geometry, ui::make_mesh(*model).mesh, 192);
        EXPECT_EQ(outside.coverage_wrong, 0u);
        EXPECT_EQ(outside.layers_wrong, 0u);
        EXPECT_EQ(outside.normals_wrong, 0u);
        EXPECT_LT(outside.depth_largest, 1e-5);
        EXPECT_GT(outside.surfaces, 1000u);
        // Facets of round solids are narrow, so the band is wide; but in it, too, hardly a pixel differs.
        EXPECT_LT(all.coverage(), 1e-3);
        EXPECT_LT(all.layers(), 1e-2);
        EXPECT_GT(all.edge_f_score(), 0.99);
    }
}

}  // namespace
