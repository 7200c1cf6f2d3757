// Where in the tree, and in the text, a leaf of a scene comes from.
#include <gtest/gtest.h>

#include "csg/tree/scene.h"
#include "tests/csg/scad/evaluate_text.h"

namespace {

struct Loaded {
    explicit Loaded(const std::string& text) : run(test::run(text)) {
        EXPECT_TRUE(run.evaluation.ok) << run.console;
        scene = csg::make_scene(*run.evaluation.tree);
    }
    [[nodiscard]] const csg::Tree& tree() const { return *run.evaluation.tree; }
    /// The calls from the root down to a leaf: "name@line:column", as they are written between `begin` and `end`.
    [[nodiscard]] std::vector<std::string> calls(csg::LeafId leaf) const {
        std::vector<std::string> calls;
        for (const csg::OccurrenceId id : csg::path_to(scene, scene.leaves[leaf].occurrence)) {
            if (const csg::Statement* s = tree().statement(scene.occurrences[id].node)) {
                const csg::scad::SourceFile& source = (*run.evaluation.sources)[s->where.file];
                const std::size_t begin = source.offset(s->where.line, s->where.column);
                calls.push_back(source.text().substr(begin, source.offset(s->end_line, s->end_column) - begin) + "@" +
                                std::to_string(s->where.line) + ":" + std::to_string(s->where.column));
            }
        }
        return calls;
    }

    test::Run run;
    csg::Scene scene;
};

using Calls = std::vector<std::string>;

TEST(Occurrences, AreTheWayDownToALeaf) {
    const Loaded loaded(
        "module hole(d) {\n"
        "  translate([0, 0, -1]) cylinder(d = d, h = 9);\n"
        "}\n"
        "difference() {\n"
        "  cube(5);\n"
        "  for (i = [1:2])\n"
        "    if (i > 0) hole(d = i);\n"
        "}\n");
    ASSERT_EQ(loaded.scene.leaves.size(), 3u);
    EXPECT_EQ(loaded.calls(0), (Calls{"difference()@4:1", "cube(5)@5:3"}));
    const Calls hole{"difference()@4:1", "for (i = [1:2])@6:3",       "if (i > 0)@7:5",
                     "hole(d = i)@7:16", "translate([0, 0, -1])@2:3", "cylinder(d = d, h = 9)@2:25"};
    EXPECT_EQ(loaded.calls(1), hole);
    EXPECT_EQ(loaded.calls(2), hole);
    const auto round = [&](csg::LeafId leaf) {
        return loaded.scene.occurrences[csg::path_to(loaded.scene, loaded.scene.leaves[leaf].occurrence)[3]].child;
    };
    EXPECT_EQ(round(1), 0u);
    EXPECT_EQ(round(2), 1u);
}

TEST(Occurrences, OfASharedNodeAreApart) {
    const Loaded loaded("module twice() { children(); translate([3, 0, 0]) children(); }\ntwice() cube(1);\n");
    ASSERT_EQ(loaded.scene.leaves.size(), 2u);
    EXPECT_EQ(loaded.scene.leaves[0].node, loaded.scene.leaves[1].node) << "one node of the tree";
    EXPECT_EQ(loaded.calls(0), (Calls{"twice()@2:1", "children()@1:18", "cube(1)@2:9"}));
    EXPECT_EQ(loaded.calls(1), (Calls{"twice()@2:1", "translate([3, 0, 0])@1:30", "children()@1:51", "cube(1)@2:9"}));
}

TEST(Occurrences, OfPartsOfTheirOwnBeginAtTheRoot) {
    const Loaded loaded(
        "union() { cube(1); %sphere(2); translate([9, 0, 0]) { #cube(2); color(\"red\", 0.5) cube(3); } }");
    ASSERT_EQ(loaded.scene.parts.size(), 4u);
    for (const csg::LeafInstance& leaf : loaded.scene.leaves) {
        const auto path = csg::path_to(loaded.scene, leaf.occurrence);
        EXPECT_EQ(loaded.scene.occurrences[path.front()].node, loaded.tree().root());
        EXPECT_EQ(loaded.scene.occurrences[path.back()].node, leaf.node);
        for (std::size_t i = 1; i < path.size(); ++i) {
            const csg::Occurrence& step = loaded.scene.occurrences[path[i]];
            EXPECT_EQ(loaded.tree().children(loaded.scene.occurrences[path[i - 1]].node)[step.child], step.node);
        }
    }
}

TEST(Occurrences, StatementsOfElseIfAreKnown) {
    const Loaded loaded("x = 2;\nif (x == 1) cube(1);\nelse if (x == 2) sphere(1);\nelse cylinder();\n");
    ASSERT_EQ(loaded.scene.leaves.size(), 1u);
    EXPECT_EQ(loaded.calls(0), (Calls{"if (x == 1)@2:1", "if (x == 2)@3:6", "sphere(1)@3:18"}));
}

TEST(Occurrences, BytesAreCountedInTheText) {
    // Umlauts have two bytes; lines end in either way.
    const Loaded loaded("// ä\r\n/* ö */ cube(\r\n  1);\rsphere(2);\n");
    ASSERT_EQ(loaded.scene.leaves.size(), 2u);
    EXPECT_EQ(loaded.calls(0), (Calls{"cube(\r\n  1)@2:10"}));
    EXPECT_EQ(loaded.calls(1), (Calls{"sphere(2)@4:1"}));
}

TEST(Occurrences, UserModulesAreTold) {
    const Loaded loaded("module box() cube(1);\nbox();\nunion() box();\n");
    for (const csg::Statement& statement : loaded.tree().statements()) {
        EXPECT_EQ(statement.user_module, statement.name == "box") << statement.name;
    }
    EXPECT_EQ(loaded.tree().statements().size(), 4u);
}

/// Equal hashes alone are no equal nodes.
TEST(Sharing, GoesByContents) {
    csg::TreeBuilder builder;
    const csg::SourceLocation where{0, 1, 1};
    const auto polygon = [](double x) {
        return std::make_shared<const csg::Polygon>(csg::Polygon{{{0, 0}, {x, 0}, {0, 1}}, {}});
    };
    EXPECT_EQ(builder.leaf(polygon(1), where), builder.leaf(polygon(1), where)) << "two copies of one shape";
    EXPECT_NE(builder.leaf(polygon(1), where), builder.leaf(polygon(2), where));
    // No $fe, and $fe = 0, have one hash.
    csg::Sphere sphere, by_error;
    by_error.fineness.fe = 0;
    EXPECT_EQ(csg::content_hash(sphere), csg::content_hash(by_error));
    EXPECT_NE(builder.leaf(sphere, where), builder.leaf(by_error, where));
    EXPECT_EQ(builder.leaf(sphere, where), builder.leaf(sphere, where));
}

}  // namespace
