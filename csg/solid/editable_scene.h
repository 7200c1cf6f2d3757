// A scene that is changed in place: leaves that no text made come and go, leaves and parts move, parts are hidden.
//
// After each commit the scene and its geometry are what make_scene() and place() would give for the tree with these
// changes, in the room of the scene before them (Room): the same surfaces, to the last bit. (Planes have holes between
// their numbers, and are otherwise in the same order.) What a commit does is told by a SceneChange; it costs what the
// leaves that changed need, and a look at the boxes of all.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "csg/solid/placed.h"
#include "csg/solid/plane_keeper.h"
#include "csg/solid/scene_change.h"
#include "csg/tree/scene_edit.h"

namespace csg::solid {

/// A leaf that was added, as long as it is there. Leaves have other numbers whenever one comes or goes; this stays.
using AddedId = std::uint32_t;

/// What an added leaf looks like: as LeafInstance has it.
struct AddedLook {
    Rgba color;
    std::uint8_t hatching = 0;
};

class EditableScene {
  public:
    /// `geometry`: of `scene`, from place() or another edit. Both must outlive it, and nobody else may change them.
    EditableScene(Scene& scene, Geometry& geometry);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const Geometry& geometry() const { return geometry_; }
    /// That which this scene began in.
    [[nodiscard]] const Room& room() const { return room_; }

    /// Adds a leaf at the site, where something must be: united with what is there, subtracted from it or intersected
    /// with it. `solid`: in leaf coordinates.
    AddedId add(const Site& site, ExpressionKind operation, std::shared_ptr<const Solid> solid,
                const glm::dmat4& to_world, const AddedLook& look = {});
    /// The same for the half-space of points p with dot(normal, p) ≤ offset. Its face has exactly that plane, unless it
    /// coincides with another exact one. It ends outside of everything else (cut_box.h), where it counts for the bounds
    /// of the scene.
    AddedId add(const Site& site, ExpressionKind operation, const Plane& half_space, const AddedLook& look = {});
    void remove(AddedId added);
    /// The number that it has until leaves come or go.
    [[nodiscard]] LeafId leaf(AddedId added) const { return added_[added].leaf; }

    /// Puts a leaf elsewhere.
    void move(LeafId leaf, const glm::dmat4& to_world);
    /// Puts a half-space elsewhere.
    void move(AddedId half_space, const Plane& plane);
    /// Moves all leaves of a part, those that were added among them, from where the text or the functions above put
    /// them. The matrix has no say in later calls.
    void move_part(PartId part, const glm::dmat4& motion);
    /// The same for the leaves of the text at and below an occurrence.
    void move_occurrence(OccurrenceId occurrence, const glm::dmat4& motion);
    void show(PartId part, bool shown);

    /// Brings the geometry up to date. What has changed since the last commit.
    [[nodiscard]] SceneChange commit();

  private:
    struct Added {
        LeafId leaf = 0;
        std::optional<Plane> rest, plane;  ///< Of a half-space: as it was put; as its part has moved it.
        bool there = true;
    };
    AddedId insert(const Site& site, ExpressionKind operation, const AddedLook& look, const glm::dmat4& to_world,
                   PlacedLeaf placed, Added added);
    void touch(LeafId leaf);
    void move_from_rest(LeafId leaf, const glm::dmat4& motion);
    [[nodiscard]] Added* half_space(LeafId leaf);
    /// Brings the geometry up to date.
    void settle();
    void place_touched();
    void place_bounded(LeafId leaf);
    void touch_trimmed(PartId part);
    void place_half_spaces(const Box& bounded);

    Scene& scene_;
    Geometry& geometry_;
    Room room_;
    PlaneKeeper planes_;
    std::vector<glm::dmat4> rest_;            ///< By leaf: to_world before its part moved.
    std::vector<Box> whole_;                  ///< By leaf: its box before it was trimmed; half-spaces have no bounds.
    std::vector<std::optional<Box>> limits_;  ///< By part: what its leaves are trimmed to.
    std::vector<Added> added_;
    Box half_space_box_;                         ///< What half-spaces end at.
    std::vector<LeafId> touched_;                ///< Since the geometry was last up to date, …
    std::vector<char> is_touched_;               ///< … and by leaf.
    std::vector<char> part_touched_;             ///< By part: one of its leaves is, or has gone.
    std::vector<PlaneKeeper::Changed> changed_;  ///< Leaves that have been placed, with the planes they had.
    SceneChange change_;
};

}  // namespace csg::solid
