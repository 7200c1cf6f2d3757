// The truth: what an engine's stack of layers must hold, found by casting rays, one by one, on the CPU.
#pragma once

#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"
#include "tests/truth/band.h"

namespace truth {

/// One surface of the result.
struct Surface {
    double distance = 0;     ///< Along the axis of view, as in base::View.
    double depth = 0;        ///< The same as reversed depth.
    double depth_error = 0;  ///< Bound of an engine's error.
    /// The leaves that may be named: the smallest of S, and what remains the smallest where pruning by boxes has left
    /// out leaves of S below a node that does not switch itself. S: see docs/ENGINES.md, "Whose surface it is".
    std::vector<csg::LeafId> leaves;
    std::vector<std::uint32_t> planes;  ///< Entries of the plane table that meet in the event.
    std::vector<csg::LeafId> reversed;  ///< Of `leaves`, those that switch against the event.
    bool leaving = false;
};

struct Ray {
    /// False where the pixel is in the band: an edge is too near, or two events, or an event and the near plane, are
    /// closer than float depth can tell.
    bool hit = false;  ///< Does the ray meet any leaf?
    bool decided = true;
    std::vector<Surface> surfaces;  ///< Of all parts, nearest first.
};

/// Casts rays in double precision. Whether a ray hits a triangle is a question of signs; outside the band (band.h)
/// their arguments are larger than 1e-3 pixel, a billion times the rounding of doubles, so the answer is exact there.
/// On an edge inside a face the sign is taken from the edge in one direction for both of its triangles, so that just
/// one of them is hit. Nothing here is shared with the engines: no products, no slots, no depth coefficients. A closed
/// leaf holds a point where its winding number there is not zero, any other where a ray meets it an odd number of
/// times.
class RayCaster {
  public:
    /// All three must outlive the caster. `part_enabled`: 0 for parts that are left out
    /// (empty: none).
    RayCaster(const csg::Scene& scene, const csg::solid::Geometry& geometry, const base::View& view,
              std::vector<char> part_enabled = {});

    [[nodiscard]] Ray cast(int x, int y) const;
    [[nodiscard]] const Band& band() const { return band_; }

  private:
    struct Triangle {
        glm::dvec3 a, b, c;
        csg::LeafId leaf;
        std::uint32_t plane;
        base::View::Rectangle box;
    };
    /// A place where the ray meets a leaf.
    struct Crossing {
        double t;
        csg::LeafId leaf;
        std::uint32_t plane;
        int winding;  ///< What passing the surface adds to the winding number.
    };
    /// All crossings at one depth.
    struct Event {
        double distance = 0, depth = 0, error = 0;
        std::vector<Crossing> crossings;
    };
    void find_crossings(int x, int y, std::vector<Crossing>& crossings) const;
    [[nodiscard]] std::vector<Event> make_events(std::vector<Crossing> crossings, int x, int y, bool& decided) const;
    [[nodiscard]] bool holds(csg::LeafId leaf, int winding) const;
    void add_surfaces(csg::PartId part, std::span<const Event> events, std::vector<int> windings,
                      std::vector<std::vector<Surface>>& by_event) const;

    const csg::Scene& scene_;
    const csg::solid::Geometry& geometry_;
    base::View view_;
    Band band_;
    std::vector<csg::PartId> part_order_;
    std::vector<char> part_enabled_;
    std::vector<Triangle> triangles_;
};

}  // namespace truth
