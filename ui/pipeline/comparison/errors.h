// The errors of a stack of layers against a mesh (DESIGN, section 5).
#pragma once

#include <cstdint>
#include <vector>

#include "csg/solid/placed.h"
#include "layers/host_stack.h"
#include "ui/pipeline/comparison/mesh_layers.h"
#include "ui/pipeline/json.h"

namespace ui {

/// Of the k-th surfaces behind the pixels.
struct LayerErrors {
    std::size_t pixels = 0;          ///< With a surface there in one of the two.
    std::size_t coverage_wrong = 0;  ///< … in just one.
    std::size_t surfaces = 0;        ///< Compared one by one.
    std::size_t normals_wrong = 0;   ///< Surfaces whose normals, out of the solid, differ by more than 1 degree.
    std::size_t turned = 0;          ///< … that the ray enters by in one of the two, and leaves by in the other.
    double depth_squares = 0;        ///< Sum, over the scene's diagonal.
    double depth_largest = 0;        ///< Over the scene's diagonal.

    void add(const LayerErrors& other);
};

/// Of one picture, all layers. Shares are of the pixels with something in one of the two.
struct Errors : LayerErrors {
    std::size_t layers_wrong = 0;    ///< Pixels whose numbers of layers differ.
    std::size_t order_wrong = 0;     ///< Pixels where one of the two does not enter and leave in turn.
    std::vector<LayerErrors> layer;  ///< One by one, from the front.
    std::size_t edges_matched = 0, edges_drawn = 0, edges_true = 0, edges_found = 0;

    [[nodiscard]] double coverage() const { return share(coverage_wrong, pixels); }
    [[nodiscard]] double layers() const { return share(layers_wrong, pixels); }
    [[nodiscard]] double order() const { return share(order_wrong, pixels); }
    [[nodiscard]] double normals() const { return share(normals_wrong, surfaces); }
    [[nodiscard]] double depth_rms() const;
    /// Of the edge pixels of the first layer, with one pixel of play: 1 where all agree.
    [[nodiscard]] double edge_f_score() const;
    void add(const Errors& other);

  private:
    static double share(std::size_t part, std::size_t whole) {
        return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
    }
};

struct Comparison {
    Errors all;      ///< All pixels.
    Errors outside;  ///< Without the band of one pixel along the mesh's silhouettes and creases, in any layer.
    std::vector<std::uint8_t> wrong;          ///< By pixel: 0 agrees, 1 differs inside the band, 2 differs outside it.
    std::vector<std::uint16_t> wrong_layers;  ///< By pixel: how many of its layers differ.
};

/// Of unit length.
[[nodiscard]] glm::dvec3 normal_of(const csg::reference::Mesh& mesh, std::uint32_t triangle);

/// Compares layer by layer. The picture's normals face out of the solid, that is the eye where the ray enters; the
/// mesh's are those of its triangles as they are oriented. `diagonal`: of the scene, world units.
[[nodiscard]] Comparison compare_layers(const layers::HostStack& stack, const csg::solid::Geometry& geometry,
                                        const csg::reference::Mesh& mesh, const MeshLayers& truth,
                                        const base::View& view, double diagonal);

[[nodiscard]] Json to_json(const Errors& errors);

}  // namespace ui
