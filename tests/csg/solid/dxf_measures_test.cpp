#include "csg/solid/dxf_measures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace csg::solid;

std::string section(const std::string& entities) {
    return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

/// Definition points: 13 at (1, 2), 14 at (4, 6), 15 at (1, 5), 10 at (1, 1).
std::string dimension(int type, const std::string& name, double angle = 0) {
    return fmt::format(
        "0\nDIMENSION\n8\nsizes\n1\n{}\n70\n{}\n50\n{}\n"
        "10\n1\n20\n1\n13\n1\n23\n2\n14\n4\n24\n6\n15\n1\n25\n5\n",
        name, type, angle);
}

std::string line(double x, double y, double to_x, double to_y) {
    return fmt::format("0\nLINE\n8\nlines\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", x, y, to_x, to_y);
}

TEST(DxfMeasures, EveryKindOfDimension) {
    std::string text;
    for (const auto& [name, type, angle] :
         {std::tuple("horizontal", 0, 0.0), std::tuple("vertical", 0, 90.0), std::tuple("aligned", 1, 0.0),
          std::tuple("angle", 2, 0.0), std::tuple("diameter", 3, 0.0), std::tuple("radius", 4, 0.0),
          std::tuple("three", 5, 0.0), std::tuple("x", 6 + 64, 0.0), std::tuple("y", 6, 0.0)}) {
        text += dimension(type, name, angle);
    }
    const DxfFile file = read_dxf_file(section(text));
    csg::Import import;
    const auto value = [&](const char* name) { return dxf_dimension(file, import, name, "a.dxf").value; };
    EXPECT_DOUBLE_EQ(value("horizontal").value(), 3);
    EXPECT_DOUBLE_EQ(value("vertical").value(), 4);
    EXPECT_DOUBLE_EQ(value("aligned").value(), 5);
    EXPECT_NEAR(value("angle").value(), 90 + 53.130102, 1e-6);  // From down to the slope of 4 in 3.
    EXPECT_DOUBLE_EQ(value("diameter").value(), 4);
    EXPECT_DOUBLE_EQ(value("radius").value(), 4);
    EXPECT_DOUBLE_EQ(value("x").value(), 1);
    EXPECT_DOUBLE_EQ(value("y").value(), 2);
    EXPECT_DOUBLE_EQ(value("").value(), 3);  // The first.
    EXPECT_EQ(dxf_dimension(file, import, "three", "a.dxf").problem,
              "Dimension 'three' in 'a.dxf', layer '' has unsupported type!");
    EXPECT_EQ(dxf_dimension(file, import, "none", "a.dxf").problem,
              "Can't find dimension 'none' in 'a.dxf', layer ''!");
    import.scale = 2;
    import.origin = {1, 1};
    EXPECT_DOUBLE_EQ(value("aligned").value(), 10);
    EXPECT_DOUBLE_EQ(value("y").value(), 2);
    import.layer = "other";
    EXPECT_FALSE(value("aligned"));
}

TEST(DxfMeasures, CrossOfTheFirstTwoLinesThatStandAlone) {
    csg::Import import;
    Remarks remarks;
    const DxfFile file = read_dxf_file(
        section(line(9, 9, 10, 10) + line(10, 10, 11, 9) + line(0, 0, 4, 4) + line(0, 4, 2, 2.5) + line(7, 0, 8, 0)));
    const auto found = dxf_cross(file, import, "a.dxf", remarks).value;
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, 16.0 / 7, 1e-12);  // Of the lines drawn on: they need not reach each other.
    EXPECT_NEAR(found->y, 16.0 / 7, 1e-12);
    import.layer = "none";
    EXPECT_EQ(dxf_cross(file, import, "a.dxf", remarks).problem, "Can't find cross in 'a.dxf', layer 'none'!");
    const DxfFile parallel = read_dxf_file(section(line(0, 0, 1, 1) + line(1, 0, 2, 1)));
    EXPECT_FALSE(dxf_cross(parallel, csg::Import(), "a.dxf", remarks).value);
    EXPECT_TRUE(remarks.warnings.empty() && remarks.failures.empty());
}

TEST(DxfMeasures, WhatCannotBeDrawnIsCounted) {
    Remarks remarks;
    csg::Import import;
    import.file.shown = "a.dxf";
    (void)draw_dxf(read_dxf_file(section("0\nLEADER\n8\n0\n0\nLEADER\n8\n0\n")), import, remarks);
    ASSERT_EQ(remarks.warnings.size(), 1U);
    EXPECT_EQ(remarks.warnings[0], "Unsupported DXF Entity 'LEADER' (2) in \"a.dxf\".");
}

}  // namespace
