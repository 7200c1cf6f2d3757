// The planes of a scene whose leaves change. Internal to csg/solid.
//
// place() finds the planes of all triangles at once: by width, each takes the first entry that it can share, or makes
// one (assign_planes.h). So a triangle's entry depends on those before it and on nothing else, and what changes with a
// leaf can be told: entries that only its triangles used go, and triangles get entries as in the order of all. Where
// that would concern a triangle of another leaf (the leaf made an entry that others use, or makes one that others
// would have taken had it been there) all planes are assigned anew: it is seldom, and right whatever chain follows.
//
// Numbers are in the order in which entries are made, with holes where some were. A leaf that moves finds the holes
// that it left; where there is none, one is made, and all numbers behind it are others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/solid/placed.h"
#include "csg/solid/scene_change.h"

namespace csg::solid {

class PlaneKeeper {
  public:
    /// `geometry`: with planes assigned; must outlive it.
    explicit PlaneKeeper(Geometry& geometry);

    /// A leaf whose triangles are others than those that had these planes.
    struct Changed {
        LeafId leaf = 0;
        std::vector<PlaneRef> before;
    };
    /// Fills the planes of leaves that have changed as place() would; the tolerance is as it was. Adds to `change`.
    void update(std::span<const Changed> leaves, SceneChange& change);
    /// Assigns all planes, with that tolerance.
    void assign_all(double tolerance, SceneChange& change);

    /// A leaf without triangles has come: those from there on have the next number.
    void leaf_inserted(LeafId at);
    /// A leaf without triangles is gone.
    void leaf_erased(LeafId at);

  private:
    /// By width, leaf and place in it: the place of a triangle in the order of all. An entry has its maker's.
    using Key = std::uint64_t;
    struct Made;
    struct Update;
    [[nodiscard]] static Key key_of(const PlacedLeaf& geometry, LeafId leaf, std::uint32_t triangle);
    [[nodiscard]] static LeafId leaf_of(Key key);
    [[nodiscard]] Key key(const Update& update, std::uint32_t entry) const;
    void count_users();
    void take_back(Update& update);
    void find_entries(Update& update);
    void revive(Update& update) const;
    [[nodiscard]] bool concerns_others(const Update& update) const;
    [[nodiscard]] bool any_would_share(const Update& update, std::span<const Made* const> made) const;
    [[nodiscard]] bool find_holes(Update& update);
    void make_holes(Update& update, SceneChange& change);
    void fill_holes(Update& update, SceneChange& change);

    Geometry& geometry_;
    std::vector<Key> keys_;             ///< By entry; of holes, some key between those beside them.
    std::vector<std::uint32_t> users_;  ///< By entry: triangles; 0 for holes.
};

}  // namespace csg::solid
