// Mesh files: what is written is read again, and the same mesh gives the same bytes.
#include <gtest/gtest.h>
#include <zip.h>

#include "csg/reference/mesh_files.h"
#include "tests/csg/reference/meshes.h"

namespace {

using csg::reference::decode_mesh;
using ui::MeshFormat;

const char* const kProgram =
    "color([1, 0, 0]) difference() { cube(4); translate([1, 1, -1]) cylinder(h = 9, r = 0.7); } "
    "color([0, 0, 1]) translate([9, 0, 0]) rotate([10, 20, 30]) cube(2);";

TEST(MeshFiles, AreReadAgain) {
    const auto model = meshes::model_of(kProgram);
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    for (const MeshFormat format : {MeshFormat::AsciiStl, MeshFormat::Off}) {
        const auto read = csg::reference::facts(decode_mesh(ui::encode_mesh(*model, mesh, format)));
        EXPECT_TRUE(read.manifold);
        EXPECT_EQ(read.box, mesh.facts.box);
        EXPECT_NEAR(read.volume, mesh.facts.volume, 1e-12 * mesh.facts.volume);
    }
    const auto single = csg::reference::facts(decode_mesh(ui::encode_mesh(*model, mesh, MeshFormat::BinaryStl)));
    EXPECT_TRUE(single.manifold);
    EXPECT_NEAR(single.volume, mesh.facts.volume, 1e-6 * mesh.facts.volume);
}

TEST(MeshFiles, SameBytes) {
    const auto model = meshes::model_of(kProgram);
    const auto again = meshes::model_of(kProgram);
    for (const MeshFormat format : {MeshFormat::AsciiStl, MeshFormat::BinaryStl, MeshFormat::Off, MeshFormat::Obj,
                                    MeshFormat::Amf, MeshFormat::ThreeMf, MeshFormat::Wrl}) {
        const std::string bytes = ui::encode_mesh(*model, ui::make_mesh(*model), format);
        EXPECT_GT(bytes.size(), 1000u);
        EXPECT_EQ(bytes, ui::encode_mesh(*again, ui::make_mesh(*again), format));
    }
}

TEST(MeshFiles, ColorsArePartsOfTheFile) {
    const auto model = meshes::model_of(kProgram);
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    const std::string amf = ui::encode_mesh(*model, mesh, MeshFormat::Amf);
    EXPECT_NE(amf.find("<color><r>1</r><g>0</g><b>0</b><a>1</a></color>"), std::string::npos);
    EXPECT_NE(amf.find("<color><r>0</r><g>0</g><b>1</b><a>1</a></color>"), std::string::npos);
    EXPECT_NE(amf.find("<volume materialid=\"2\">"), std::string::npos);
    EXPECT_NE(amf.find("<metadata type=\"name\">part 1 (test.scad:1)</metadata>"), std::string::npos);
    const std::string obj = ui::encode_mesh(*model, mesh, MeshFormat::Obj);
    EXPECT_NE(obj.find("g part_1_(test.scad:1)\n"), std::string::npos);
    EXPECT_NE(obj.find("g part_2_(test.scad:1)\n"), std::string::npos);
}

/// The model inside a 3MF package.
std::string model_in(const std::string& package) {
    zip_error_t error;
    zip_source_t* source = zip_source_buffer_create(package.data(), package.size(), 0, &error);
    zip_t* archive = zip_open_from_source(source, ZIP_RDONLY, &error);
    EXPECT_NE(archive, nullptr);
    zip_file_t* file = zip_fopen(archive, "3D/3dmodel.model", 0);
    std::string text(1 << 20, '\0');
    text.resize(static_cast<std::size_t>(zip_fread(file, text.data(), text.size())));
    zip_fclose(file);
    zip_discard(archive);
    return text;
}

TEST(MeshFiles, ThreeMfAsAsked) {
    const auto model = meshes::model_of(kProgram);
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    const auto written = [&](const csg::reference::ThreeMfOptions& how) {
        return model_in(ui::encode_mesh(*model, mesh, MeshFormat::ThreeMf, how));
    };
    const auto holds = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    csg::reference::ThreeMfOptions how;
    const std::string plain = written(how);
    EXPECT_TRUE(holds(plain, "unit=\"millimeter\""));
    EXPECT_TRUE(holds(plain, "<base name=\"part 1 (test.scad:1)\" displaycolor=\"#FF0000FF\"/>"));
    EXPECT_TRUE(holds(plain, "pid=\"1\" p1=\"1\""));
    how.unit = "inch";
    how.color_group = true;
    how.decimals = 2;
    how.meta_data["Title"] = "a < b";
    const std::string colors = written(how);
    EXPECT_TRUE(holds(colors, "unit=\"inch\""));
    EXPECT_TRUE(holds(colors, "<metadata name=\"Title\">a &lt; b</metadata>"));
    EXPECT_TRUE(holds(colors, "<m:color color=\"#0000FFFF\"/>"));
    EXPECT_FALSE(holds(colors, "basematerials"));
    EXPECT_TRUE(holds(colors, "x=\"0.43\" y=\"1.41\""));  // a corner of the hole
    how.colors = csg::reference::ThreeMfColors::None;
    EXPECT_FALSE(holds(written(how), "pid="));
    how.colors = csg::reference::ThreeMfColors::Selected;
    how.selected = {0, 1, 0, 1};
    EXPECT_FALSE(holds(written(how), "#FF0000FF"));
    EXPECT_TRUE(holds(written(how), "#00FF00FF"));
}

TEST(MeshFiles, BrokenFilesAreRefused) {
    const char* const broken[] = {"",
                                  "solid",
                                  "solid x\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop",
                                  "solid x\nvertex 0 0 nan\n",
                                  "OFF",
                                  "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n",
                                  "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n",
                                  "OFF\n99999999999999 1 0\n",
                                  "PNG"};
    for (const char* text : broken) {
        EXPECT_THROW((void)decode_mesh(text), std::runtime_error) << text;
    }
}

}  // namespace
