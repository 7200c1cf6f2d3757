#include "ui/pipeline/model_parts.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include <fmt/format.h>

namespace ui {

namespace {

std::string place_of(const csg::Tree& tree, const csg::SourceLocation& where) {
    if (!where.known() || where.file >= tree.files().size()) {
        return "";
    }
    return fmt::format("{}:{}:{}: ", tree.files()[where.file], where.line, where.column);
}

}  // namespace

PartProducts products_of(const Model& model, const csg::Part& part, std::span<const csg::Box> boxes,
                         const goldfeather::Budget& budget, ModelStatistics& sum) {
    goldfeather::NormalizationStats stats;
    auto normalized = goldfeather::normalize(model.scene, part, boxes, budget, stats);
    if (const auto* over = std::get_if<goldfeather::OverBudget>(&normalized)) {
        const auto& where = model.scene.leaves[part.first_leaf].where;
        return {{},
                fmt::format("{}the part that begins here needs more than {} products ({} were made); "
                            "differences and intersections of large unions multiply",
                            place_of(*model.tree, where), budget.products, over->products),
                csg::bounds(model.scene, part, boxes)};
    }
    sum.products_unpruned = std::min(1e18, sum.products_unpruned + stats.products_unpruned);
    sum.products += stats.products;
    sum.literals += stats.literals;
    sum.pruned_products += stats.pruned_products;
    sum.pruned_literals += stats.pruned_literals;
    PartProducts made;
    if (auto* found = std::get_if<goldfeather::SumOfProducts>(&normalized)) {
        made.products = std::move(found->products);
    }
    for (const goldfeather::Product& product : made.products) {
        made.box = csg::enclose(made.box, product.box);
    }
    return made;
}

std::uint64_t next_generation() {
    static std::atomic<std::uint64_t> count{0};
    return ++count;
}

}  // namespace ui
