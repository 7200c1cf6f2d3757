#include "csg/reference/region_values.h"

#include "base/stop.h"
#include "csg/tree/hash.h"

namespace csg::reference {
namespace {

class Walk {
  public:
    Walk(const CellComplex& complex, const GroupExpression& expression, const InsideRule& rule,
         const std::stop_token& stop)
        : complex_(complex),
          rule_(rule),
          paced_(stop),
          expression_(expression),
          counts_(expression.leaves.size(), 0),
          known_(complex.regions, 0),
          sums_(complex.regions, 0) {
        values_.solid.assign(complex.regions, 0);
        values_.owners.assign(complex.cells.size(), 0);
        list_neighbors();
    }

    RegionValues run() {
        for (const auto& [region, windings] : complex_.pieces) {
            pass(windings, 1);
            walk(region);
            pass(windings, -1);
        }
        return std::move(values_);
    }

  private:
    /// A region on the way, with the cell it was entered through.
    struct Step {
        std::uint32_t region, next;
        const ComplexCell* through;
        std::int32_t sign;
    };

    void list_neighbors() {
        first_.assign(complex_.regions + 1, 0);
        for (const ComplexCell& cell : complex_.cells) {
            ++first_[cell.above + 1];
            ++first_[cell.below + 1];
        }
        for (std::size_t i = 0; i < complex_.regions; ++i) {
            first_[i + 1] += first_[i];
        }
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        cells_.resize(2 * complex_.cells.size());
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            cells_[next[complex_.cells[c].above]++] = c;
            cells_[next[complex_.cells[c].below]++] = c;
        }
    }

    static std::uint64_t weight(LeafId leaf) { return mix(0x9e3779b97f4a7c15, std::uint64_t{leaf}); }

    [[nodiscard]] std::int32_t beyond(const Cover& cover, std::int32_t sign) const {
        return rule_.reduced(cover.leaf, counts_[cover.leaf] + sign * cover.count);
    }

    void pass(const Covers& covers, std::int32_t sign) {
        for (const Cover& cover : covers) {
            std::int32_t& count = counts_[cover.leaf];
            const std::int32_t now = beyond(cover, sign);
            sum_ += weight(cover.leaf) * static_cast<std::uint64_t>(static_cast<std::int64_t>(now) - count);
            if ((count != 0) != (now != 0)) {
                expression_.set(cover.leaf, now != 0);
            }
            count = now;
        }
    }

    void walk(std::uint32_t seed) {
        enter(seed);
        stack_.assign(1, {seed, first_[seed], nullptr, 0});
        while (!stack_.empty()) {
            Step& step = stack_.back();
            if (step.next == first_[step.region + 1]) {
                if (step.through != nullptr) {
                    pass(step.through->covers, -step.sign);
                }
                stack_.pop_back();
                continue;
            }
            const ComplexCell& cell = complex_.cells[cells_[step.next++]];
            const bool down = cell.above == step.region;
            const std::uint32_t to = down ? cell.below : cell.above;
            if (known_[to] != 0) {
                continue;
            }
            const std::int32_t sign = down ? 1 : -1;
            pass(cell.covers, sign);
            enter(to);
            stack_.push_back({to, first_[to], &cell, sign});
        }
    }

    void enter(std::uint32_t region) {
        known_[region] = 1;
        sums_[region] = sum_;
        const bool solid = expression_.value();
        values_.solid[region] = solid ? 1 : 0;
        for (std::uint32_t i = first_[region]; i < first_[region + 1]; ++i) {
            paced_();
            const ComplexCell& cell = complex_.cells[cells_[i]];
            const bool down = cell.above == region;
            check(cell, down ? cell.below : cell.above, down ? 1 : -1);
            if (solid) {
                values_.owners[cells_[i]] = owner(cell.covers, down ? 1 : -1);
            }
        }
    }

    void check(const ComplexCell& cell, std::uint32_t other, std::int32_t sign) const {
        if (known_[other] == 0) {
            return;
        }
        std::uint64_t sum = sum_;
        for (const Cover& c : cell.covers) {
            sum += weight(c.leaf) *
                   static_cast<std::uint64_t>(static_cast<std::int64_t>(beyond(c, sign)) - counts_[c.leaf]);
        }
        if (sum != sums_[other]) {
            throw Undecided("the regions between the faces do not fit together");
        }
    }

    LeafId owner(const Covers& covers, std::int32_t sign) {
        if (covers.size() == 1) {
            return covers[0].leaf;
        }
        switching_.clear();
        for (const Cover& c : covers) {
            if ((counts_[c.leaf] != 0) != (beyond(c, sign) != 0)) {
                switching_.push_back(c.leaf);
            }
        }
        return switching_.empty() ? 0 : switching_.size() == 1 ? switching_[0] : expression_.owner(switching_);
    }

    const CellComplex& complex_;
    const InsideRule& rule_;
    base::PacedStop paced_;
    ExpressionValue expression_;
    std::vector<std::int32_t> counts_;          ///< By leaf: where the walk is.
    std::uint64_t sum_ = 0;                     ///< Of the counts, weighted.
    std::vector<std::uint32_t> first_, cells_;  ///< Cells at each region, those of region r from first_[r] on.
    std::vector<char> known_;
    std::vector<std::uint64_t> sums_;  ///< By region.
    std::vector<Step> stack_;
    std::vector<LeafId> switching_;
    RegionValues values_;
};

}  // namespace

RegionValues evaluate_regions(const CellComplex& complex, const GroupExpression& expression, const InsideRule& rule,
                              const std::stop_token& stop) {
    return Walk(complex, expression, rule, stop).run();
}

}  // namespace csg::reference
