// What csgscope check finds: defects of known size, all of them and nothing else; overhangs and sizes by closed forms.
#include "ui/pipeline/inspection/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tests/csg/scad/evaluate_text.h"
#include "tests/ui/pipeline/seeded_defects.h"
#include "ui/pipeline/inspection/face_samples.h"

namespace ui {
namespace {

constexpr double kSpacing = 1;

std::shared_ptr<const Model> model_of(const std::string& text, bool parts = true) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    ModelBuilder builder;
    builder.show(csg::Showing::Result);
    if (parts) {
        builder.divide({csg::PartRule::Kind::Depth, 1, {}});
    }
    return builder.build(run.evaluation.tree);
}

CheckRequest everything() {
    CheckRequest request;
    request.min_wall = test::kLeastWall;
    request.min_gap = test::kLeastGap;
    request.min_feature = test::kLeastFeature;
    request.interference = 0;
    request.no_effect = request.coincident = true;
    request.spacing = kSpacing;
    return request;
}

std::string told(const CheckResult& result) {
    std::string text;
    for (const Finding& f : result.findings) {
        text += fmt::format("kind {} {} {} ± {} at {} {} {}\n", static_cast<int>(f.kind), f.text, f.value.value_or(-1),
                            f.error, f.point.x, f.point.y, f.point.z);
    }
    return text;
}

constexpr unsigned kSeeds = 25, kShares = 5;

TEST(Check, SoundModelsHaveNoFindings) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        const auto model = model_of(test::seeded_model(seed, {}));
        CheckRequest request = everything();
        for (csg::PartId a = 1; a < model->scene.parts.size(); ++a) {
            request.clearances.push_back(
                {model->scene.parts[0].name, model->scene.parts[a].name, test::kLeastClearance});
        }
        const CheckResult result = check(*model, request);
        EXPECT_TRUE(result.findings.empty()) << "seed " << seed << "\n" << told(result);
    }
}

class SeededDefects : public testing::TestWithParam<unsigned> {};

/// Eight of each model: 200 in all.
TEST_P(SeededDefects, AreFoundAndNothingElse) {
    const double reach = kSampleReach * kSpacing;
    unsigned seeded = 0;
    for (unsigned seed = GetParam(); seed < kSeeds; seed += kShares) {
        for (const test::Defect& defect : test::defects_of(seed, reach)) {
            ++seeded;
            const std::string text = test::seeded_model(seed, {defect});
            const auto model = model_of(text, defect.kind != FindingKind::Coincident || defect.text.empty());
            CheckRequest request = everything();
            if (defect.kind == FindingKind::Clearance) {
                request.clearances.push_back(
                    {model->scene.parts.front().name, model->scene.parts.back().name, test::kLeastClearance});
            }
            const CheckResult result = check(*model, request);
            const auto found = std::find_if(result.findings.begin(), result.findings.end(),
                                            [&](const Finding& f) { return f.kind == defect.kind; });
            ASSERT_NE(found, result.findings.end()) << text << told(result);
            if (defect.value >= 0) {
                EXPECT_NEAR(found->value.value_or(-1), defect.value, found->error + 1e-6) << text << told(result);
            }
            for (const Finding& f : result.findings) {
                EXPECT_TRUE(f.kind == defect.kind ||
                            std::find(defect.also.begin(), defect.also.end(), f.kind) != defect.also.end())
                    << text << told(result);
            }
        }
    }
    EXPECT_EQ(seeded, 200U / kShares);
}

INSTANTIATE_TEST_SUITE_P(All, SeededDefects, testing::Range(0U, kShares));

TEST(Check, OverhangsAreToldInDegrees) {
    const auto model = model_of(
        "cylinder(r1 = 5, r2 = 12, h = 7, $fn = 90); translate([40, 0, 0]) cylinder(r1 = 5, r2 = 8, h = 7, $fn = 90);",
        false);
    CheckRequest request;
    request.max_overhang = 40;
    const CheckResult result = check(*model, request);
    ASSERT_EQ(result.findings.size(), 1U) << told(result);  // Of the wide cone; what lies on the bed is none.
    const double flat = std::cos(glm::radians(2.0));
    EXPECT_NEAR(*result.findings[0].value, glm::degrees(std::atan(flat)), 1e-6);
}

TEST(Check, SizesAndVolumes) {
    const auto model = model_of("difference() { cube([30, 20, 10]); translate([5, 5, 5]) cube([20, 10, 10]); }", false);
    CheckRequest request;
    request.max_size = glm::dvec3(30, 19, 10);
    request.max_volume = 4985;
    request.min_volume = 100;
    const CheckResult result = check(*model, request);
    ASSERT_EQ(result.findings.size(), 2U) << told(result);
    EXPECT_EQ(*result.findings[0].value, 20);
    EXPECT_NEAR(*result.findings[1].value, 5000, result.findings[1].error);
    EXPECT_LT(result.findings[1].error, 15);
}

TEST(Check, SharpEdgesAreNoThinWalls) {
    // A wedge of 31 degrees and a cone; at a limit that is a tenth of them.
    const auto model = model_of(
        "linear_extrude(20) polygon([[0, 0], [20, 0], [0, 12.1]]); translate([40, 0, 0]) cylinder(r1 = 6, r2 = 0, h = "
        "10, "
        "$fn = 60);",
        false);
    CheckRequest request;
    request.min_wall = request.min_gap = 2;
    EXPECT_TRUE(check(*model, request).findings.empty()) << told(check(*model, request));
}

TEST(Check, SameFindingsInAnyRun) {
    const std::string text = test::seeded_model(3, test::defects_of(3, 1));
    const auto model = model_of(text);
    EXPECT_EQ(told(check(*model, everything())), told(check(*model, everything())));
}

TEST(Check, UnknownPartsOfAClearance) {
    const auto model = model_of("module lid() cube(1); module base() cube(2); translate([5, 0, 0]) lid(); base();");
    CheckRequest request;
    request.clearances = {{"lod", "base", 1}};
    try {
        (void)check(*model, request);
        FAIL();
    } catch (const ModelError& error) {
        EXPECT_NE(std::string(error.what()).find("Did you mean \"lid\"?"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace ui
