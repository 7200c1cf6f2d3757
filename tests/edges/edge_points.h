// Points along the edges of a picture: as they are, and as they are found.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/camera.h"
#include "layers/host_stack.h"
#include "ui/pipeline/mesh/mesh.h"
#include "ui/pipeline/model.h"

namespace edges {

enum class Kind : std::uint8_t { Silhouette, Crease, Border };

struct Point {
    glm::dvec2 at{0};  ///< Pixels from the lower left corner; pixel centers at halves.
    Kind kind = Kind::Silhouette;
    bool hidden = false;
};

/// From the exact mesh and the smooth groups of its leaves, every half pixel: an edge of the mesh is a silhouette where
/// it parts a front from a back; a crease where it bends by more than 3 degrees between two surfaces, and, between two
/// leaves, by more than their facets can tell (csg::solid::FacetGroup::bend); a border where only the color changes.
/// What hides a point is found by its ray to the eye. Points outside the picture are left out.
[[nodiscard]] std::vector<Point> true_points(const ui::Model& model, const csg::reference::Mesh& mesh,
                                             const base::View& view);

/// All layers of the model, by the engine `lists-cpu`.
[[nodiscard]] layers::HostStack layers_of(const ui::Model& model, const base::View& view);

/// Of the edge map (npr/painter/cpu_edges.h), without settings.
[[nodiscard]] std::vector<Point> found_points(const layers::HostStack& stack, const base::View& view);

/// How well points are found, with one pixel of play.
struct Score {
    std::size_t drawn = 0, right = 0;   ///< Points found, and those of them near a true one.
    std::size_t points = 0, found = 0;  ///< True points, and those of them near one that was found.

    [[nodiscard]] double precision() const;
    [[nodiscard]] double recall() const;
    /// Their harmonic mean; 1 where there is nothing and nothing is found.
    [[nodiscard]] double f() const;
    void add(const Score& other);
};
[[nodiscard]] Score score(const std::vector<Point>& truth, const std::vector<Point>& found, glm::ivec2 size);

/// Of the points for which `keep` holds.
template <typename Keep>
[[nodiscard]] std::vector<Point> only(const std::vector<Point>& points, const Keep& keep) {
    std::vector<Point> some;
    for (const Point& p : points) {
        if (keep(p)) {
            some.push_back(p);
        }
    }
    return some;
}

/// The first layer as single buffers, as Saito and Takahashi (1990) and Decaudin (1996) find edges in them.
enum class Buffer : std::uint8_t { Depth, Normal, Id };

/// Where Sobel's operator on the buffer is above a threshold: of depth and normals the one, of eight, that is best by
/// `truth`.
[[nodiscard]] Score sobel_score(const layers::HostStack& stack, const base::View& view, Buffer buffer,
                                const std::vector<Point>& truth);

}  // namespace edges
