// What is inside a leaf: winding numbers, or evenness where a leaf's surface is not one (DESIGN, section 3, rule 6).
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "csg/solid/placed.h"

namespace csg::reference {

/// How often the faces of a leaf cover a place, or wind around it; never 0.
struct Cover {
    LeafId leaf = 0;
    std::int32_t count = 0;
    bool operator==(const Cover&) const = default;
};
using Covers = std::vector<Cover>;  ///< Sorted by leaf.

class InsideRule {
  public:
    explicit InsideRule(const solid::Geometry& geometry);

    /// The count itself for a closed leaf, 0 or 1 for any other.
    [[nodiscard]] std::int32_t reduced(LeafId leaf, std::int32_t count) const {
        return even_odd_[leaf] != 0 ? count & 1 : count;
    }
    /// a + sign · b, reduced.
    [[nodiscard]] Covers sum(const Covers& a, const Covers& b, std::int32_t sign) const;

  private:
    std::vector<char> even_odd_;  ///< By leaf.
};

/// The winding numbers of the leaves in each of so many regions. A bit for each tells whether it is 0; what is neither
/// 0 nor 1, which few leaves have anywhere, is kept beside the bits.
class RegionWindings {
  public:
    RegionWindings() = default;
    /// `leaves`: sorted; their places are the places of the bits. Throws std::runtime_error where they are too many.
    RegionWindings(std::size_t regions, std::span<const LeafId> leaves, std::size_t all_leaves);

    void set(std::uint32_t region, LeafId leaf, std::int32_t count);
    [[nodiscard]] std::int32_t count(std::uint32_t region, LeafId leaf) const;
    [[nodiscard]] bool inside(std::uint32_t region, LeafId leaf) const {
        const std::size_t i = place_[leaf];
        return i < leaves_ && (bits_[region * words_ + i / 64] >> (i % 64) & 1) != 0;
    }

    /// Makes `to` what `from` and the covers between them tell.
    void pass(std::uint32_t from, std::uint32_t to, const Covers& covers, std::int32_t sign, const InsideRule& rule);
    /// Is `to` what `from` and the covers between them tell?
    [[nodiscard]] bool fits(std::uint32_t from, std::uint32_t to, const Covers& covers, std::int32_t sign,
                            const InsideRule& rule) const;

  private:
    using Exceptions = std::vector<std::pair<std::uint32_t, std::int32_t>>;  // place and count, sorted

    std::size_t leaves_ = 0, words_ = 0;
    std::vector<std::uint32_t> place_;  ///< By leaf; beyond `leaves_` for those that do not take part.
    std::vector<std::uint64_t> bits_;   ///< By region, `words_` each.
    std::vector<Exceptions> exceptions_;
};

}  // namespace csg::reference
