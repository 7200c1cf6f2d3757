// Coordinates at which what is moved comes to lie in line with something else: corners, faces, middles.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ui/pipeline/model.h"

namespace ui {

/// Two places that have the same coordinate then. World coordinates.
struct SnappedPlace {
    double by = 0;                ///< How far along the axis.
    glm::dvec3 own{0}, other{0};  ///< Of what is moved, where it was; of something else.
};

class SnapPlaces {
  public:
    /// Of the leaves at and below the occurrence, and of all others: ends and middles of their boxes, and corners of
    /// those that have few.
    SnapPlaces(const Model& model, csg::OccurrenceId moved);

    /// The nearest to a way of that length along an axis (0 to 2), not farther off than `reach`.
    [[nodiscard]] std::optional<SnappedPlace> near(int axis, double by, double reach) const;

  private:
    /// Each coordinate once.
    using Places = std::array<std::vector<glm::dvec3>, 3>;
    static void add(const csg::solid::PlacedLeaf& leaf, Places& places);
    static void add(const csg::Box& box, Places& places);
    static void sort(Places& places);

    Places own_, others_;  ///< By axis, in order of that coordinate.
};

}  // namespace ui
