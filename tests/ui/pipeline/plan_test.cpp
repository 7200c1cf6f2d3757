// Several views in one picture.
#include "ui/pipeline/picture/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace ui {
namespace {

const csg::Box kBox{{-10, 0, 5}, {30, 25, 20}};

/// Where a point of the world is in the whole picture, in pixels from its upper left corner.
glm::dvec2 place(const PlanCell& cell, const glm::dvec3& point) {
    const base::View view(cell.camera, cell.size, kBox.lo, kBox.hi);
    const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(point, 1);
    return glm::dvec2(cell.corner) + 0.5 * glm::dvec2(cell.size) * glm::dvec2(1 + clip.x, 1 - clip.y);
}

TEST(Plan, HasOneScaleAndViewsInLine) {
    const Plan plan = plan_of(read_plan("top,front,side,iso"), {600, 500}, kBox);
    ASSERT_EQ(plan.cells.size(), 4U);
    int area = 0;
    for (const PlanCell& cell : plan.cells) {
        area += cell.size.x * cell.size.y;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 p(corner & 1 ? kBox.hi.x : kBox.lo.x, corner & 2 ? kBox.hi.y : kBox.lo.y,
                               corner & 4 ? kBox.hi.z : kBox.lo.z);
            const glm::dvec2 at = place(cell, p) - glm::dvec2(cell.corner);
            EXPECT_TRUE(at.x > 4 && at.y > 4 && at.x < cell.size.x - 4 && at.y < cell.size.y - 4);
        }
    }
    EXPECT_EQ(area, 600 * 500) << "cells fill the picture";
    const PlanCell &top = plan.cells[0], &front = plan.cells[1], &side = plan.cells[2];
    const glm::dvec3 low = kBox.lo, right(kBox.hi.x, kBox.lo.y, kBox.lo.z), back(kBox.lo.x, kBox.hi.y, kBox.lo.z),
                     up(kBox.lo.x, kBox.lo.y, kBox.hi.z);
    EXPECT_NEAR(place(front, right).x - place(front, low).x, 40 * plan.pixels_per_unit, 1e-6);
    EXPECT_NEAR(place(top, low).y - place(top, back).y, 25 * plan.pixels_per_unit, 1e-6) << "the back is above";
    EXPECT_NEAR(place(side, back).x - place(side, low).x, 25 * plan.pixels_per_unit, 1e-6) << "the back is right";
    EXPECT_NEAR(place(top, right).x, place(front, right).x, 1e-6) << "one above the other";
    EXPECT_NEAR(place(side, up).y, place(front, up).y, 1e-6) << "one beside the other";
    EXPECT_LT(place(top, low).y, place(front, up).y);
    EXPECT_GT(place(side, low).x, place(front, right).x);
}

TEST(Plan, OneViewHasAllOfThePicture) {
    const Plan plan = plan_of({PlanView::Side}, {300, 200}, kBox);
    ASSERT_EQ(plan.cells.size(), 1U);
    EXPECT_EQ(plan.cells[0].corner, glm::ivec2(0));
    EXPECT_EQ(plan.cells[0].size, glm::ivec2(300, 200));
}

TEST(Plan, DrawsEachViewAndTheGroundOfWhatIsLeftOut) {
    PictureRequest request;
    request.size = {300, 240};
    std::set<std::pair<int, int>> sizes;
    int drawn = 0;
    const base::Image image = draw_plan(read_plan("top,front,side"), request, kBox, [&](const PictureRequest& view) {
        ++drawn;
        EXPECT_EQ(view.camera.projection, base::Projection::Orthographic);
        base::Image white{view.size.x, view.size.y, {}};
        white.rgba.assign(4 * static_cast<std::size_t>(view.size.x) * static_cast<std::size_t>(view.size.y), 255);
        return white;
    });
    EXPECT_EQ(drawn, 4);
    int inked = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        EXPECT_EQ(image.rgba[i + 3], 255) << "all of it is drawn";
        inked += image.rgba[i] < 200 ? 1 : 0;
    }
    EXPECT_GT(inked, 150) << "lines from view to view, and the bar";
    EXPECT_LT(inked, 2500);
}

TEST(Plan, IsReadByNames) {
    EXPECT_EQ(read_plan("iso,top"), (std::vector{PlanView::Iso, PlanView::Top}));
    for (const char* wrong : {"", "top,", "left", "top,top", "top front"}) {
        EXPECT_THROW((void)read_plan(wrong), std::invalid_argument) << wrong;
    }
}

}  // namespace
}  // namespace ui
