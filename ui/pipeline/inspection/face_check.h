// What is wrong at one point of a face: walls, gaps, features, interferences, contacts, overhangs.
#pragma once

#include <compare>
#include <map>
#include <vector>

#include "ui/pipeline/inspection/effects.h"
#include "ui/pipeline/inspection/findings.h"
#include "ui/pipeline/inspection/solid_probe.h"

namespace ui {

/// Faces count as opposite where their normals are within so many degrees of being so: the sides of a wedge are not,
/// and its edge, where any thickness ends, is no thin wall. Features have the wider limit, as few sides may be theirs.
inline constexpr double kOppositeDegrees = 30, kOppositeSidesDegrees = 40;

/// What findings are one: those of the same kind between the same two surfaces, or of the same surface alone.
struct FindingKey {
    FindingKind kind = FindingKind::Wall;
    std::uint64_t a = 0, b = 0;
    auto operator<=>(const FindingKey&) const = default;
};

/// The worst of each.
using FoundFaces = std::map<FindingKey, Finding>;

void keep_worst(FoundFaces& found, const FindingKey& key, const Finding& finding);

/// How deep two parts run into each other is told by each surface of either, inwards along its normal at the deepest
/// place; the depth is that of the surface where this is the least: what moving one of them out would take.
[[nodiscard]] std::vector<Finding> worst_of(const FoundFaces& found, const CheckRequest& request);

/// One for each thread.
class FaceCheck {
  public:
    /// All must outlive it. `lowest`: of the model, whose faces there lie on the bed.
    FaceCheck(const SolidProbe& probe, const ExpressionLinks& links, const CheckRequest& request, double reach,
              double lowest);

    /// A point on a triangle of a leaf.
    void look(csg::LeafId leaf, std::uint32_t triangle, const glm::dvec3& point);

    [[nodiscard]] const FoundFaces& found() const { return found_; }
    [[nodiscard]] const Effects& effects() const { return effects_; }

  private:
    /// A place of a part's surface.
    struct Place {
        csg::LeafId leaf;
        std::uint32_t triangle;
        glm::dvec3 point, outwards;
        const Covers *inside, *outside;
    };
    void look_at_contacts(csg::LeafId leaf, std::uint32_t triangle, const glm::dvec3& point, const glm::dvec3& normal,
                          bool in_front, bool behind);
    void look_at_wall(const Place& place);
    void look_at_gap(const Place& place);
    void look_at_feature(const Place& place, bool solid);
    void look_at_interference(const Place& place);
    void look_at_overhang(const Place& place);
    [[nodiscard]] std::uint64_t surface(csg::LeafId leaf, std::uint32_t triangle) const;
    [[nodiscard]] Finding at(FindingKind kind, const Place& place) const;
    void opposite(Finding& finding, const PartRay::Hit& hit) const;
    void add(const Finding& finding, std::uint64_t a, std::uint64_t b);
    [[nodiscard]] double error_of(double cosine) const;

    const SolidProbe& probe_;
    const CheckRequest& request_;
    double reach_, lowest_;
    Effects effects_;
    PartRay ray_, other_;
    SolidProbe::Sides sides_, middle_;
    Covers less_;
    FoundFaces found_;
};

}  // namespace ui
