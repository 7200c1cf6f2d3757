#include "goldfeather/goldfeather/screen_plan.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace goldfeather {
namespace {

constexpr std::uint32_t kTile = 32;

PixelBox pixels(const base::View& view, const csg::Box& box) {
    if (box.empty()) {
        return {};
    }
    const base::View::Rectangle r = view.screen_box(box.lo, box.hi);
    if (r.empty()) {
        return {};
    }
    return {static_cast<std::uint32_t>(r.x0), static_cast<std::uint32_t>(r.y0), static_cast<std::uint32_t>(r.x1),
            static_cast<std::uint32_t>(r.y1)};
}

PixelBox intersect(const PixelBox& a, const PixelBox& b) {
    const PixelBox both{std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
    return both.empty() ? PixelBox{} : both;
}

/// A leaf's part in a product.
struct Role {
    std::uint32_t product = 0;
    bool complement = false;
    bool operator==(const Role&) const = default;
};

struct Leaf {
    PixelBox box;
    csg::LeafId id = 0;
    std::uint32_t slot = 0;
    std::vector<Role> roles;  ///< By product.
};

class Planner {
  public:
    Planner(const base::View& view, std::span<const Product> products, std::span<const csg::Box> leaf_boxes,
            std::span<const char> wound)
        : view_(view), products_(products), leaf_boxes_(leaf_boxes), wound_(wound) {}

    ScreenPlan make() {
        place();
        assign_slots();
        write_products();
        write_tiles();
        return std::move(plan_);
    }

  private:
    void place() {
        std::unordered_map<csg::LeafId, PixelBox> boxes;
        const auto box_of = [&](csg::LeafId leaf) {
            const auto [it, added] = boxes.try_emplace(leaf);
            if (added) {
                it->second = pixels(view_, leaf_boxes_[leaf]);
            }
            return it->second;
        };
        std::unordered_map<csg::LeafId, std::size_t> index;
        for (const Product& product : products_) {
            PixelBox box{0, 0, std::numeric_limits<std::uint32_t>::max(), std::numeric_limits<std::uint32_t>::max()};
            for (const Literal& literal : product.literals) {
                if (!literal.complement) {
                    box = intersect(box, box_of(literal.leaf));
                }
            }
            box = intersect(box, pixels(view_, product.box));
            if (box.empty()) {
                continue;
            }
            const auto number = static_cast<std::uint32_t>(product_boxes_.size());
            product_boxes_.push_back(box);
            plan_.box = plan_.box.empty() ? box
                                          : PixelBox{std::min(plan_.box.x0, box.x0), std::min(plan_.box.y0, box.y0),
                                                     std::max(plan_.box.x1, box.x1), std::max(plan_.box.y1, box.y1)};
            for (const Literal& literal : product.literals) {
                if (!overlap(box_of(literal.leaf), box)) {
                    continue;  // a complement that the product never meets on the screen
                }
                const auto [it, added] = index.try_emplace(literal.leaf, leaves_.size());
                if (added) {
                    leaves_.push_back({box_of(literal.leaf), literal.leaf, 0, {}});
                }
                leaves_[it->second].roles.push_back({number, literal.complement});
            }
        }
        std::sort(leaves_.begin(), leaves_.end(), [](const Leaf& a, const Leaf& b) { return a.id < b.id; });
    }

    /// Could a product that means `a` see the bit of `b`?
    [[nodiscard]] bool confused(const Leaf& a, const Leaf& b) const {
        for (const Role& role : a.roles) {
            if (!overlap(product_boxes_[role.product], b.box)) {
                continue;
            }
            const auto at = std::lower_bound(b.roles.begin(), b.roles.end(), role.product,
                                             [](const Role& r, std::uint32_t product) { return r.product < product; });
            if (at == b.roles.end() || *at != role) {
                return true;
            }
        }
        return false;
    }

    [[nodiscard]] bool is_wound(csg::LeafId leaf) const { return !wound_.empty() && wound_[leaf] != 0; }

    void assign_slots() {
        plan_.slots = assign_slots(false);
        plan_.counters = assign_slots(true);
        for (Leaf& leaf : leaves_) {
            if (is_wound(leaf.id)) {
                leaf.slot = 32 * (plan_.first_counter() + leaf.slot);
            }
            plan_.leaves.push_back({leaf.box, leaf.id, leaf.slot});
        }
    }

    /// Of the leaves that are wound, or of the others; gives how many there are.
    std::uint32_t assign_slots(bool wound) {
        std::vector<std::vector<const Leaf*>> slots;
        for (Leaf& leaf : leaves_) {
            if (is_wound(leaf.id) != wound) {
                continue;
            }
            std::size_t slot = 0;
            for (; slot < slots.size(); ++slot) {
                if (std::none_of(slots[slot].begin(), slots[slot].end(), [&](const Leaf* other) {
                        return overlap(other->box, leaf.box) || confused(*other, leaf) || confused(leaf, *other);
                    })) {
                    break;
                }
            }
            if (slot == slots.size()) {
                slots.emplace_back();
            }
            slots[slot].push_back(&leaf);
            leaf.slot = static_cast<std::uint32_t>(slot);
        }
        return static_cast<std::uint32_t>(slots.size());
    }

    void write_products() {
        std::vector<std::vector<Entry>> entries(product_boxes_.size());
        for (const Leaf& leaf : leaves_) {
            for (const Role& role : leaf.roles) {
                auto& list = entries[role.product];
                const std::uint32_t word = leaf.slot / 32, bit = 1U << (leaf.slot % 32);
                auto at = std::find_if(list.begin(), list.end(), [&](const Entry& e) { return e.word == word; });
                if (at == list.end()) {
                    at = list.insert(list.end(), Entry{word, 0, 0, 0});
                }
                (role.complement ? at->clear : at->set) |= bit;
            }
        }
        for (std::size_t i = 0; i < entries.size(); ++i) {
            plan_.products.push_back({product_boxes_[i], static_cast<std::uint32_t>(plan_.entries.size()),
                                      static_cast<std::uint32_t>(entries[i].size())});
            plan_.entries.insert(plan_.entries.end(), entries[i].begin(), entries[i].end());
        }
    }

    void write_tiles() {
        if (plan_.box.empty()) {
            return;
        }
        const std::uint32_t tx0 = plan_.box.x0 / kTile, ty0 = plan_.box.y0 / kTile;
        const std::uint32_t columns = (plan_.box.x1 - 1) / kTile - tx0 + 1, rows = (plan_.box.y1 - 1) / kTile - ty0 + 1;
        std::vector<std::vector<std::uint32_t>> products(columns * rows), leaves(columns * rows);
        const auto spread = [&](const PixelBox& box, std::uint32_t item, auto& lists) {
            const PixelBox in = intersect(box, plan_.box);
            if (in.empty()) {
                return;
            }
            for (std::uint32_t y = in.y0 / kTile - ty0; y <= (in.y1 - 1) / kTile - ty0; ++y) {
                for (std::uint32_t x = in.x0 / kTile - tx0; x <= (in.x1 - 1) / kTile - tx0; ++x) {
                    lists[y * columns + x].push_back(item);
                }
            }
        };
        for (std::uint32_t i = 0; i < plan_.products.size(); ++i) {
            spread(plan_.products[i].box, i, products);
        }
        for (std::uint32_t i = 0; i < plan_.leaves.size(); ++i) {
            spread(plan_.leaves[i].box, i, leaves);
        }
        for (std::uint32_t y = 0; y < rows; ++y) {
            for (std::uint32_t x = 0; x < columns; ++x) {
                const auto& p = products[y * columns + x];
                const auto& l = leaves[y * columns + x];
                if (p.empty()) {
                    continue;
                }
                Tile tile;
                tile.box = intersect(
                    plan_.box, {(tx0 + x) * kTile, (ty0 + y) * kTile, (tx0 + x + 1) * kTile, (ty0 + y + 1) * kTile});
                tile.first_product = static_cast<std::uint32_t>(plan_.tile_products.size());
                tile.product_count = static_cast<std::uint32_t>(p.size());
                tile.first_leaf = static_cast<std::uint32_t>(plan_.tile_leaves.size());
                tile.leaf_count = static_cast<std::uint32_t>(l.size());
                plan_.tile_products.insert(plan_.tile_products.end(), p.begin(), p.end());
                plan_.tile_leaves.insert(plan_.tile_leaves.end(), l.begin(), l.end());
                plan_.tiles.push_back(tile);
            }
        }
    }

    const base::View& view_;
    std::span<const Product> products_;
    std::span<const csg::Box> leaf_boxes_;
    std::span<const char> wound_;
    std::vector<PixelBox> product_boxes_;
    std::vector<Leaf> leaves_;
    ScreenPlan plan_;
};

}  // namespace

ScreenPlan plan(const base::View& view, std::span<const Product> products, std::span<const csg::Box> leaf_boxes,
                std::span<const char> wound) {
    return Planner(view, products, leaf_boxes, wound).make();
}

}  // namespace goldfeather
