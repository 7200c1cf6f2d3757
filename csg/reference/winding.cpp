#include "csg/reference/winding.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace csg::reference {
namespace {

constexpr std::size_t kMostWords = std::size_t{1} << 29;  // 4 GiB of bits.

}  // namespace

InsideRule::InsideRule(const solid::Geometry& geometry) {
    even_odd_.reserve(geometry.leaves.size());
    for (const solid::PlacedLeaf& leaf : geometry.leaves)
        even_odd_.push_back(leaf.solid == nullptr || !leaf.solid->closed);
}

Covers InsideRule::sum(const Covers& a, const Covers& b, std::int32_t sign) const {
    Covers result;
    result.reserve(a.size() + b.size());
    for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
        Cover c;
        if (j == b.size() || (i < a.size() && a[i].leaf < b[j].leaf)) {
            c = a[i++];
        } else if (i == a.size() || b[j].leaf < a[i].leaf) {
            c = {b[j].leaf, reduced(b[j].leaf, sign * b[j].count)};
            ++j;
        } else {
            c = {a[i].leaf, reduced(a[i].leaf, a[i].count + sign * b[j].count)};
            ++i, ++j;
        }
        if (c.count != 0)
            result.push_back(c);
    }
    return result;
}

RegionWindings::RegionWindings(std::size_t regions, std::span<const LeafId> leaves, std::size_t all_leaves)
    : leaves_(leaves.size()), words_((leaves.size() + 63) / 64), place_(all_leaves, ~std::uint32_t{0}) {
    for (std::uint32_t i = 0; i < leaves.size(); ++i)
        place_[leaves[i]] = i;
    if (regions > kMostWords / std::max<std::size_t>(words_, 1))
        throw std::runtime_error(fmt::format(
            "{} objects cut space into {} regions, which is more than a mesh can be made of", leaves_, regions));
    bits_.assign(regions * words_, 0);
    exceptions_.resize(regions);
}

void RegionWindings::set(std::uint32_t region, LeafId leaf, std::int32_t count) {
    const std::uint32_t i = place_[leaf];
    std::uint64_t& word = bits_[region * words_ + i / 64];
    const std::uint64_t bit = std::uint64_t{1} << (i % 64);
    word = count != 0 ? word | bit : word & ~bit;
    Exceptions& exceptions = exceptions_[region];
    const bool exception = count != 0 && count != 1;
    if (!exception && exceptions.empty())
        return;
    const auto at = std::lower_bound(exceptions.begin(), exceptions.end(), i,
                                     [](const auto& e, std::uint32_t place) { return e.first < place; });
    const bool known = at != exceptions.end() && at->first == i;
    if (known && exception)
        at->second = count;
    else if (known)
        exceptions.erase(at);
    else if (exception)
        exceptions.insert(at, {i, count});
}

std::int32_t RegionWindings::count(std::uint32_t region, LeafId leaf) const {
    if (!inside(region, leaf))
        return 0;
    const std::uint32_t i = place_[leaf];
    const Exceptions& exceptions = exceptions_[region];
    const auto at = std::lower_bound(exceptions.begin(), exceptions.end(), i,
                                     [](const auto& e, std::uint32_t place) { return e.first < place; });
    return at != exceptions.end() && at->first == i ? at->second : 1;
}

void RegionWindings::pass(std::uint32_t from, std::uint32_t to, const Covers& covers, std::int32_t sign,
                          const InsideRule& rule) {
    for (std::size_t w = 0; w < words_; ++w)
        bits_[to * words_ + w] = bits_[from * words_ + w];
    exceptions_[to] = exceptions_[from];
    for (const Cover& c : covers)
        set(to, c.leaf, rule.reduced(c.leaf, count(to, c.leaf) + sign * c.count));
}

bool RegionWindings::fits(std::uint32_t from, std::uint32_t to, const Covers& covers, std::int32_t sign,
                          const InsideRule& rule) const {
    // Where both hold only zeros and ones, all bits but those of the covers are compared as words.
    std::size_t differing = 0;
    for (const Cover& c : covers) {
        if (rule.reduced(c.leaf, count(from, c.leaf) + sign * c.count) != count(to, c.leaf))
            return false;
        differing += inside(from, c.leaf) != inside(to, c.leaf) ? 1 : 0;
    }
    std::size_t bits = 0;
    for (std::size_t w = 0; w < words_; ++w)
        bits += static_cast<std::size_t>(std::popcount(bits_[from * words_ + w] ^ bits_[to * words_ + w]));
    if (bits != differing)
        return false;
    const auto others_equal = [&](const Exceptions& a, std::uint32_t other) {
        return std::all_of(a.begin(), a.end(), [&](const auto& e) {
            const auto covered = [&](const Cover& c) { return place_[c.leaf] == e.first; };
            const auto& b = exceptions_[other];
            return std::find(b.begin(), b.end(), e) != b.end() || std::any_of(covers.begin(), covers.end(), covered);
        });
    };
    return others_equal(exceptions_[from], to) && others_equal(exceptions_[to], from);
}

}  // namespace csg::reference
