#include "csg/solid/plane_keeper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

#include "csg/solid/assign_planes.h"
#include "csg/solid/no_index.h"

namespace csg::solid {
namespace {

constexpr int kLeafBits = 26, kTriangleBits = 26;
constexpr std::uint64_t kTriangles = (std::uint64_t{1} << kTriangleBits) - 1;
constexpr std::uint64_t kLeaf = std::uint64_t{1} << kTriangleBits;

/// Where more than one in so many triangles has changed, all planes are assigned: that takes no longer then.
constexpr std::size_t kFewIn = 4;
/// Holes that may be, besides half as many as there are entries.
constexpr std::size_t kHoles = 1024;

/// Can no point of the box lie within the tolerance of both?
bool apart_in(const Box& box, const Plane& a, const Plane& b, double tolerance) {
    const double side = glm::dot(a.normal, b.normal) < 0 ? -1 : 1;
    const glm::dvec3 slope = a.normal - side * b.normal;
    const double middle = glm::dot(slope, box.center()) - (a.offset - side * b.offset);
    const double most = glm::dot(glm::abs(slope), 0.5 * box.size());
    return std::abs(middle) - most > 4 * tolerance;
}

}  // namespace

/// An entry that an update makes. Until all are found, they stand behind those that there are.
struct PlaneKeeper::Made {
    Key key;
    Plane plane;
    std::uint32_t entry = kNone;  ///< Where it is to stand.
    bool revived = false;         ///< As it did before.
};

struct PlaneKeeper::Update {
    std::span<const Changed> leaves;
    std::vector<std::uint32_t> given_up;  ///< Entries that these leaves had made, in order; holes until …
    std::vector<Key> items;               ///< The triangles of these leaves, in order, and …
    std::vector<std::uint32_t> entries;   ///< … the entry of each.
    std::uint32_t first_made = 0;
    std::vector<Made> made;              ///< In order.
    std::vector<std::uint32_t> revived;  ///< Entries of those that stand where they did, in order.
};

PlaneKeeper::PlaneKeeper(Geometry& geometry) : geometry_(geometry) {
    count_users();
}

PlaneKeeper::Key PlaneKeeper::key_of(const PlacedLeaf& placed, LeafId leaf, std::uint32_t triangle) {
    const auto narrow = static_cast<std::uint64_t>(2047 - accuracy(placed, triangle));
    return narrow << (kLeafBits + kTriangleBits) | std::uint64_t{leaf} << kTriangleBits | triangle;
}

LeafId PlaneKeeper::leaf_of(Key key) {
    return static_cast<LeafId>(key >> kTriangleBits & ((std::uint64_t{1} << kLeafBits) - 1));
}

PlaneKeeper::Key PlaneKeeper::key(const Update& update, std::uint32_t entry) const {
    return entry < update.first_made ? keys_[entry] : update.made[entry - update.first_made].key;
}

/// The first triangle that uses an entry has made it.
void PlaneKeeper::count_users() {
    const std::size_t entries = geometry_.planes.planes().size();
    keys_.assign(entries, std::numeric_limits<Key>::max());
    users_.assign(entries, 0);
    for (LeafId id = 0; id < geometry_.leaves.size(); ++id) {
        const PlacedLeaf& leaf = geometry_.leaves[id];
        for (std::uint32_t t = 0; t < leaf.planes.size(); ++t) {
            const std::uint32_t entry = leaf.planes[t].index;
            keys_[entry] = std::min(keys_[entry], key_of(leaf, id, t));
            ++users_[entry];
        }
    }
}

void PlaneKeeper::assign_all(double tolerance, SceneChange& change) {
    geometry_.planes = PlaneTable(tolerance);
    assign_planes(geometry_);
    count_users();
    change.all_planes = true;
}

void PlaneKeeper::update(std::span<const Changed> leaves, SceneChange& change) {
    std::size_t changed = 0;
    for (const Changed& leaf : leaves) {
        changed += geometry_.leaves[leaf.leaf].triangles.size();
    }
    std::size_t all = 0;
    for (const PlacedLeaf& leaf : geometry_.leaves) {
        all += leaf.triangles.size();
    }
    if (changed * kFewIn > all) {
        assign_all(geometry_.planes.tolerance(), change);
        return;
    }
    Update update{leaves, {}, {}, {}, static_cast<std::uint32_t>(keys_.size()), {}, {}};
    take_back(update);
    find_entries(update);
    revive(update);
    if (concerns_others(update)) {
        assign_all(geometry_.planes.tolerance(), change);
        return;
    }
    if (find_holes(update)) {
        fill_holes(update, change);
    } else {
        make_holes(update, change);
    }
}

void PlaneKeeper::take_back(Update& update) {
    for (const Changed& leaf : update.leaves) {
        for (std::uint32_t t = 0; t < leaf.before.size(); ++t) {
            const std::uint32_t entry = leaf.before[t].index;
            --users_[entry];
            if (leaf_of(keys_[entry]) == leaf.leaf && (keys_[entry] & kTriangles) == t) {
                update.given_up.push_back(entry);
            }
        }
    }
    std::sort(update.given_up.begin(), update.given_up.end());
    for (const std::uint32_t entry : update.given_up) {
        geometry_.planes.make_hole(entry);
    }
}

void PlaneKeeper::find_entries(Update& update) {
    for (const Changed& changed : update.leaves) {
        PlacedLeaf& leaf = geometry_.leaves[changed.leaf];
        leaf.planes.resize(leaf.triangles.size());
        for (std::uint32_t t = 0; t < leaf.triangles.size(); ++t) {
            update.items.push_back(key_of(leaf, changed.leaf, t));
        }
    }
    std::sort(update.items.begin(), update.items.end());
    std::vector<std::uint32_t> found;
    for (const Key item : update.items) {
        PlacedLeaf& leaf = geometry_.leaves[leaf_of(item)];
        const auto triangle = static_cast<std::uint32_t>(item & kTriangles);
        const glm::uvec3& t = leaf.triangles[triangle];
        const Plane own = plane_of(leaf, triangle);
        found.clear();
        geometry_.planes.find_all(own, leaf.points[t.x], leaf.points[t.y], leaf.points[t.z], found);
        std::uint32_t entry = kNone;
        for (const std::uint32_t other : found) {
            if (key(update, other) < item && (entry == kNone || key(update, other) < key(update, entry))) {
                entry = other;
            }
        }
        if (entry == kNone) {
            entry = update.first_made + static_cast<std::uint32_t>(update.made.size());
            geometry_.planes.fill_hole(entry, own);
            update.made.push_back({item, own});
        }
        update.entries.push_back(entry);
        leaf.planes[triangle].flipped = glm::dot(geometry_.planes.planes()[entry].normal, own.normal) < 0;
    }
}

/// What is made as it was before has its old place.
void PlaneKeeper::revive(Update& update) const {
    for (Made& made : update.made) {
        const auto at = std::lower_bound(update.given_up.begin(), update.given_up.end(), made.key,
                                         [&](std::uint32_t entry, Key key) { return keys_[entry] < key; });
        if (at != update.given_up.end() && keys_[*at] == made.key && geometry_.planes.planes()[*at] == made.plane) {
            made.entry = *at;
            made.revived = true;
            update.revived.push_back(*at);
        }
    }
}

bool PlaneKeeper::concerns_others(const Update& update) const {
    const auto lost_to_others = [&](std::uint32_t entry) {
        return users_[entry] > 0 && !std::binary_search(update.revived.begin(), update.revived.end(), entry);
    };
    if (std::any_of(update.given_up.begin(), update.given_up.end(), lost_to_others)) {
        return true;
    }
    // Triangles that come later, and may lie in an entry that is made now.
    std::vector<const Made*> near_others;
    std::vector<std::uint32_t> near;
    for (const Made& made : update.made) {
        near.clear();
        if (!made.revived) {
            geometry_.planes.find_near(made.plane, near);
        }
        const bool concerns = std::any_of(near.begin(), near.end(), [&](std::uint32_t entry) {
            return entry < update.first_made && users_[entry] > 0 && keys_[entry] > made.key &&
                   !apart_in(geometry_.box, made.plane, geometry_.planes.planes()[entry], geometry_.planes.tolerance());
        });
        if (concerns) {
            near_others.push_back(&made);
        }
    }
    return !near_others.empty() && any_would_share(update, near_others);
}

bool PlaneKeeper::any_would_share(const Update& update, std::span<const Made* const> made) const {
    for (LeafId id = 0; id < geometry_.leaves.size(); ++id) {
        if (std::any_of(update.leaves.begin(), update.leaves.end(), [&](const Changed& c) { return c.leaf == id; })) {
            continue;
        }
        const PlacedLeaf& leaf = geometry_.leaves[id];
        for (std::uint32_t t = 0; t < leaf.planes.size(); ++t) {
            const Key taken = keys_[leaf.planes[t].index];
            const glm::uvec3& corners = leaf.triangles[t];
            const glm::dvec3 &a = leaf.points[corners.x], &b = leaf.points[corners.y], &c = leaf.points[corners.z];
            for (const Made* m : made) {
                if (m->key < taken &&
                    std::abs(glm::dot(m->plane.normal, a) - m->plane.offset) <= geometry_.planes.tolerance() &&
                    geometry_.planes.shares(m->plane, plane_of(leaf, t), a, b, c)) {
                    return true;
                }
            }
        }
    }
    return false;
}

/// Gives entries that are made now places in order. False where there are not enough holes.
bool PlaneKeeper::find_holes(Update& update) {
    std::unordered_set<std::size_t> occupied(update.revived.begin(), update.revived.end());  // Holes to be filled.
    const auto is_free = [&](std::size_t entry) {
        return entry < users_.size() && users_[entry] == 0 && !occupied.contains(entry);
    };
    for (std::size_t m = 0; m < update.made.size(); ++m) {
        Made& made = update.made[m];
        if (made.revived) {
            continue;
        }
        auto at = static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), made.key) - keys_.begin());
        if (!is_free(at)) {
            // The nearest one before it, with those between, which are new as well, moved up.
            std::size_t last_new = m;
            while (at > 0 && last_new > 0 && !update.made[last_new - 1].revived &&
                   update.made[last_new - 1].entry == at - 1) {
                --at;
                --last_new;
            }
            if (at == 0 || !is_free(at - 1)) {
                return false;
            }
            occupied.insert(at - 1);
            for (std::size_t i = last_new; i <= m; ++i) {
                update.made[i].entry = static_cast<std::uint32_t>(at - 1 + (i - last_new));
                keys_[update.made[i].entry] = update.made[i].key;
            }
            continue;
        }
        made.entry = static_cast<std::uint32_t>(at);
        occupied.insert(at);
        keys_[at] = made.key;
    }
    return true;
}

void PlaneKeeper::fill_holes(Update& update, SceneChange& change) {
    for (std::size_t i = update.made.size(); i-- > 0;) {
        geometry_.planes.make_hole(update.first_made + static_cast<std::uint32_t>(i));
        geometry_.planes.drop_last();
    }
    for (const Made& made : update.made) {
        geometry_.planes.fill_hole(made.entry, made.plane);
        if (!made.revived) {
            change.planes.push_back(made.entry);
        }
    }
    for (std::size_t i = 0; i < update.items.size(); ++i) {
        const std::uint32_t entry = update.entries[i];
        const std::uint32_t at = entry < update.first_made ? entry : update.made[entry - update.first_made].entry;
        geometry_.leaves[leaf_of(update.items[i])].planes[update.items[i] & kTriangles].index = at;
        ++users_[at];
    }
}

/// Puts entries that are made now between the others. Too many holes go then.
void PlaneKeeper::make_holes(Update& update, SceneChange& change) {
    const auto live = static_cast<std::size_t>(
        std::count_if(users_.begin(), users_.end(), [](std::uint32_t users) { return users > 0; }));
    const bool keep = users_.size() - live <= live / 2 + kHoles;
    std::vector<std::uint32_t> from;
    std::vector<Key> keys;
    std::size_t next = 0;  // Of those made.
    const auto put = [&](std::uint32_t entry, Key key) {
        from.push_back(entry);
        keys.push_back(key);
    };
    const auto put_made_before = [&](Key key) {
        for (; next < update.made.size() && update.made[next].key <= key; ++next) {
            put(update.first_made + static_cast<std::uint32_t>(next), update.made[next].key);
        }
    };
    for (std::uint32_t entry = 0; entry < update.first_made; ++entry) {
        put_made_before(keys_[entry]);
        const bool revived =
            users_[entry] > 0 && std::binary_search(update.given_up.begin(), update.given_up.end(), entry);
        if (!revived && (users_[entry] > 0 || keep)) {
            put(entry, keys_[entry]);
        }
    }
    put_made_before(std::numeric_limits<Key>::max());

    std::vector<std::uint32_t> place(update.first_made + update.made.size(), kNone), users(from.size(), 0);
    for (std::uint32_t i = 0; i < from.size(); ++i) {
        place[from[i]] = i;
    }
    for (std::size_t i = 0; i < update.items.size(); ++i) {
        geometry_.leaves[leaf_of(update.items[i])].planes[update.items[i] & kTriangles].index = update.entries[i];
    }
    // Others may use what has been made again as it was.
    for (const Made& made : update.made) {
        if (made.revived) {
            place[made.entry] = place[update.first_made + static_cast<std::uint32_t>(&made - update.made.data())];
        }
    }
    geometry_.planes.rearrange(from);
    for (PlacedLeaf& leaf : geometry_.leaves) {
        for (PlaneRef& plane : leaf.planes) {
            plane.index = place[plane.index];
            ++users[plane.index];
        }
    }
    keys_ = std::move(keys);
    users_ = std::move(users);
    change.all_planes = true;
}

void PlaneKeeper::leaf_inserted(LeafId at) {
    for (Key& key : keys_) {
        key += leaf_of(key) >= at ? kLeaf : 0;
    }
}

void PlaneKeeper::leaf_erased(LeafId at) {
    for (Key& key : keys_) {
        if (leaf_of(key) > at) {
            key -= kLeaf;
        } else if (leaf_of(key) == at) {  // A hole: not behind what follows.
            key &= ~kTriangles;
        }
    }
}

}  // namespace csg::solid
