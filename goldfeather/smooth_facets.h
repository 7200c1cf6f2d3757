// Triangles that stand for smooth surfaces, for whoever shades them so.
#pragma once

#include <memory>

#include "csg/solid/placed.h"
#include "csg/solid/scene_change.h"
#include "layers/smooth_facets.h"

namespace goldfeather {

/// Those whose corners have other normals than their plane.
[[nodiscard]] layers::SmoothFacets smooth_facets(const csg::solid::Geometry& geometry);

/// The same of a scene that is edited: those of leaves that have not changed are kept.
class SmoothFacetKeeper {
  public:
    SmoothFacetKeeper();
    ~SmoothFacetKeeper();
    SmoothFacetKeeper(const SmoothFacetKeeper&) = delete;
    SmoothFacetKeeper& operator=(const SmoothFacetKeeper&) = delete;

    /// Of the scene, or there is another one.
    void changed(const csg::solid::SceneChange& change);
    void forget();
    [[nodiscard]] layers::SmoothFacets facets(const csg::solid::Geometry& geometry);

  private:
    struct Rows;
    std::unique_ptr<Rows> rows_;
};

}  // namespace goldfeather
