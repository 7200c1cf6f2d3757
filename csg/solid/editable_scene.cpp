#include "csg/solid/editable_scene.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "csg/solid/cut_box.h"
#include "csg/solid/place_leaf.h"
#include "csg/solid/trim_leaves.h"

namespace csg::solid {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Box everything() {
    return {glm::dvec3(-kInfinity), glm::dvec3(kInfinity)};
}

bool reaches_beyond(const Box& box, const std::optional<Box>& limit) {
    return limit && !box.empty() && enclose(box, *limit) != *limit;
}

Plane moved(const Plane& plane, const glm::dmat4& motion) {
    if (motion == glm::dmat4(1.0)) {
        return plane;
    }
    const glm::dvec3 normal = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(motion))) * plane.normal);
    return {normal, glm::dot(normal, glm::dvec3(motion * glm::dvec4(plane.normal * plane.offset, 1.0)))};
}

template <typename T>
void sort_once(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

EditableScene::EditableScene(Scene& scene, Geometry& geometry)
    : scene_(scene),
      geometry_(geometry),
      planes_(geometry),
      whole_(geometry.leaves.size()),
      part_touched_(scene.parts.size(), 0) {
    room_.box = geometry.box;
    for (LeafId id = 0; id < geometry.leaves.size(); ++id) {
        const PlacedLeaf& leaf = geometry.leaves[id];
        if (!leaf.box.empty()) {
            room_.reach = std::max(room_.reach, largest_coordinate(leaf.box));
        }
        rest_.push_back(scene.leaves[id].to_world);
        PlacedLeaf uncut;
        uncut.solid = leaf.solid;
        (void)place_leaf(scene.leaves[id], geometry.flat, uncut);
        whole_[id] = uncut.box;
    }
    for (const Part& part : scene.parts) {
        limits_.push_back(trim_limit(scene, part, whole_));
    }
    is_touched_.assign(geometry.leaves.size(), 0);
    geometry.center = room_.center_for(geometry.box);
}

AddedId EditableScene::add(const Site& site, ExpressionKind operation, std::shared_ptr<const Solid> solid,
                           const glm::dmat4& to_world, const AddedLook& look) {
    PlacedLeaf placed;
    placed.solid = std::move(solid);
    return insert(site, operation, look, to_world, std::move(placed), {});
}

AddedId EditableScene::add(const Site& site, ExpressionKind operation, const Plane& half_space, const AddedLook& look) {
    PlacedLeaf placed;
    placed.solid = std::make_shared<const Solid>();
    return insert(site, operation, look, glm::dmat4(1.0), std::move(placed), {0, half_space, half_space});
}

AddedId EditableScene::insert(const Site& site, ExpressionKind operation, const AddedLook& look,
                              const glm::dmat4& to_world, PlacedLeaf placed, Added added) {
    settle();
    LeafInstance instance;
    instance.to_world = to_world;
    instance.color = look.color;
    instance.hatching = look.hatching;
    const LeafId id = insert_leaf(scene_, site, operation, instance);
    for (Added& other : added_) {
        other.leaf += other.leaf >= id ? 1 : 0;
    }
    geometry_.leaves.insert(geometry_.leaves.begin() + id, std::move(placed));
    rest_.insert(rest_.begin() + id, to_world);
    whole_.insert(whole_.begin() + id, Box{});
    is_touched_.insert(is_touched_.begin() + id, 0);
    planes_.leaf_inserted(id);
    added.leaf = id;
    added_.push_back(added);
    change_.structure = true;
    touch(id);
    return static_cast<AddedId>(added_.size() - 1);
}

void EditableScene::remove(AddedId added) {
    assert(added_[added].there);
    settle();
    const LeafId id = added_[added].leaf;
    PlacedLeaf& leaf = geometry_.leaves[id];
    const PlaneKeeper::Changed changed{id, std::move(leaf.planes)};
    leave_out(leaf);
    planes_.update({&changed, 1}, change_);
    planes_.leaf_erased(id);
    const PartId part = scene_.leaves[id].part;
    erase_leaf(scene_, id);
    geometry_.leaves.erase(geometry_.leaves.begin() + id);
    rest_.erase(rest_.begin() + id);
    whole_.erase(whole_.begin() + id);
    is_touched_.erase(is_touched_.begin() + id);
    added_[added] = {0, {}, {}, false};
    for (Added& other : added_) {
        other.leaf -= other.leaf > id ? 1 : 0;
    }
    part_touched_[part] = 1;
    change_.structure = true;
}

void EditableScene::touch(LeafId leaf) {
    part_touched_[scene_.leaves[leaf].part] = 1;
    if (is_touched_[leaf] == 0) {
        is_touched_[leaf] = 1;
        touched_.push_back(leaf);
    }
}

void EditableScene::move(LeafId leaf, const glm::dmat4& to_world) {
    rest_[leaf] = to_world;
    move_from_rest(leaf, glm::dmat4(1.0));
}

void EditableScene::move(AddedId half_space, const Plane& plane) {
    Added& added = added_[half_space];
    assert(added.there && added.rest);
    if (*added.plane != plane) {
        touch(added.leaf);
    }
    added.rest = added.plane = plane;
}

void EditableScene::move_from_rest(LeafId leaf, const glm::dmat4& motion) {
    const glm::dmat4 to_world = motion == glm::dmat4(1.0) ? rest_[leaf] : motion * rest_[leaf];
    if (to_world != scene_.leaves[leaf].to_world) {
        touch(leaf);
    }
    scene_.leaves[leaf].to_world = to_world;
}

void EditableScene::move_part(PartId id, const glm::dmat4& motion) {
    const Part& part = scene_.parts[id];
    for (LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
        Added* const half_space = this->half_space(leaf);
        if (half_space == nullptr) {
            move_from_rest(leaf, motion);
            continue;
        }
        const Plane plane = moved(*half_space->rest, motion);
        if (plane != *half_space->plane) {
            touch(leaf);
        }
        half_space->plane = plane;
    }
}

void EditableScene::move_occurrence(OccurrenceId occurrence, const glm::dmat4& motion) {
    const std::vector<char> below = occurrences_below(scene_, occurrence);
    for (LeafId leaf = 0; leaf < scene_.leaves.size(); ++leaf) {
        const OccurrenceId own = scene_.leaves[leaf].occurrence;
        if (own != kNoOccurrence && below[own] != 0) {
            move_from_rest(leaf, motion);
        }
    }
}

void EditableScene::show(PartId part, bool shown) {
    if (scene_.parts[part].hidden == !shown) {
        return;
    }
    scene_.parts[part].hidden = !shown;
    change_.parts.push_back(part);
}

EditableScene::Added* EditableScene::half_space(LeafId leaf) {
    const auto found =
        std::find_if(added_.begin(), added_.end(), [&](const Added& a) { return a.there && a.rest && a.leaf == leaf; });
    return found == added_.end() ? nullptr : &*found;
}

SceneChange EditableScene::commit() {
    settle();
    sort_once(change_.planes);
    sort_once(change_.leaves);
    sort_once(change_.parts);
    return std::exchange(change_, {});
}

void EditableScene::settle() {
    if (std::find(part_touched_.begin(), part_touched_.end(), char{1}) == part_touched_.end()) {
        return;
    }
    for (std::size_t i = 0; i < touched_.size(); ++i) {
        place_bounded(touched_[i]);
    }
    const std::size_t moved = touched_.size();
    for (PartId part = 0; part < scene_.parts.size(); ++part) {
        if (part_touched_[part] != 0) {
            touch_trimmed(part);  // Touches the part, too.
            part_touched_[part] = 0;
            change_.parts.push_back(part);
        }
    }
    for (std::size_t i = moved; i < touched_.size(); ++i) {
        place_bounded(touched_[i]);
    }
    place_touched();

    Box bounded;
    double largest = 0;
    for (LeafId id = 0; id < geometry_.leaves.size(); ++id) {
        const Box& box = geometry_.leaves[id].box;
        if (box.empty() || whole_[id] == everything()) {
            continue;
        }
        bounded = enclose(bounded, box);
        largest = std::max(largest, largest_coordinate(box));
    }
    geometry_.box = bounded;
    place_half_spaces(bounded);

    const std::optional<glm::dvec3> center = room_.center_for(geometry_.box);
    change_.center = change_.center || center != geometry_.center;
    geometry_.center = center;
    const double tolerance = coincidence_tolerance(room_.reach_for(largest));
    std::sort(changed_.begin(), changed_.end(), [](const auto& a, const auto& b) { return a.leaf < b.leaf; });
    if (tolerance != geometry_.planes.tolerance()) {
        planes_.assign_all(tolerance, change_);
    } else {
        planes_.update(changed_, change_);
    }
    for (const PlaneKeeper::Changed& changed : changed_) {
        is_touched_[changed.leaf] = 0;
        change_.leaves.push_back(changed.leaf);
    }
    changed_.clear();
    touched_.clear();
}

/// Without trimming it yet. Half-spaces wait.
void EditableScene::place_bounded(LeafId id) {
    PlacedLeaf& leaf = geometry_.leaves[id];
    changed_.push_back({id, std::move(leaf.planes)});
    leaf.planes.clear();
    leave_out(leaf);
    if (half_space(id) != nullptr) {
        whole_[id] = everything();
        return;
    }
    if (const std::string failure = place_leaf(scene_.leaves[id], geometry_.flat, leaf); !failure.empty()) {
        change_.failures.push_back(failure);
    }
    whole_[id] = leaf.box;
}

/// Where the part's limit has moved, leaves that it cuts, or that the one before has cut, are touched too.
void EditableScene::touch_trimmed(PartId id) {
    const Part& part = scene_.parts[id];
    const std::optional<Box> before = std::exchange(limits_[id], trim_limit(scene_, part, whole_));
    if (before == limits_[id]) {
        return;
    }
    for (LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
        if (whole_[leaf] != everything() &&
            (reaches_beyond(whole_[leaf], before) || reaches_beyond(whole_[leaf], limits_[id]))) {
            touch(leaf);
        }
    }
}

/// Trims them, and leaves out what place() would.
void EditableScene::place_touched() {
    for (const LeafId id : touched_) {
        PlacedLeaf& leaf = geometry_.leaves[id];
        const std::optional<Box>& limit = limits_[scene_.leaves[id].part];
        if (leaf.box.empty()) {
            continue;
        }
        if (limit && leaf.solid->closed) {
            trim_leaf(leaf, *limit);
        }
        if (leaf.box.empty()) {
            continue;
        }
        const std::string fault = fault_of_size(leaf, largest_coordinate(leaf.box));
        if (!fault.empty()) {
            change_.failures.push_back(fault);
        }
        if (!fault.empty() || (leaf.solid->closed && !has_volume(leaf.box))) {
            leave_out(leaf);
        }
    }
}

void EditableScene::place_half_spaces(const Box& bounded) {
    const bool any = std::any_of(added_.begin(), added_.end(), [](const Added& a) { return a.there && a.rest; });
    if (!any) {
        return;
    }
    const Box box = room_.around(bounded);
    if (box.empty()) {
        return;  // Nothing that they could be put to has a surface.
    }
    geometry_.box = enclose(geometry_.box, box);
    const bool others = box != std::exchange(half_space_box_, box);
    for (const Added& added : added_) {
        if (!added.there || !added.rest || (!others && is_touched_[added.leaf] == 0)) {
            continue;
        }
        if (is_touched_[added.leaf] == 0) {
            is_touched_[added.leaf] = 1;
            place_bounded(added.leaf);
        }
        const CutBox cut = cut_box(box, *added.plane);
        PlacedLeaf& leaf = geometry_.leaves[added.leaf];
        leaf.solid = cut.solid;
        (void)place_leaf(scene_.leaves[added.leaf], geometry_.flat, leaf);
        leaf.face = *added.plane;
        leaf.face_triangles = cut.face_triangles;
        if (!has_volume(leaf.box)) {
            leave_out(leaf);
        }
    }
}

}  // namespace csg::solid
