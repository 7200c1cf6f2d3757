// Which engine is chosen, and why.
#include "goldfeather/choice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using goldfeather::choose_engine;
using goldfeather::EngineInfo;
using goldfeather::find_engine;

TEST(Choice, TakesWhatIsAskedFor) {
    for (const EngineInfo& engine : goldfeather::engines()) {
        const auto choice = choose_engine(&engine, {true, false, 3});
        EXPECT_EQ(choice.engine, &engine);
        EXPECT_EQ(choice.reason, "as asked for");
    }
}

TEST(Choice, IsTheCpuWhereThatComputesOpenGl) {
    for (const double depth : {0.0, 1.0, 5.0, 50.0, 500.0}) {
        for (const bool over_budget : {false, true}) {
            EXPECT_EQ(choose_engine({}, {true, over_budget, depth}).engine, find_engine("lists-cpu")) << depth;
        }
    }
}

TEST(Choice, IsOnTheGpuWhereThereIsOne) {
    EXPECT_EQ(choose_engine({}, {false, false, 0.1}).engine, find_engine("goldfeather"));  // Hardly anything to peel.
    EXPECT_EQ(choose_engine({}, {false, true, 0.1}).engine, find_engine("lists"));
    EXPECT_EQ(choose_engine({}, {false, false, 20}).engine, find_engine("lists"));
}

TEST(Choice, GivesTheEstimates) {
    const auto choice = choose_engine({}, {false, true, 5});
    EXPECT_NE(choice.reason.find("GPU"), std::string::npos) << choice.reason;
    EXPECT_NE(choice.reason.find("lists 15.0"), std::string::npos) << choice.reason;
    EXPECT_NE(choice.reason.find("goldfeather: too many products"), std::string::npos) << choice.reason;
    EXPECT_TRUE(std::isinf(goldfeather::estimated_cost(*find_engine("goldfeather"), {false, true, 5})));
}

TEST(Choice, GoesByTheLayersWanted) {
    for (const EngineInfo* engine : {find_engine("goldfeather"), find_engine("lists"), find_engine("lists-cpu")}) {
        const auto cost = [&](double depth, int layers) {
            return goldfeather::estimated_cost(*engine, {true, false, depth, layers});
        };
        EXPECT_LT(cost(40, 1), cost(40, 4));
        EXPECT_LT(cost(40, 4), cost(40, 0));
        EXPECT_EQ(cost(3, 2), cost(3, 0)) << "there are no more";
    }
    EXPECT_NE(choose_engine({}, {true, false, 5, 1}).reason.find("for one layer"), std::string::npos);
    EXPECT_NE(choose_engine({}, {true, false, 5, 3}).reason.find("for 3 layers"), std::string::npos);
    EXPECT_NE(choose_engine({}, {true, false, 5}).reason.find("for all layers"), std::string::npos);
}

TEST(Choice, DepthIsCountedByBoxes) {
    const csg::Box scene{glm::dvec3(0.0), glm::dvec3(4.0)}, half{glm::dvec3(0.0), glm::dvec3(2.0)};
    EXPECT_DOUBLE_EQ(goldfeather::estimated_depth(std::vector{scene}, scene), 2);
    EXPECT_DOUBLE_EQ(goldfeather::estimated_depth(std::vector{scene, half, half, csg::Box{}}, scene), 3);
    EXPECT_DOUBLE_EQ(goldfeather::estimated_depth({}, csg::Box{}), 0);
}

}  // namespace
