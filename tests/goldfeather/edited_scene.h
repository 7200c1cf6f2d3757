// A scene as engines want it, and what differs between one that was edited and one that was made from nothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "csg/solid/editable_scene.h"
#include "goldfeather/engine_set.h"
#include "layers/host_stack.h"
#include "tests/random/build_model.h"

namespace edited_scene {

/// From the root down: which child, step by step.
using Path = std::vector<std::uint32_t>;

/// kNoOccurrence where nothing of the scene is there.
[[nodiscard]] csg::OccurrenceId occurrence_at(const csg::Scene& scene, const Path& path);

/// A scene with all that engines want of it.
struct Subject {
    csg::Tree tree;
    csg::Scene scene;
    csg::solid::Geometry geometry;
    std::vector<std::vector<goldfeather::Product>> products;

    Subject(const random_tree::Model& model, csg::solid::SolidCache& cache, const csg::solid::Room& room = {});
    void normalize();
    [[nodiscard]] goldfeather::EngineInput input() const { return {scene, geometry, products}; }
};

constexpr std::uint32_t kUnused = ~std::uint32_t{0};

/// The numbers of the planes in use, counted without the others, which have kUnused.
[[nodiscard]] std::vector<std::uint32_t> numbers_of_planes(const csg::solid::Geometry& geometry);

/// What differs first; empty where nothing does. `geometry`: of the edited scene.
[[nodiscard]] std::string difference(const csg::Scene& edited, const csg::Scene& made);
[[nodiscard]] std::string difference(const csg::solid::Geometry& edited, const csg::solid::Geometry& made);
[[nodiscard]] std::string difference(const csg::solid::Geometry& geometry, const layers::HostStack& edited,
                                     const layers::HostStack& made);

}  // namespace edited_scene
