// Compares an engine's stack of layers with the truth.
#pragma once

#include <string>

#include "goldfeather/engines.h"
#include "layers/texture_stack.h"
#include "tests/random/random_tree.h"
#include "tests/truth/ray_caster.h"

namespace comparison {

/// A model made ready for peeling.
struct Subject {
    /// Without `with_products`, there are none and no part is over budget.
    explicit Subject(const csg::Tree& tree, bool with_products = true, const csg::PartRule& rule = {});

    csg::Scene scene;
    csg::solid::Geometry geometry;
    std::vector<std::vector<goldfeather::Product>> products;  ///< By part.
    std::vector<char> part_enabled;                           ///< 0: over budget, left out.
    std::size_t over_budget = 0;

    [[nodiscard]] goldfeather::EngineInput input() const { return {scene, geometry, products}; }
    [[nodiscard]] base::View view(const base::Camera& camera, glm::ivec2 size) const {
        return {camera, size, geometry.box.lo, geometry.box.hi};
    }
};

struct Count {
    std::size_t pixels = 0;     ///< With something along the ray.
    std::size_t undecided = 0;  ///< Of those, in the band.
    std::size_t surfaces = 0;   ///< Compared.
};

/// All layers, in main memory, with an engine of the context. Throws goldfeather::EngineObstacle.
[[nodiscard]] layers::HostStack peel_all(const gl::Functions& gl, goldfeather::Engine& engine, const Subject& subject,
                                         const base::View& view, int max_layers = goldfeather::kAllLayers);

/// The first `layers` layers of a stack; empty ones where it has fewer.
[[nodiscard]] std::vector<layers::Surface> padded(const layers::HostStack& stack, int layers);

/// Is it the surface that the truth says, within the bound of its depth?
[[nodiscard]] bool same(const truth::Surface& expected, const layers::Surface& actual);

/// Empty where the stack agrees with the truth at every pixel outside the band; otherwise what differs first, and
/// in how many pixels. `most`: layers that the stack was limited to.
[[nodiscard]] std::string difference(const Subject& subject, const base::View& view, const layers::HostStack& stack,
                                     Count& count, int most = goldfeather::kAllLayers);

}  // namespace comparison
