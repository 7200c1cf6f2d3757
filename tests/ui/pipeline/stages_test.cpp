// Golden texts of the stages between the CSG tree and the picture: products and layers. CSGSCOPE_UPDATE_GOLDENS=1
// writes them anew; then look at the difference.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "csg/scad/scad.h"
#include "goldfeather/lists_cpu/lists_cpu.h"
#include "tests/support/temporary_folder.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/picture/camera.h"

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = CSGSCOPE_SOURCE_DIR;

std::shared_ptr<const ui::Model> load(const fs::path& path, csg::scad::ViewSettings& view) {
    csg::scad::Request request;
    request.path = path.string();
    const auto evaluation = csg::scad::evaluate(request, {});
    view = evaluation.view;
    return evaluation.ok ? ui::ModelBuilder().build(evaluation.tree) : nullptr;
}

/// A leaf by its place in the file: the line, and which of that line it is.
std::string leaf_name(const ui::Model& model, csg::LeafId leaf) {
    return fmt::format("{}#{}", model.scene.leaves[leaf].where.line, leaf);
}

std::string products_text(const ui::Model& model) {
    std::string text;
    for (std::size_t part = 0; part < model.products.size(); ++part) {
        for (const goldfeather::Product& product : model.products[part]) {
            text += fmt::format("part {}:", part);
            for (const goldfeather::Literal& literal : product.literals) {
                text += fmt::format(" {}{}", literal.complement ? "-" : "+", leaf_name(model, literal.leaf));
            }
            text += '\n';
        }
    }
    return text;
}

/// Layer by layer, a letter for each pixel's leaf: capital where it is a cut.
std::string layers_text(const ui::Model& model, const csg::scad::ViewSettings& settings) {
    base::Camera camera = ui::choose_camera({}, settings, model.box);
    const base::View view(camera, {48, 24}, model.geometry.box.lo, model.geometry.box.hi);
    const auto stack = goldfeather::peel_to_host(model.scene, model.geometry, view, 0, 1);
    std::string text;
    for (int layer = 0; layer < stack.layers; ++layer) {
        text += fmt::format("layer {}\n", layer);
        for (int y = stack.size.y - 1; y >= 0; --y) {
            for (int x = 0; x < stack.size.x; ++x) {
                const layers::Surface& s = stack.at(layer, x, y);
                text += s.depth > 0 ? static_cast<char>((s.reversed ? 'A' : 'a') + s.leaf % 26) : '.';
            }
            text += '\n';
        }
    }
    return text;
}

void expect_golden(const std::string& name, const std::string& text) {
    const fs::path path = kRoot / "tests/ui/pipeline/golden" / name;
    if (const char* update = std::getenv("CSGSCOPE_UPDATE_GOLDENS"); update != nullptr && *update == '1') {
        std::ofstream(path, std::ios::binary) << text;
    }
    EXPECT_EQ(test_support::read_file(path), text) << name;
}

class Stages : public testing::TestWithParam<const char*> {};

TEST_P(Stages, AreAsBefore) {
    csg::scad::ViewSettings view;
    const auto model = load(kRoot / GetParam(), view);
    ASSERT_NE(model, nullptr);
    const std::string name = fs::path(GetParam()).stem().string();
    expect_golden(name + ".products", products_text(*model));
    expect_golden(name + ".layers", layers_text(*model, view));
}

INSTANTIATE_TEST_SUITE_P(Models, Stages,
                         testing::Values("models/widget.scad", "models/torture.scad", "tests/ui/pipeline/nested.scad"));

}  // namespace
