#include "ui/viewer/tools/snap_places.h"

#include <algorithm>
#include <cmath>

#include "csg/tree/scene_edit.h"

namespace ui {

namespace {

constexpr std::size_t kMostCorners = 24;  // Of leaves that have more, none is a place that anyone means.

}  // namespace

SnapPlaces::SnapPlaces(const Model& model, csg::OccurrenceId moved) {
    const std::vector<char> below = csg::occurrences_below(model.scene, moved);
    csg::Box together;
    for (csg::LeafId id = 0; id < model.scene.leaves.size(); ++id) {
        const csg::OccurrenceId occurrence = model.scene.leaves[id].occurrence;
        const csg::solid::PlacedLeaf& leaf = model.geometry.leaves[id];
        if (leaf.box.empty()) {
            continue;
        }
        const bool own = occurrence != csg::kNoOccurrence && below[occurrence] != 0;
        add(leaf, own ? own_ : others_);
        together = own ? csg::enclose(together, leaf.box) : together;
    }
    if (!together.empty()) {
        add(together, own_);
    }
    add(csg::Box{glm::dvec3(0), glm::dvec3(0)}, others_);  // The origin.
    sort(own_);
    sort(others_);
}

void SnapPlaces::add(const csg::solid::PlacedLeaf& leaf, Places& places) {
    add(leaf.box, places);
    if (leaf.points.size() <= kMostCorners) {
        for (auto& along : places) {
            along.insert(along.end(), leaf.points.begin(), leaf.points.end());
        }
    }
}

void SnapPlaces::add(const csg::Box& box, Places& places) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double at : {box.lo[axis], box.center()[axis], box.hi[axis]}) {
            glm::dvec3 place = box.center();
            place[axis] = at;
            places[static_cast<std::size_t>(axis)].push_back(place);
        }
    }
}

void SnapPlaces::sort(Places& places) {
    for (int axis = 0; axis < 3; ++axis) {
        auto& along = places[static_cast<std::size_t>(axis)];
        std::stable_sort(along.begin(), along.end(), [=](const auto& a, const auto& b) { return a[axis] < b[axis]; });
        along.erase(std::unique(along.begin(), along.end(), [=](auto& a, auto& b) { return a[axis] == b[axis]; }),
                    along.end());
    }
}

std::optional<SnappedPlace> SnapPlaces::near(int axis, double by, double reach) const {
    const auto &own = own_[static_cast<std::size_t>(axis)], &others = others_[static_cast<std::size_t>(axis)];
    std::optional<SnappedPlace> nearest;
    for (const glm::dvec3& place : own) {
        const double at = place[axis] + by;
        auto other = std::lower_bound(others.begin(), others.end(), at - reach,
                                      [=](const glm::dvec3& p, double value) { return p[axis] < value; });
        for (; other != others.end() && (*other)[axis] <= at + reach; ++other) {
            const double way = (*other)[axis] - place[axis];
            if (!nearest || std::abs(way - by) < std::abs(nearest->by - by)) {
                nearest = SnappedPlace{way, place, *other};
            }
        }
    }
    return nearest;
}

}  // namespace ui
