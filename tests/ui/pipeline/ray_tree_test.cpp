// Whatever a ray meets is visited, once; and little more.
#include "ui/pipeline/inspection/ray_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace ui {
namespace {

/// In double precision; a ray that lies just in a face is between its faces.
bool meets(const csg::Box& box, const glm::dvec3& origin, const glm::dvec3& direction, double most) {
    double from = 0, to = most;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (origin[axis] < box.lo[axis] || origin[axis] > box.hi[axis]) {
                return false;
            }
            continue;
        }
        const double a = (box.lo[axis] - origin[axis]) / direction[axis],
                     b = (box.hi[axis] - origin[axis]) / direction[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

void expect_all(const std::vector<csg::Box>& boxes, std::mt19937& random, double size) {
    std::uniform_real_distribution<double> any(-size, size);
    const RayTree tree(boxes);
    std::size_t met = 0, visited = 0;
    for (int i = 0; i < 300; ++i) {
        const csg::Box& box = boxes[random() % boxes.size()];
        glm::dvec3 origin(any(random), any(random), any(random)), direction(0, 0, 0);
        if (i % 3 == 0) {
            direction[i / 3 % 3] = i % 2 == 0 ? 1 : -1;
            origin = {box.lo.x, box.hi.y, box.center().z};  // Along two faces.
        } else {
            direction = glm::normalize(box.center() - origin);
        }
        const double most = i % 2 == 0 ? 0.5 * size : std::numeric_limits<double>::infinity();
        std::map<std::uint32_t, int> times;
        tree.along(origin, direction, most, [&](std::uint32_t id) { ++times[id]; });
        visited += times.size();
        for (std::uint32_t id = 0; id < boxes.size(); ++id) {
            if (meets(boxes[id], origin, direction, most)) {
                ++met;
                ASSERT_EQ(times[id], 1) << "box " << id << ", ray " << i;
            }
        }
        for (const auto& [id, count] : times) {
            ASSERT_LE(count, 1);
        }
    }
    EXPECT_LE(visited, met + met / 50 + 10) << "the tree sorts out next to all others";
}

TEST(RayTree, VisitsAllThatRaysMeet) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-100, 100), side(0, 6);
    for (const std::size_t count : {1, 2, 3, 4, 5, 6, 7, 9, 12, 17, 64, 500}) {
        std::vector<csg::Box> boxes;
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 lo(any(random), any(random), any(random));
            boxes.push_back({lo, lo + glm::dvec3(side(random), side(random), i % 5 == 0 ? 0 : side(random))});
        }
        expect_all(boxes, random, 100);
    }
}

TEST(RayTree, HugeBoxesDoNotWidenTheOthers) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> any(-10, 10);
    std::vector<csg::Box> boxes{{glm::dvec3(-1e10), glm::dvec3(1e10, 1e10, -1e9)}};
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 lo(any(random), any(random), any(random));
        boxes.push_back({lo, lo + 0.3});
    }
    const RayTree tree(boxes);
    std::size_t visited = 0;
    for (int i = 0; i < 100; ++i) {
        tree.along({any(random), any(random), 20}, {0, 0, -1}, 100, [&](std::uint32_t) { ++visited; });
    }
    EXPECT_LT(visited, 100U);  // 1 in 4,000 each.
}

TEST(RayTree, NothingIsMetWhereNothingIs) {
    RayTree({}).along({0, 0, 0}, {0, 0, 1}, 1, [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace ui
