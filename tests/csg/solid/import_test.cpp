// Files of every format with the same solid or outline in them; and files that lie.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>

#include "csg/solid/files.h"
#include "csg/solid/import_mesh.h"
#include "csg/solid/import_outline.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace csg::solid;

double volume(const FileMesh& mesh) {
    double six = 0;
    for (const auto& face : mesh.faces) {
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            six += glm::dot(mesh.points[face[0]], glm::cross(mesh.points[face[i]], mesh.points[face[i + 1]]));
        }
    }
    return six / 6;
}

constexpr glm::dvec3 kCorners[4]{{0, 0, 0}, {6, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // Volume 1.
constexpr int kFaces[4][3]{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string ascii_stl() {
    std::string text = "solid a\n";
    for (const auto& face : kFaces) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const int i : face) {
            text += "  vertex " + std::to_string(kCorners[i].x) + " " + std::to_string(kCorners[i].y) + " " +
                    std::to_string(kCorners[i].z) + "\n";
        }
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid a\n";
}

std::string binary_stl(std::uint32_t claimed) {
    std::string text(80, 's');
    text.append(reinterpret_cast<const char*>(&claimed), 4);
    for (const auto& face : kFaces) {
        text.append(12, '\0');
        for (const int i : face) {
            for (int k = 0; k < 3; ++k) {
                const float f = static_cast<float>(kCorners[i][k]);
                text.append(reinterpret_cast<const char*>(&f), 4);
            }
        }
        text.append(2, '\0');
    }
    return text;
}

using Reader = void (*)(std::string_view, FileMesh&, std::vector<std::string>&);

FileMesh read_with(Reader reader, const std::string& text, bool warns = false) {
    FileMesh mesh;
    std::vector<std::string> warnings;
    reader(text, mesh, warnings);
    EXPECT_EQ(!warnings.empty(), warns) << text.substr(0, 60) << (warnings.empty() ? "" : warnings[0]);
    for (const auto& face : mesh.faces) {
        for (const std::uint32_t i : face) {
            EXPECT_LT(i, mesh.points.size());
        }
    }
    return mesh;
}

TEST(Import, TheSameSolidFromEveryFormat) {
    const std::string off = "OFF\n# a comment\n4 4 6\n0 0 0\n6 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    const std::string obj =
        "# a\nv 0 0 0\nv 6 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1/1 2/2 4/3\nf -4 -1 -2\nf 2//1 3//1 4//1\n";
    const std::string amf =
        "<?xml version='1.0'?><amf unit='millimeter'><object id='0'><mesh><vertices>"
        "<vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex>"
        "<vertex><coordinates><x>6</x><y>0</y><z>0</z></coordinates></vertex>"
        "<vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates></vertex>"
        "<vertex><coordinates><x>0</x><y>0</y><z>1</z></coordinates></vertex></vertices><volume>"
        "<triangle><v1>0</v1><v2>2</v2><v3>1</v3></triangle><triangle><v1>0</v1><v2>1</v2><v3>3</v3></triangle>"
        "<triangle><v1>0</v1><v2>3</v2><v3>2</v3></triangle><triangle><v1>1</v1><v2>2</v2><v3>3</v3></triangle>"
        "</volume></mesh></object></amf>";
    EXPECT_NEAR(volume(read_with(read_stl, ascii_stl())), 1, 1e-12);
    EXPECT_NEAR(volume(read_with(read_stl, binary_stl(4))), 1, 1e-12);
    EXPECT_NEAR(volume(read_with(read_off, off)), 1, 1e-12);
    EXPECT_NEAR(volume(read_with(read_off, off.substr(4))), 1, 1e-12) << "the word may be missing";
    EXPECT_TRUE(read_with(read_off, "off" + off.substr(3), true).faces.empty());
    EXPECT_NEAR(volume(read_with(read_obj, obj)), 1, 1e-12);
    EXPECT_NEAR(volume(read_with(read_amf, amf)), 1, 1e-12);
}

std::string model_3mf(const std::string& objects, const std::string& items) {
    return "<?xml version='1.0'?><model unit='millimeter'><resources>" + objects + "</resources><build>" + items +
           "</build></model>";
}
const std::string kTriangle3mf =
    "<object id='1'><mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/>"
    "<vertex x='0' y='1' z='0'/></vertices><triangles><triangle v1='0' v2='1' v3='2'/></triangles></mesh></object>";

TEST(Import, ComponentsOfA3mfModel) {
    const auto read = [](const std::string& text) { return read_with(read_3mf_model, text).faces.size(); };
    const std::string two =
        "<object id='2'><components><component objectid='1'/>"
        "<component objectid='1' transform='1 0 0 0 1 0 0 0 1 5 0 0'/></components></object>";
    EXPECT_EQ(read(model_3mf(kTriangle3mf + two, "<item objectid='2'/><item objectid='1'/>")), 3U);
}

TEST(Import, ComponentsWithoutEnd) {
    const auto warning = [](const std::string& text) {
        FileMesh mesh;
        std::vector<std::string> warnings;
        read_3mf_model(text, mesh, warnings);
        return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
    };
    const std::string itself =
        "<object id='2'><components><component objectid='1'/><component objectid='2'/>"
        "<component objectid='2'/></components></object>";
    EXPECT_THAT(warning(model_3mf(kTriangle3mf + itself, "<item objectid='2'/>")),
                testing::HasSubstr("a component of itself"));
    std::string doubled = kTriangle3mf, chain = kTriangle3mf;
    for (int i = 2; i < 60; ++i) {
        const std::string one = "<component objectid='" + std::to_string(i - 1) + "'/>";
        const std::string head = "<object id='" + std::to_string(i) + "'><components>";
        chain += head + one + "</components></object>";
        doubled += head + one + one + "</components></object>";
    }
    EXPECT_THAT(warning(model_3mf(chain, "<item objectid='59'/>")), testing::HasSubstr("deeper than 32"));
    EXPECT_THAT(warning(model_3mf(doubled, "<item objectid='25'/>")),
                testing::HasSubstr("more than 100000 components"));
}

TEST(Import, CountsAreNotBelieved) {
    EXPECT_EQ(read_with(read_stl, binary_stl(0xfffffff0U), true).faces.size(), 4u);
    EXPECT_EQ(read_with(read_off, "OFF\n4000000000 4000000000 0\n0 0 0\n", true).points.size(), 1u);
    EXPECT_TRUE(read_with(read_off, "OFF\n1 1 0\n0 0 0\n4000000000 0 1 2\n", true).faces[0].size() <= 1);
    EXPECT_TRUE(read_with(read_obj, "v 0 0 0\nf 1 2 99999999999 -7 x\n", true).faces[0].size() == 1);
}

TEST(Import, RubbishGivesNothing) {
    for (const std::string& text :
         {std::string(), std::string("\0\1\2", 3), std::string(1000, '\xff'),
          std::string("solid\nvertex vertex vertex nan inf 1e999"), std::string("<amf><mesh>"),
          std::string("<!DOCTYPE a [<!ENTITY b 'c'>]><amf>&b;</amf>")}) {
        for (const Reader reader : {Reader{read_stl}, Reader{read_off}, Reader{read_obj}, Reader{read_amf}}) {
            FileMesh mesh;
            std::vector<std::string> warnings;
            reader(text, mesh, warnings);
            EXPECT_TRUE(mesh.faces.empty());
        }
        Remarks remarks;
        EXPECT_TRUE(read_dxf(text, {}, remarks).empty());
        EXPECT_TRUE(read_svg(text, {}, remarks).empty());
    }
}

/// Bytes of good files changed, cut and doubled at random: every reader comes to an end, and its faces have corners.
TEST(Import, SurvivesMutations) {
    std::mt19937 random(11);
    const std::string seeds[]{
        ascii_stl(),
        binary_stl(4),
        "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 -2/2 3\n",
        "<amf><object><mesh><vertex><x>1</x></vertex><triangle><v1>0</v1><v2>0</v2><v3>0</v3></triangle></mesh></"
        "object></amf>",
        "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nINSERT\n2\na\n41\n2\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\n"
        "ENTITIES\n0\nINSERT\n2\na\n0\nELLIPSE\n10\n1\n11\n5\n40\n0.5\n41\n0\n42\n6."
        "28\n0\nARC\n40\n3\n50\n10\n51\n80\n",
        "<svg viewBox='0 0 9 9' width='9cm'><g transform='rotate(3 4 5) skewX(9)'><path d='M1 1c2 3 4 5 6 7s3 4 5 6q1 "
        "2 3 "
        "4t5 6a3 4 5 1 0 6 7h3v4z'/><rect width='3' height='4' rx='1'/></g></svg>"};
    for (int round = 0; round < 20'000; ++round) {
        std::string text = seeds[static_cast<std::size_t>(round) % std::size(seeds)];
        for (auto k = random() % 6; k-- > 0;) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random());
                    break;
                case 1:
                    text.erase(at, random() % 9);
                    break;
                case 2:
                    text.insert(at, text.substr(random() % text.size(), random() % 30));
                    break;
                default:
                    text.insert(at, "-9e99");
            }
            if (text.empty()) {
                text.push_back(' ');
            }
        }
        for (const Reader reader : {Reader{read_stl}, Reader{read_off}, Reader{read_obj}, Reader{read_amf}}) {
            FileMesh mesh;
            std::vector<std::string> warnings;
            reader(text, mesh, warnings);
            for (const auto& face : mesh.faces) {
                for (const std::uint32_t i : face) {
                    ASSERT_LT(i, mesh.points.size()) << text;
                }
            }
        }
        Remarks remarks;
        for (const auto& read : {std::function([&] { (void)clean(read_dxf(text, {}, remarks), FillRule::EvenOdd); }),
                                 std::function([&] { (void)read_svg(text, {}, remarks); })}) {
            try {
                read();
            } catch (const OutlineError&) {
                continue;  // Coordinates beyond what can be worked with: an answer, too.
            }
        }
    }
}

double dxf_area(const std::string& entities) {
    Remarks remarks;
    const auto loops = read_dxf("0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n", {}, remarks);
    EXPECT_TRUE(remarks.warnings.empty() && remarks.failures.empty());
    return clean(loops, FillRule::EvenOdd).area();
}

TEST(Import, DxfEntities) {
    // A square of four lines in no order, one of them backwards.
    EXPECT_NEAR(dxf_area("0\nLINE\n10\n0\n20\n0\n11\n2\n21\n0\n0\nLINE\n10\n2\n20\n2\n11\n0\n21\n2\n"
                         "0\nLINE\n10\n2\n20\n2\n11\n2\n21\n0\n0\nLINE\n10\n0\n20\n2\n11\n0\n21\n0\n"),
                4, 1e-9);
    EXPECT_NEAR(dxf_area("0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n3\n20\n0\n10\n3\n20\n2\n"), 3, 1e-9);
    // Two lines that meet, begun in the middle: the third side closes them.
    EXPECT_NEAR(dxf_area("0\nLINE\n10\n4\n20\n0\n11\n4\n21\n3\n0\nLINE\n10\n4\n20\n0\n11\n0\n21\n0\n"), 6, 1e-9);
    // Two half circles of radius 10: 30 segments.
    EXPECT_NEAR(dxf_area("0\nLWPOLYLINE\n70\n1\n10\n-10\n20\n0\n42\n1\n10\n10\n20\n0\n42\n1\n"),
                0.5 * 100 * 30 * std::sin(12 * 3.14159265358979 / 180), 1e-6);
    // The same as an old polyline, and a control point of a spline's frame between, which counts for nothing.
    EXPECT_NEAR(dxf_area("0\nPOLYLINE\n66\n1\n70\n1\n0\nVERTEX\n10\n-10\n20\n0\n42\n1\n"
                         "0\nVERTEX\n70\n16\n10\n99\n20\n99\n0\nVERTEX\n10\n10\n20\n0\n42\n1\n0\nSEQEND\n"),
                0.5 * 100 * 30 * std::sin(12 * 3.14159265358979 / 180), 1e-6);
    EXPECT_NEAR(dxf_area("0\nCIRCLE\n10\n5\n20\n5\n40\n10\n"), 0.5 * 100 * 30 * std::sin(12 * 3.14159265358979 / 180),
                1e-6);
}

TEST(Import, DxfJoinsLinesInAnyOrderAndDirectionInLinearTime) {
    // Twenty thousand lines that go out from one point and come back: no line is looked at again and again.
    std::string spokes;
    for (int i = 0; i < 20'000; ++i) {
        const double angle = i * 1e-4;
        spokes +=
            fmt::format("0\nLINE\n10\n0\n20\n0\n11\n{}\n21\n{}\n", 1000 * std::cos(angle), 1000 * std::sin(angle));
    }
    Remarks remarks;
    const auto begin = std::chrono::steady_clock::now();
    const auto loops = read_dxf("0\nSECTION\n2\nENTITIES\n" + spokes + "0\nENDSEC\n0\nEOF\n", {}, remarks);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
    EXPECT_EQ(loops.size(), 10'000U);  // Two at a time: out, and in from the other end.
}

TEST(Import, DxfBlocksThatInsertThemselves) {
    Remarks remarks;
    const std::string insert = "0\nINSERT\n2\na\n10\n2\n20\n0\n";
    const auto loops =
        read_dxf("0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nCIRCLE\n10\n0\n20\n0\n40\n1\n" + insert + insert +
                     "0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + insert + "0\nENDSEC\n0\nEOF\n",
                 {}, remarks);
    EXPECT_EQ(loops.size(), 1U);
    EXPECT_EQ(remarks.failures, std::vector<std::string>{"DXF block 'a' inserts itself"});
}

TEST(Import, DxfCoordinatesBeyondAllNumbers) {
    Remarks remarks;
    const auto loops = read_dxf(
        "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nLINE\n10\n1e200\n20\n0\n11\n2\n21\n1e200\n0\nENDBLK\n0\nENDSEC\n"
        "0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\na\n41\n1e200\n42\n-1e200\n50\n30\n0\nENDSEC\n0\nEOF\n",
        {}, remarks);
    EXPECT_TRUE(loops.empty());
    EXPECT_EQ(remarks.failures.size(), 1U);
}

TEST(Import, DxfPolylinesOfOtherLayersAreLeftOut) {
    csg::Import import;
    import.layer = "wanted";
    const auto triangle = [](const std::string& layer) {
        return "0\nPOLYLINE\n8\n" + layer + "\n66\n1\n70\n1\n0\nVERTEX\n8\n" + layer +
               "\n10\n0\n20\n0\n0\nVERTEX\n10\n1\n20\n0\n0\nVERTEX\n10\n0\n20\n1\n0\nSEQEND\n8\n" + layer + "\n";
    };
    Remarks remarks;
    const std::string text = "0\nSECTION\n2\nENTITIES\n" + triangle("other") + triangle("wanted") + triangle("third") +
                             "0\nENDSEC\n0\nEOF\n";
    EXPECT_EQ(read_dxf(text, import, remarks).size(), 1U);
    EXPECT_EQ(read_dxf(text, {}, remarks).size(), 3U);
}

TEST(Import, OutlinesThatWouldTakeHoursAreAnError) {
    // A hundred thousand slanted squares, each a little aside of the last.
    std::vector<Loop> loops;
    for (int i = 0; i < 100'000; ++i) {
        const double x = i * 1e-3;
        loops.push_back({{x, 0}, {x + 50, 1}, {x + 51, 50}, {x + 1, 49}});
    }
    EXPECT_THROW((void)clean(loops, FillRule::NonZero), OutlineError);
    // As many apart from each other are none.
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const glm::dvec2 shift{static_cast<double>(i % 300) * 200, static_cast<double>(i / 300) * 200};
        loops[i] = {shift, shift + glm::dvec2(1, 0), shift + glm::dvec2(1, 1)};
    }
    EXPECT_NEAR(clean(loops, FillRule::NonZero).area(), 50'000, 1e-3);
}

/// Circles have as many corners as they ask for after import()'s scale, but those in blocks.
TEST(Import, DxfCirclesAreAsFineAsTheyGetLarge) {
    const auto corners = [](const std::string& text, double scale) {
        Remarks remarks;
        csg::Import import;
        import.scale = scale;
        const auto loops = read_dxf(text, import, remarks);
        return loops.size() == 1 ? loops[0].size() : 0;
    };
    const std::string circle = "0\nCIRCLE\n10\n0\n20\n0\n40\n2\n";
    const std::string entities = "0\nSECTION\n2\nENTITIES\n" + circle + "0\nENDSEC\n";
    const std::string blocks = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n" + circle +
                               "0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\na\n0\nENDSEC\n";
    EXPECT_EQ(corners(entities, 1), 7u);
    EXPECT_EQ(corners(entities, 4), 26u);
    EXPECT_EQ(corners(blocks, 4), 7u);
}

/// Two triangles that meet in a corner are one chain; a chain with a free end begins there.
TEST(Import, DxfChainsGoOnThroughTheirBeginning) {
    const auto loops_of = [](const std::vector<std::array<int, 4>>& lines) {
        std::string text = "0\nSECTION\n2\nENTITIES\n";
        for (const auto& [x0, y0, x1, y1] : lines) {
            text += fmt::format("0\nLINE\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", x0, y0, x1, y1);
        }
        Remarks remarks;
        return read_dxf(text + "0\nENDSEC\n", {}, remarks);
    };
    const auto bow =
        loops_of({{0, 0, 2, 1}, {2, 1, 2, -1}, {2, -1, 0, 0}, {0, 0, -2, 1}, {-2, 1, -2, -1}, {-2, -1, 0, 0}});
    ASSERT_EQ(bow.size(), 1u);
    EXPECT_EQ(bow[0].size(), 6u);
    // Corners 0 and 2 of a square with a diagonal have three lines each: the chain ends at one of them without its
    // start.
    const auto diagonal = loops_of({{0, 0, 2, 0}, {2, 0, 2, 2}, {2, 2, 0, 2}, {0, 2, 0, 0}, {0, 0, 2, 2}});
    ASSERT_EQ(diagonal.size(), 1u);
    EXPECT_EQ(diagonal[0].size(), 5u);
    EXPECT_EQ(diagonal[0].back(), glm::dvec2(0, 0));
    const auto open = loops_of({{2, 0, 2, 2}, {2, 2, 0, 2}, {0, 0, 2, 0}});
    ASSERT_EQ(open.size(), 1u);
    EXPECT_EQ(open[0].front(), glm::dvec2(0, 2));
    EXPECT_EQ(open[0].back(), glm::dvec2(0, 0));
}

/// As in OpenSCAD the bottom lies 1 below the lowest value that the file has, but not above 0; missing values are 0.
TEST(Import, TheBottomOfASurface) {
    const test_support::TemporaryFolder folder;
    const auto box_of = [&](const std::string& table) {
        csg::Surface surface;
        surface.file.path = folder.write("a.dat", table);
        return surface_solid(surface)->box;
    };
    EXPECT_EQ(box_of("5 6\n7 8\n").lo.z, 0);
    EXPECT_EQ(box_of("0 6\n7 8\n").lo.z, -1);
    EXPECT_EQ(box_of("-3 6\n7 8\n").lo.z, -4);
    EXPECT_EQ(box_of("2 6\n7\n").lo.z, 0);
    EXPECT_EQ(box_of("2 6\n7\n").hi.z, 7);
}

double svg_area(const std::string& body, const std::string& head = "width='100mm' height='50mm' viewBox='0 0 100 50'") {
    Remarks remarks;
    csg::Import import;
    import.fineness.fn = 4;
    const Outline outline =
        read_svg("<svg xmlns='http://www.w3.org/2000/svg' " + head + ">" + body + "</svg>", import, remarks);
    EXPECT_TRUE(remarks.warnings.empty() && remarks.failures.empty());
    return outline.area();
}

TEST(Import, SvgShapes) {
    EXPECT_NEAR(svg_area("<rect x='1' y='2' width='3' height='4'/>"), 12, 1e-9);
    EXPECT_NEAR(svg_area("<circle cx='5' cy='5' r='2'/>"), 80 * std::sin(9 * 3.14159265358979 / 180), 1e-9)
        << "40 corners at least";
    EXPECT_NEAR(svg_area("<polygon points='0,0 4,0 4,3'/>"), 6, 1e-9);
    EXPECT_NEAR(svg_area("<path d='M1 1h4v3H1zm1 1v1h1v-1z' fill-rule='evenodd'/>"), 11, 1e-9);
    EXPECT_NEAR(svg_area("<path d='m1-1l2 0 0,2-2 0z'/>"), 4, 1e-9);
    EXPECT_NEAR(svg_area("<g transform='scale(2) translate(3,4)'><rect width='1' height='1'/></g>"), 4, 1e-9);
    EXPECT_NEAR(svg_area("<defs><rect width='9' height='9'/></defs><rect width='1' height='1'/>"), 1, 1e-9);
    EXPECT_NEAR(svg_area("<rect width='72' height='72'/>", "width='100' height='100'"), 72 * 72, 1e-6);
    EXPECT_NEAR(svg_area("<rect width='72' height='72'/>", "width='100' height='100' viewBox='0 0 100 100'"),
                25.4 * 25.4, 1e-6);
    EXPECT_NEAR(svg_area("<rect width='10' height='10'/>", "width='200mm' height='100mm' viewBox='0 0 100 50'"), 400,
                1e-9);
    EXPECT_NEAR(svg_area("<path d='M0 0 A 2 2 0 0 1 4 0 z'/>"), 8, 4);
}

}  // namespace
