// Eyes in awkward places, and extreme lenses.
#include <cmath>

#include "tests/stability/family.h"

namespace stability {

namespace {

using Id = Maker::Id;

/// A room with furniture: what an eye inside sees has all roles.
Id room(Maker& m) {
    return m.subtract({m.box({-5, -5, -5}, {10, 10, 10}), m.sphere({0, 0, 0}, 3, 24), m.box({-1, -9, -1}, {2, 18, 2})});
}

}  // namespace

void add_views(std::vector<Family>& all) {
    all.push_back({"eye inside a solid", "The eye within the solid, so far from a face.", "distance / size",
                   powers_of_ten(-1, 1, 6), [](double distance) {
                       Maker m;
                       return m.seen(m.unite({m.box({-5, -5, -5}, {10, 10, 10}), m.sphere({6, 3, 1}, 3)}),
                                     {5 - 10 * distance, 0.2, 4}, {4.7, 3, 0.3}, 60);
                   }});
    all.push_back({"eye in a hole", "The eye in a subtracted ball, so far from its wall.", "distance / size",
                   powers_of_ten(-1, 1, 6), [](double distance) {
                       Maker m;
                       return m.seen(room(m), {2.9 - 10 * distance, 0.2, 0.1}, {0, 0.5, 0.3}, 60);
                   }});
    all.push_back({"eye inside many solids", "The eye within n boxes.", "boxes", {1, 2, 4, 8, 16, 32}, [](double n) {
                       Maker m;
                       std::vector<Id> boxes;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           boxes.push_back(m.box(glm::dvec3(-1 - 0.25 * i), glm::dvec3(2 + 0.4 * i)));
                       }
                       const Id cut = m.subtract({m.unite(boxes), m.cylinder({0.2, 0.3, -20}, 40, 0.5)});
                       return m.seen(cut, {0.6, -0.55, 0.5}, {0.2, 0.3, -0.1}, 60);
                   }});
    // To within the near distance, a millionth of the scene, an eye on a face is an exception of docs/ENGINES.md.
    all.push_back({"eye on a face", "The eye outside, so far above the plane of a face.", "distance / size",
                   powers_of_ten(-1, 1, 12), [](double distance) {
                       Maker m;
                       return m.seen(room(m), {5 + 10 * distance, 0.2, 4.1}, {4.9, 4, 0}, 60);
                   }});
    all.push_back(
        {"near plane through everything",
         "The eye in the middle of n plates.",
         "plates",
         {2, 5, 10, 30, 100},
         [](double n) {
             Maker m;
             std::vector<Id> plates;
             for (int i = 0; i < static_cast<int>(n); ++i) {
                 plates.push_back(m.box({-4 + 8 * i / n, -4, -4}, {4 / n, 8, 8}));
             }
             return m.seen(m.subtract({m.unite(plates), m.sphere({0, 0, 0}, 2)}), {0.013, -3, 0.1}, {0.02, 3, 0.4}, 60);
         }});
    all.push_back({"narrow lens",
                   "A field of view of this angle, from far away.",
                   "degrees",
                   {30, 3, 0.3, 0.03, 0.003},
                   [](double fov) {
                       Maker m;
                       const double distance = 8 / std::tan(fov * 3.14159265 / 360);
                       return m.seen(room(m), glm::normalize(glm::dvec3(13, -17, 15)) * distance, {0, 0, 0}, fov);
                   }});
    all.push_back({"wide lens",
                   "A field of view of this angle, from close by.",
                   "degrees",
                   {60, 90, 120, 150, 170, 178},
                   [](double fov) {
                       Maker m;
                       return m.seen(room(m), {6.5, -7, 6}, {0, 0, 0}, fov);
                   }});
    all.push_back(
        {"far away",
         "The camera this many sizes away; the lens shows the same.",
         "distance / size",
         {2, 20, 200, 2e3, 2e4, 2e5},
         [](double distance) {
             Maker m;
             const double fov = 2 * std::atan(0.8 / distance) * 180 / 3.14159265;
             return m.seen(room(m), glm::normalize(glm::dvec3(13, -17, 15)) * (10 * distance), {0, 0, 0}, fov);
         }});
    all.push_back({"straight down an axis", "A hole seen along its axis, off by so much.", "offset / size",
                   powers_of_ten(-1, 2, 6), [](double offset) {
                       Maker m;
                       const Id plate = m.subtract({m.box({-4, -4, -4}, {8, 8, 8}), m.cylinder({0, 0, -5}, 10, 2, 32),
                                                    m.box({-1, -4, -4}, {1, 8, 8})});
                       return m.seen(plate, {8 * offset, 8 * offset, 24}, {0, 0, 0});
                   }});
}

}  // namespace stability
