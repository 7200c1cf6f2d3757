// Export and comparison, as their users run them; and what may go wrong while a file is written.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Export : public test_support::ProgramTest {
  protected:
    Export() : ProgramTest(100) {}

    /// Names in the folder that a broken write might have left.
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path("")), {}));
    }
};

TEST_F(Export, AllFormats) {
    const Result result = run("m.scad -o m.stl -o m.off -o m.obj -o m.amf -o m.3mf -o m.wrl --summary-file s.json");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(folder_.read("m.stl").starts_with("solid "));
    EXPECT_TRUE(folder_.read("m.off").starts_with("OFF\n"));
    EXPECT_NE(folder_.read("m.obj").find("\nf "), std::string::npos);
    EXPECT_NE(folder_.read("m.amf").find("</amf>"), std::string::npos);
    EXPECT_TRUE(folder_.read("m.3mf").starts_with("PK\3\4"));
    EXPECT_TRUE(folder_.read("m.wrl").starts_with("#VRML V2.0 utf8"));
    const Json geometry = Json::parse(folder_.read("s.json")).at("geometry");
    EXPECT_EQ(geometry.at("simple"), true);
    EXPECT_EQ(geometry.at("bounding_box").at("size"), Json({10.0, 10.0, 10.0}));
    EXPECT_GT(geometry.at("volume"), 0.0);
}

TEST_F(Export, DrawingsOfFlatModels) {
    folder_.write("f.scad", "difference() { square(20, center = true); circle(5, $fn = 40); }");
    const Result result =
        run("f.scad -o f.svg -o f.dxf -o f.pdf -O export-svg/fill-color=gold -O export-pdf/paper-size=a5 "
            "--summary-file s.json");
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(folder_.read("f.svg").find("fill=\"#ffd700\""), std::string::npos);
    EXPECT_NE(folder_.read("f.dxf").find("\nLINE\n"), std::string::npos);
    EXPECT_NE(folder_.read("f.pdf").find("/MediaBox [0 0 419.528 595.276]"), std::string::npos);
    const Json geometry = Json::parse(folder_.read("s.json")).at("geometry");
    EXPECT_EQ(geometry.at("dimensions"), 2);
    EXPECT_EQ(geometry.at("contours"), 2);
    EXPECT_EQ(geometry.at("convex"), false);
    EXPECT_EQ(geometry.at("bounding_box").at("size"), Json({20.0, 20.0}));
    // What is written is the same model again.
    for (const char* file : {"f.svg", "f.dxf"}) {
        folder_.write("again.scad", std::string("import(\"") + file + "\");");
        ASSERT_EQ(run("again.scad --summary area --summary-file again.json -q").status, 0);
        EXPECT_NEAR(Json::parse(folder_.read("again.json")).at("geometry").at("area").get<double>(),
                    geometry.at("area").get<double>(), 1e-9)
            << file;
    }
}

TEST_F(Export, SameBytesFromAnywhere) {
    folder_.write("f.scad", "square(20, center = true); translate([0, 15]) text(\"a\");");
    fs::create_directory(folder_.path("below"));
    folder_.write("below/f.scad", folder_.read("f.scad"));
    folder_.write("below/m.scad", folder_.read("m.scad"));
    ASSERT_EQ(run("f.scad -o f.svg -o f.dxf -o f.pdf").status, 0);
    ASSERT_EQ(run("m.scad -o m.stl -o m.off -o m.obj -o m.amf -o m.3mf -o m.wrl").status, 0);
    ASSERT_EQ(run("below/f.scad -o b.svg -o b.dxf -o b.pdf").status, 0);
    ASSERT_EQ(run("below/m.scad -o b.stl -o b.off -o b.obj -o b.amf -o b.3mf -o b.wrl").status, 0);
    for (const std::string suffix : {"svg", "dxf", "pdf"}) {
        EXPECT_EQ(folder_.read("f." + suffix), folder_.read("b." + suffix)) << suffix;
    }
    for (const std::string suffix : {"stl", "off", "obj", "amf", "3mf", "wrl"}) {
        EXPECT_EQ(folder_.read("m." + suffix), folder_.read("b." + suffix)) << suffix;
    }
}

/// Addresses differ from process to process.
TEST_F(Export, SameBytesInEveryProcess) {
    folder_.write("h.scad",
                  "translate([20, 0, 0]) linear_extrude(3) text(\"I\", size = 5);\n"
                  "hull() { sphere(3); translate([5, 0, 0]) sphere(3); }");
    ASSERT_EQ(run("h.scad -o first.off --cache kept").status, 0);
    for (int i = 0; i < 9; ++i) {
        ASSERT_EQ(run("h.scad -o again.off").status, 0);
        ASSERT_EQ(folder_.read("again.off"), folder_.read("first.off"));
    }
    ASSERT_EQ(run("h.scad -o again.off --cache kept --stats s.json").status, 0);
    EXPECT_EQ(Json::parse(folder_.read("s.json")).at("mesh").at("cached"), true);
}

/// Sheets that touch are apart in a file of indices; a file of positions joins them, and edges have four faces.
TEST_F(Export, ReadsItsOwnFilesOfSolidsThatTouch) {
    const std::pair<const char*, double> models[] = {
        {"cube(2); translate([2, 2, 0]) cube(2);", 16},
        {"cube(2); translate([2, 2, 2]) cube(2);", 16},
        {"for (x = [0:2], y = [0:2], z = [0:2]) if ((x + y + z) % 2 == 0) translate([x, y, z]) cube(1);", 14},
        {"difference() { rotate([17.3, 29.1, 41.7]) cube([9999, 1, 3]); rotate([3, 4, 5]) cube(2, center = true); }",
         0}};
    for (const auto& [program, volume] : models) {
        folder_.write("t.scad", program);
        ASSERT_EQ(run("t.scad -o t.stl -o t.off -o t.obj -o t.amf -o t.3mf --summary-file t.json").status, 0);
        const double first = Json::parse(folder_.read("t.json")).at("geometry").at("volume");
        EXPECT_NEAR(first, volume > 0 ? volume : first, 1e-9 * first) << program;
        for (const char* file : {"t.stl", "t.off", "t.obj", "t.amf", "t.3mf"}) {
            folder_.write("again.scad", std::string("difference() { import(\"") + file +
                                            "\"); translate([-99, -99, -99]) cube(1); }");
            const Result result = run("again.scad -o again.off --summary-file again.json");
            ASSERT_EQ(result.status, 0) << file << result.err;
            EXPECT_NEAR(Json::parse(folder_.read("again.json")).at("geometry").at("volume").get<double>(), first,
                        1e-6 * first)
                << file << program;
        }
    }
}

TEST_F(Export, DimensionsThatDoNotFitAreRefused) {
    folder_.write("flat.scad", "\nsquare(3);");
    folder_.write("mixed.scad", "cube(3);\nsquare(9);");
    folder_.write("mixed2.scad", "square(9);\ncube(3);");
    const auto refused = [&](const std::string& arguments, const std::string& why) {
        const Result result = run(arguments);
        EXPECT_EQ(result.status, 1) << arguments;
        EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
    };
    refused("flat.scad -o x.stl", "flat.scad:2:1: the model is flat");
    refused("m.scad -o x.svg", "the model is solid");
    refused("mixed.scad -o x.svg", "mixed.scad:1:1: the model is solid");
    refused("mixed2.scad -o x.stl", "mixed2.scad:1:1: the model is flat");
    refused("m.scad -o x.stl -o x.svg", "the model is solid");
    folder_.write("none.scad", "");
    refused("none.scad -o x.pdf", "empty");
    for (const char* file : {"x.stl", "x.svg", "x.pdf"}) {
        EXPECT_FALSE(fs::exists(folder_.path(file))) << file;
    }
}

TEST_F(Export, ADrawingLargerThanThePageIsAWarning) {
    folder_.write("f.scad", "square([250, 10]);");
    EXPECT_NE(run("f.scad -o f.pdf").err.find("larger than the page"), std::string::npos);
    EXPECT_EQ(run("f.scad -o f.pdf -O export-pdf/orientation=auto").err, "");
}

TEST_F(Export, SummariesTellWhatIsAsked) {
    ASSERT_EQ(run("m.scad --summary time --summary camera --summary cache --summary-file s.json -q").status, 0);
    const Json some = Json::parse(folder_.read("s.json"));
    EXPECT_EQ(some.size(), 3u);
    EXPECT_GT(some.at("cache").at("geometry_cache").at("entries"), 0);
    EXPECT_EQ(some.at("camera").at("fov"), 22.5);
    EXPECT_EQ(some.at("time").at("hours"), 0);
    EXPECT_EQ(some.at("time").at("total").get<int>() % 1000, some.at("time").at("milliseconds"));
    ASSERT_EQ(run("m.scad --summary volume --summary-file s.json -q").status, 0);
    const Json volume = Json::parse(folder_.read("s.json"));
    EXPECT_EQ(volume.size(), 1u);
    EXPECT_EQ(volume.at("geometry").size(), 2u);  // dimensions and volume
    EXPECT_GT(volume.at("geometry").at("volume"), 0.0);
    EXPECT_NE(run("m.scad --summary areas").err.find("Did you mean \"area\"?"), std::string::npos);
}

TEST_F(Export, OptionsOfFormats) {
    EXPECT_NE(run("m.scad -o m.3mf -O export-3mf/units=inch").err.find("Did you mean \"export-3mf/unit\"?"),
              std::string::npos);
    EXPECT_EQ(run("m.scad -o m.3mf -O export-3mf/unit=mile").status, 1);
    EXPECT_EQ(run("m.scad -o m.3mf -O export-3mf/decimal-precision=17").status, 1);
    EXPECT_EQ(run("m.scad -o m.3mf -O export-3mf/unit").status, 1);
    const Result help = run("--help-export");
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("paper-size"), std::string::npos);
}

TEST_F(Export, FormatOfStandardOutput) {
    EXPECT_TRUE(run("m.scad -o - --export-format asciistl").out.starts_with("solid "));
    const Result binary = run("m.scad -o - --export-format binstl");
    EXPECT_EQ((binary.out.size() - 84) % 50, 0u);
}

TEST_F(Export, EmptyGeometryIsRefused) {
    folder_.write("empty.scad", "difference() { cube(1); cube(2); }");
    const Result result = run("empty.scad -o empty.stl");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("empty"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder_.path("empty.stl")));
}

TEST_F(Export, MissingFolderIsRefused) {
    const Result result = run("m.scad -o nowhere/m.stl");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("nowhere/m.stl"), std::string::npos) << result.err;
}

TEST_F(Export, AFullDiskLeavesTheOldFile) {
    folder_.write("m.stl", "old");
    // 1 block of 1024 bytes: the mesh needs many. Without SIGXFSZ the write fails as on a full disk.
    const Result result = run("m.scad -o m.stl", "trap '' XFSZ; ulimit -f 1;");
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_EQ(folder_.read("m.stl"), "old");
    EXPECT_EQ(files(), 4u);  // m.scad, m.stl, out.txt, err.txt
}

TEST_F(Export, KilledWhileExporting) {
    folder_.write("big.scad",
                  "difference() { sphere(10, $fn = 200); for (i = [0:35]) rotate(10 * i) "
                  "translate([10, 0, 0]) sphere(2, $fn = 40); }");
    folder_.write("big.stl", "old");
    for (const char* after : {"0.05", "0.2", "0.4", "0.8"}) {
        const std::string command = "cd '" + folder_.path("") + "' && timeout -s KILL " + after +
                                    " '" CSGSCOPE_PROGRAM "' big.scad -o big.stl >out.txt 2>err.txt";
        (void)std::system(command.c_str());
        const std::string bytes = folder_.read("big.stl");
        EXPECT_TRUE(bytes == "old" || bytes.ends_with("endsolid OpenSCAD_Model\n"));
    }
}

TEST_F(Export, ConcurrentExportsToOneFile) {
    const std::string command = "cd '" + folder_.path("") +
                                "' && for i in 1 2 3 4 5 6; do '" CSGSCOPE_PROGRAM
                                "' m.scad -o m.stl 2>>err.txt & done; wait";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const std::string together = folder_.read("m.stl");
    ASSERT_EQ(run("m.scad -o one.stl").status, 0);
    EXPECT_EQ(together, folder_.read("one.stl"));
}

TEST_F(Export, MeshesAreKept) {
    ASSERT_EQ(run("m.scad -o a.stl --cache kept --stats a.json").status, 0);
    ASSERT_EQ(run("m.scad -o b.stl --cache kept --stats b.json").status, 0);
    EXPECT_EQ(Json::parse(folder_.read("a.json")).at("mesh").at("cached"), false);
    EXPECT_EQ(Json::parse(folder_.read("b.json")).at("mesh").at("cached"), true);
    EXPECT_EQ(folder_.read("a.stl"), folder_.read("b.stl"));
    // Another model is not taken for it.
    ASSERT_EQ(run("m.scad -D '$fn=7' -o c.stl --cache kept").status, 0);
    folder_.write("n.scad", "difference() { cube(10, center = true); sphere(6, $fn = 25); }\n");
    ASSERT_EQ(run("n.scad -o n.stl --cache kept").status, 0);
    EXPECT_NE(folder_.read("n.stl"), folder_.read("a.stl"));
}

TEST_F(Export, DamagedCacheFilesAreMadeAgain) {
    ASSERT_EQ(run("m.scad -o a.stl --cache kept").status, 0);
    const fs::path kept = fs::directory_iterator(folder_.path("kept"))->path();
    const std::string whole = test_support::read_file(kept);
    for (std::size_t i = 0; i < 40; ++i) {
        std::string bytes = whole;
        if (i % 2 == 0) {
            bytes.resize(whole.size() * i / 40);  // torn
        } else {
            bytes[whole.size() * i / 40] ^= 0x10;  // a flipped bit
        }
        folder_.write("kept/" + kept.filename().string(), bytes);
        ASSERT_EQ(run("m.scad -o b.stl --cache kept").status, 0);
        ASSERT_EQ(folder_.read("b.stl"), folder_.read("a.stl"));
        ASSERT_EQ(test_support::read_file(kept), whole);
    }
}

TEST_F(Export, KilledWhileKeeping) {
    folder_.write("big.scad", "difference() { sphere(10, $fn = 120); translate([5, 0, 0]) sphere(8, $fn = 100); }");
    for (const char* after : {"0.05", "0.1", "0.2", "0.4"}) {
        const std::string command = "cd '" + folder_.path("") + "' && timeout -s KILL " + after +
                                    " '" CSGSCOPE_PROGRAM "' big.scad -o big.off --cache kept >out.txt 2>err.txt";
        (void)std::system(command.c_str());
    }
    ASSERT_EQ(run("big.scad -o a.off --cache kept").status, 0);
    ASSERT_EQ(run("big.scad -o b.off").status, 0);
    EXPECT_EQ(folder_.read("a.off"), folder_.read("b.off"));
}

TEST_F(Export, ConcurrentExportsIntoOneCache) {
    const std::string command = "cd '" + folder_.path("") +
                                "' && for i in 1 2 3 4 5 6; do '" CSGSCOPE_PROGRAM
                                "' m.scad -o m$i.stl --cache kept 2>>err.txt & done; wait";
    ASSERT_EQ(std::system(command.c_str()), 0);
    ASSERT_EQ(run("m.scad -o one.stl").status, 0);
    for (int i = 1; i <= 6; ++i) {
        EXPECT_EQ(folder_.read(fmt::format("m{}.stl", i)), folder_.read("one.stl"));
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path("kept")), {}), 1);  // nothing half written beside it
    ASSERT_EQ(run("m.scad -o b.stl --cache kept --stats b.json").status, 0);
    EXPECT_EQ(Json::parse(folder_.read("b.json")).at("mesh").at("cached"), true);
}

TEST_F(Export, AFullDeviceIsAnError) {
    const Result result = run("m.scad -o /dev/full --export-format stl");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("No space left"), std::string::npos) << result.err;
}

TEST_F(Export, ACacheThatCannotBeWrittenIsAWarning) {
    folder_.write("file", "");
    const Result result = run("m.scad -o a.stl --cache file/kept");
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("not kept"), std::string::npos) << result.err;
}

TEST_F(Export, ThePictureAgreesWithTheMesh) {
    const Result result = run("compare --json m.scad --views 3 --imgsize 96 --report report");
    ASSERT_EQ(result.status, 0) << result.out << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json.at("without_band").at("coverage_error"), 0.0);
    EXPECT_EQ(json.at("without_band").at("layer_error"), 0.0);
    EXPECT_EQ(json.at("all").at("edge_f_score"), 1.0);
    EXPECT_GT(json.at("without_band").at("surfaces"), 1000);
    const std::string page = folder_.read("report/report.html");
    EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos) << "the page must stand alone";
    EXPECT_TRUE(fs::exists(folder_.path("report/difference_3.png")));
    EXPECT_EQ(Json::parse(folder_.read("report/report.json")), json);
}

TEST_F(Export, LayersAreToldOneByOne) {
    const Result result = run("compare --json m.scad --imgsize 64");
    ASSERT_EQ(result.status, 0) << result.err;
    const Json layers = Json::parse(result.out).at("all").at("layers");
    // The ball sticks out of the faces of the cube, so its inside is seen: in and out on both sides.
    ASSERT_GE(layers.size(), 4u);
    EXPECT_GT(layers[0].at("pixels"), layers[3].at("pixels"));
    EXPECT_EQ(layers[0].at("coverage_error"), 0.0);
}

TEST_F(Export, ATableTellsPeopleTheSame) {
    const Result table = run("compare m.scad --imgsize 64,48 --views 2");
    ASSERT_EQ(table.status, 0) << table.err;
    const Json json = Json::parse(run("compare m.scad --imgsize 64,48 --views 2 --json").out);
    EXPECT_EQ(json.at("size"), Json({64, 48}));
    const auto says = [&](const std::string& text) {
        EXPECT_NE(table.out.find(text), std::string::npos) << text << " in:\n" << table.out;
    };
    says("m.scad against cgal: within the tolerance of 0\n");
    says(fmt::format("lists-cpu, all layers, 2 views of 64 × 48 pixels; the mesh has {} triangles",
                     json.at("mesh").at("triangles").get<int>()));
    says(fmt::format("  {}  ", json.at("all").at("surfaces").get<int>()));
    says("\nlayer, all pixels");
    says("they agree");

    folder_.write("other.scad", "cube(10);");
    ASSERT_EQ(run("other.scad -o other.stl").status, 0);
    const Result differs = run("compare m.scad --imgsize 64 --against other.stl");
    EXPECT_EQ(differs.status, 1);
    EXPECT_NE(differs.out.find("BEYOND the tolerance"), std::string::npos) << differs.out;
    for (const char* const size : {"15", "64,0", "64,64,64", "64.5", "a"}) {
        EXPECT_NE(run(std::string("compare m.scad --imgsize ") + size).err.find("--imgsize"), std::string::npos)
            << size;
    }
}

TEST_F(Export, EveryEngineIsCompared) {
    folder_.write("other.scad", "difference() { cube(10, center = true); cylinder(r = 3, h = 20, center = true); }");
    ASSERT_EQ(run("other.scad -o other.stl").status, 0);
    for (const std::string engine : {"goldfeather", "lists", "lists-cpu", "scs"}) {
        const std::string options = " --imgsize 64 --views 2 --engine " + engine;
        const Result result = run("compare --json m.scad" + options);
        ASSERT_EQ(result.status, 0) << engine << ": " << result.err;
        const Json json = Json::parse(result.out);
        EXPECT_EQ(json.at("engine"), engine);
        EXPECT_EQ(json.at("layers"), engine == "scs" ? Json(1) : Json("all"));
        EXPECT_EQ(run("compare m.scad --against other.stl" + options).status, 1) << engine;
    }
    folder_.write("hollow.scad", "rotate_extrude() translate([5, 0]) circle(2);");
    EXPECT_NE(run("compare hollow.scad --engine scs").err.find("scs needs convex leaves"), std::string::npos);
    EXPECT_EQ(run("compare m.scad --engine opencsg").status, 1);
}

TEST_F(Export, OneCameraIsOneView) {
    ASSERT_EQ(run("compare m.scad --imgsize 64 --camera 0,0,0,0,0,0,60 --projection o").status, 0);
    EXPECT_NE(run("compare m.scad --camera 0,0,0,0,0,0,60 --views 3").err.find("--views"), std::string::npos);
    EXPECT_EQ(run("compare m.scad --camera 1,2").status, 1);
}

TEST_F(Export, AgainstOpenscad) {
    if (std::system("openscad --version >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "openscad is not installed";
    }
    const Result result = run("compare --json m.scad --imgsize 64 --against openscad");
    ASSERT_EQ(result.status, 0) << result.out << result.err;
    const Json json = Json::parse(result.out).at("openscad");
    EXPECT_EQ(json.at("tree_agrees"), true);
    EXPECT_EQ(json.at("volume").at("agrees"), true);
    EXPECT_LT(json.at("volume").at("relative_difference"), 1e-5);
    if (!json.at("picture").is_null()) {
        EXPECT_LT(json.at("picture").at("coverage_error"), 0.02);
    }
}

TEST_F(Export, AnotherMeshIsFoundOut) {
    ASSERT_EQ(run("m.scad -o m.stl").status, 0);
    EXPECT_EQ(run("compare m.scad --imgsize 96 --against m.stl").status, 0);
    folder_.write("other.scad",
                  "difference() { cube(10, center = true); sphere(6.1, $fn = 24); translate([3, 3, 4]) cube(9); }\n");
    const Result result = run("compare --json other.scad --imgsize 96 --against m.stl");
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_GT(Json::parse(result.out).at("without_band").at("layer_error"), 0.01);
    EXPECT_EQ(run("compare other.scad --imgsize 96 --against m.stl --tolerance 1").status, 0);
}

/// Moves the keyword of the second corner of each facet chosen behind that of the third.
std::string turned(const std::string& stl, bool all) {
    std::string result;
    std::size_t from = 0;
    for (std::size_t loop = stl.find("outer loop"); loop != std::string::npos; loop = stl.find("outer loop", from)) {
        const std::size_t a = stl.find("vertex", loop), b = stl.find("vertex", a + 1), c = stl.find("vertex", b + 1),
                          end = stl.find("endloop", c);
        result += stl.substr(from, b - from);
        result += all || from == 0 ? stl.substr(c, end - c) + stl.substr(b, c - b) : stl.substr(b, end - b);
        from = end;
    }
    return result + stl.substr(from);
}

TEST_F(Export, ATurnedMeshIsFoundOut) {
    ASSERT_EQ(run("m.scad -o m.stl").status, 0);
    folder_.write("inside_out.stl", turned(folder_.read("m.stl"), true));
    const Result inside_out = run("compare --json m.scad --imgsize 64 --against inside_out.stl");
    EXPECT_EQ(inside_out.status, 1) << inside_out.err;
    const Json json = Json::parse(inside_out.out);
    EXPECT_EQ(json.at("without_band").at("layer_error"), 0.0);
    EXPECT_EQ(json.at("without_band").at("orientation_error"), 1.0);
    EXPECT_EQ(json.at("without_band").at("normal_error"), 1.0);
    EXPECT_EQ(json.at("volume").at("agrees"), false);
    folder_.write("die.scad", "cube(10);");
    ASSERT_EQ(run("die.scad -o die.stl").status, 0);
    folder_.write("one.stl", turned(folder_.read("die.stl"), false));
    const Result one = run("compare --json die.scad --imgsize 96 --views 6 --against one.stl");
    EXPECT_EQ(one.status, 1) << one.err;
    EXPECT_GT(Json::parse(one.out).at("without_band").at("orientation_error"), 0.0);
}

TEST_F(Export, TheVolumeOfThePictureIsThatOfTheMesh) {
    const Result result = run("compare --json m.scad --views 4 --imgsize 200");
    ASSERT_EQ(result.status, 0) << result.out << result.err;
    const Json json = Json::parse(result.out);
    const double mesh = json.at("mesh").at("volume"), picture = json.at("volume").at("picture");
    EXPECT_EQ(json.at("volume").at("agrees"), true);
    EXPECT_NEAR(picture, mesh, 0.01 * mesh);
    EXPECT_LT(json.at("volume").at("uncertainty"), 0.1 * mesh);
}

/// A box between two corners as facets of an STL; inside out where the first corner is the larger one.
std::string stl_box(const glm::dvec3& a, const glm::dvec3& b) {
    std::string text;
    constexpr int kFaces[6][4]{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& face : kFaces) {
        for (const auto& corners : {std::array{face[0], face[1], face[2]}, std::array{face[0], face[2], face[3]}}) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int i : corners) {
                text += fmt::format("vertex {} {} {}\n", (i & 1 ? b : a).x, (i & 2 ? b : a).y, (i & 4 ? b : a).z);
            }
            text += "endloop\nendfacet\n";
        }
    }
    return text;
}

/// Files of several shells, as programs that do not unite write them: pictures and meshes hold them for the same solid.
TEST_F(Export, ShellsOfAFileAreCountedByTheirWinding) {
    struct Case {
        std::string shells, cut;
        double volume;
    };
    const glm::dvec3 origin(0), ten(10);
    for (const auto& [shells, cut, volume] :
         {Case{stl_box(origin, ten) + stl_box({5, 5, 5}, {15, 15, 15}), "translate([-1, -1, 7]) cube(20)", 850},
          Case{stl_box(origin, ten) + stl_box({8, 8, 8}, {2, 2, 2}), "", 784},           // A cavity.
          Case{stl_box(origin, ten) + stl_box(origin, ten), "", 1000},                   // Twice.
          Case{stl_box(ten, origin), "", 1000},                                          // Inside out.
          Case{stl_box(origin, ten) + stl_box({2, 2, 2}, {8, 8, 8}), "", 1000},          // A shell within.
          Case{stl_box(origin, ten) + stl_box({10, 10, 0}, {12, 12, 10}), "", 1040}}) {  // An edge of four faces.
        folder_.write("shells.stl", "solid shells\n" + shells + "endsolid shells\n");
        folder_.write("shells.scad", "difference() { import(\"shells.stl\"); " + (cut.empty() ? "" : cut + ";") + "}");
        const Result result = run("compare --json shells.scad --imgsize 96 --views 4");
        EXPECT_EQ(result.status, 0) << volume << result.out;
        EXPECT_EQ(result.err, "") << volume;
        const Json json = Json::parse(result.out);
        EXPECT_NEAR(json.at("mesh").at("volume").get<double>(), volume, 1e-9);
        EXPECT_NEAR(json.at("volume").at("picture").get<double>(), volume, 0.03 * volume);
    }
}

TEST_F(Export, PictureToPicture) {
    ASSERT_EQ(run("m.scad -o m.png --imgsize 96,96 --engine lists-cpu").status, 0);
    EXPECT_EQ(run("compare m.scad --reference m.png").status, 0);
    folder_.write("other.scad", "cube(10, center = true);");
    EXPECT_EQ(run("compare other.scad --against m.png").status, 1);
}

TEST_F(Export, ComparisonsThatCannotBe) {
    EXPECT_NE(run("compare missing.scad").err.find("missing.scad"), std::string::npos);
    EXPECT_NE(run("compare m.scad --against missing.stl").err.find("missing.stl"), std::string::npos);
    folder_.write("broken.stl", "solid");
    EXPECT_NE(run("compare m.scad --against broken.stl").err.find("broken.stl"), std::string::npos);
    EXPECT_EQ(run("compare").status, 1);
    EXPECT_EQ(run("compare m.scad --views 0").status, 1);
}

}  // namespace
