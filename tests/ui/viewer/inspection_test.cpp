// What the window's panel of inspections finds, without the window.
#include "ui/viewer/inspection.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "ui/pipeline/inspection/sight_finder.h"
#include "ui/viewer/inspection_panel.h"
#include "ui/viewer/session.h"

namespace ui {
namespace {

using namespace std::chrono_literals;

constexpr const char* kBox =
    "module box() difference() {\n"
    "    cube([40, 30, 12]);\n"
    "    translate([0.4, 2, 2]) cube([36, 26, 20]);\n"
    "}\n"
    "module lid() translate([0, 0, 14]) cube([40, 30, 2]);\n"
    "box();\n"
    "lid();\n";

class InspectionTest : public testing::Test {
  protected:
    void open(const std::string& text) {
        Source source;
        source.path = "box.scad";
        source.text = text;
        document_ = std::make_unique<Document>(source);
        evaluate();
    }
    void evaluate() { document_->receive(make_evaluate()(document_->source(), {}, {})); }

    void ask(const InspectionCommand& command) {
        ASSERT_TRUE(inspection_.perform(command, *document_, {}));
        for (int i = 0; i < 20'000 && !inspection_.update(); ++i) {
            std::this_thread::sleep_for(1ms);
        }
        ASSERT_EQ(inspection_.task(), "");
    }
    RunChecks walls() const {
        RunChecks checks;
        checks.request.min_wall = 0.8;
        checks.request.spacing = 0.5;
        return checks;
    }

    std::unique_ptr<Document> document_;
    Inspection inspection_{make_evaluate(), [] {}};
};

TEST_F(InspectionTest, AFindingLeadsToItsPlaceItsCallAndItsLeaf) {
    open(kBox);
    ask(walls());
    const auto& checks = inspection_.checks();
    ASSERT_TRUE(checks.has_value());
    ASSERT_EQ(checks->error, "");
    ASSERT_EQ(checks->findings.size(), 1U);
    const InspectedPlace place = inspection_.finding(0, *document_);
    EXPECT_EQ(place.headline, "thin wall, 0.4 mm, limit 0.8");
    EXPECT_TRUE(place.place == "box.scad:2" || place.place == "box.scad:3") << place.place;
    ASSERT_NE(place.text.text, nullptr);
    EXPECT_EQ(place.text.range.line, place.place == "box.scad:2" ? 2U : 3U);
    EXPECT_NEAR(place.value, 0.4, 1e-9);
    ASSERT_NE(place.occurrence, csg::kNoOccurrence);
    const auto steps = steps_to(*document_->model(), place.occurrence);
    EXPECT_EQ(steps.back().node.where.line, place.text.range.line) << "in the model that is shown";
}

TEST_F(InspectionTest, OccurrencesAreFoundAgainInAnotherModel) {
    open("for (i = [0:2]) translate([20 * i, 0, 0]) difference() { cube(10); translate([0.3, 1, 1]) cube(8); }");
    ask(walls());
    ASSERT_EQ(inspection_.checks()->findings.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const InspectedPlace place = inspection_.finding(i, *document_);
        ASSERT_NE(place.occurrence, csg::kNoOccurrence);
        for (const csg::LeafInstance& leaf : document_->model()->scene.leaves) {
            if (leaf.occurrence == place.occurrence) {
                EXPECT_LE(std::abs(leaf.to_world[3].x - place.point.x), 10.0) << "that of the same turn of the loop";
            }
        }
    }
    open("sphere(3);");
    EXPECT_EQ(inspection_.finding(0, *document_).occurrence, csg::kNoOccurrence);
}

TEST_F(InspectionTest, AnUnknownPartIsToldWithTheNearestNames) {
    open(kBox);
    RunChecks checks;
    checks.request.clearances = {{"box", "lit", 5}};
    checks.parts = {csg::PartRule::Kind::Depth, 1, {}};
    ask(checks);
    EXPECT_NE(inspection_.checks()->error.find("lid"), std::string::npos) << inspection_.checks()->error;
    checks.request.clearances = {{"box", "lid", 5}};
    ask(checks);
    EXPECT_EQ(inspection_.checks()->error, "");
    ASSERT_EQ(inspection_.checks()->findings.size(), 1U);
    EXPECT_NEAR(inspection_.checks()->findings[0].value, 2, 1e-9);
}

TEST_F(InspectionTest, ErrorsAndEmptyModelsAreTold) {
    open("cube(3");
    ask(walls());
    EXPECT_NE(inspection_.checks()->error, "");
    open("");
    ask(walls());
    EXPECT_EQ(inspection_.checks()->error, "the model is empty");
    open("square(3);");
    ask(walls());
    EXPECT_NE(inspection_.checks()->error.find("outline"), std::string::npos) << inspection_.checks()->error;
}

TEST_F(InspectionTest, MeasuresArePartByPart) {
    open(kBox);
    ask(RunMeasures{{csg::PartRule::Kind::Depth, 1, {}}, 0.01});
    const auto& answer = inspection_.measures();
    ASSERT_TRUE(answer.has_value());
    ASSERT_EQ(answer->names, (std::vector<std::string>{"box", "lid"}));
    const double box = 40 * 30 * 12 - 36 * 26 * 10, lid = 40 * 30 * 2;
    const auto near = [](const BoundedValue& q, double value) {
        EXPECT_NEAR(q.value, value, q.error);
        EXPECT_LE(q.error, 0.02 * q.value);
    };
    near(answer->measures.all.volume, box + lid);
    near(answer->measures.parts[0].volume, box);
    near(answer->measures.parts[1].volume, lid);
    const std::string text = text_of(*answer);
    EXPECT_NE(text.find("lid\n  Volume    2400"), std::string::npos) << text;
}

TEST_F(InspectionTest, ChangesAreThoseSinceTheBaseline) {
    open(kBox);
    EXPECT_EQ(document_->first_tree(), document_->tree());
    Source source = document_->source();
    source.before = Baseline{"it was opened", document_->first_tree(), {}};
    source.text = std::string(kBox).replace(std::string(kBox).find("30, 2]"), 6, "30, 3]");
    document_ = std::make_unique<Document>(source);
    evaluate();
    ASSERT_NE(document_->model(), nullptr);
    EXPECT_EQ(document_->model()->scene.parts.size(), 2U) << "what has stayed is seen through, what is new is not";
    ask(RunPartChanges{{csg::PartRule::Kind::Depth, 1, {}}});
    const auto& parts = inspection_.changes()->parts;
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].kind, PartChange::Kind::Unchanged);
    EXPECT_EQ(parts[1].kind, PartChange::Kind::Changed);
    EXPECT_NEAR(parts[1].added.volume, 40 * 30 * 1, 1e-6);
    EXPECT_EQ(parts[1].removed.volume, 0);
}

TEST_F(InspectionTest, ABaselineThatIsNoFileIsAnError) {
    open(kBox);
    document_->compare(Baseline{"gone.scad", nullptr, "/nowhere/gone.scad"});
    evaluate();
    EXPECT_EQ(document_->state(), DocumentState::Failed);
    EXPECT_NE(document_->trouble().find("gone.scad"), std::string::npos) << document_->trouble();
    document_->compare(std::nullopt);
    evaluate();
    EXPECT_EQ(document_->state(), DocumentState::Good);
}

TEST_F(InspectionTest, ATaskIsGivenUp) {
    open("for (i = [0:99]) translate([i, 0, 0]) sphere(3, $fn = 100);");
    RunChecks checks = walls();
    checks.request.spacing = 0.005;
    ASSERT_TRUE(inspection_.perform(checks, *document_, {}));
    EXPECT_EQ(inspection_.task(), "check");
    std::this_thread::sleep_for(50ms);
    ASSERT_TRUE(inspection_.perform(CancelInspection{}, *document_, {}));
    EXPECT_EQ(inspection_.task(), "");
    std::this_thread::sleep_for(50ms);
    EXPECT_FALSE(inspection_.update());
    EXPECT_FALSE(inspection_.checks().has_value());
}

TEST_F(InspectionTest, AnEyeIsFoundThatSeesThePlace) {
    open("difference() { cube(20, center = true); translate([0, 0, -15]) cube([10, 10, 20], center = true); }");
    SightFinder sight(document_->model());
    const glm::dvec3 above(0, 0, 1);
    EXPECT_EQ(sight.from({0, 0, 10}, above), above) << "it is seen as it is";
    const glm::dvec3 from = sight.from({0, 0, -5}, above);  // The ground of the bore, which opens downwards.
    EXPECT_LT(from.z, -0.5) << glm::length(from);
    EXPECT_NEAR(glm::length(from), 1, 1e-12);
}

}  // namespace
}  // namespace ui
