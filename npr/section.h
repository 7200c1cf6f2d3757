// What of the model is cut away in a picture, so that it is seen from inside.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <variant>
#include <vector>

namespace npr {

/// All on one side of the plane dot(normal, p) = offset, in world units.
struct PlaneSection {
    enum class Away {
        Beyond,  ///< What the normal points to.
        Eye,     ///< The side that the eye is on: the cut is seen.
    };
    glm::dvec3 normal{0, 0, 1};  ///< Of length 1.
    double offset = 0;
    Away away = Away::Eye;
    bool operator==(const PlaneSection&) const = default;
};

/// All within a box, in world units; it may reach to infinity.
struct BoxSection {
    glm::dvec3 lo{0.0}, hi{0.0};
    bool operator==(const BoxSection&) const = default;
};

/// What lies before the middle of the model, as the eye sees it, along the nearest axes: of x and y that which points
/// to the eye the most (1: half of the model), both (2: a quarter), z as well (3: an eighth).
struct CornerSection {
    int axes = 2;
    bool operator==(const CornerSection&) const = default;
};

/// What is inside a part of the model, which is itself not shown.
struct PartSection {
    std::string part;
    bool operator==(const PartSection&) const = default;
};

struct Section {
    std::variant<PlaneSection, BoxSection, CornerSection, PartSection> cut;
    std::string text;  ///< As it was asked for: what messages call it.
    bool operator==(const Section&) const = default;
};

struct Sections {
    static constexpr double kOwnSpacing = -1;

    std::vector<Section> cuts;
    std::vector<std::string> uncut;  ///< Parts that stay whole, as shafts and bolts do in drawings.
    /// Of the lines of hatching on faces of cuts, in world units; 0: the part's color alone; kOwnSpacing: by the size
    /// of the model.
    double spacing = kOwnSpacing;
    bool operator==(const Sections&) const = default;
};

}  // namespace npr
