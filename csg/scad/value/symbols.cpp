#include "csg/scad/value/symbols.h"

#include <algorithm>
#include <cstring>

namespace csg::scad {

namespace {

std::uint64_t load(const char* bytes, std::size_t count) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, count);
    return word;
}

std::uint64_t mixed(std::uint64_t x) {
    x *= 0x9e3779b97f4a7c15U;
    return x ^ x >> 29;
}

}  // namespace

std::uint64_t SymbolTable::hash_of(std::string_view text) {
    std::uint64_t hash = text.size();
    std::size_t at = 0;
    for (; at + 8 <= text.size(); at += 8) {
        hash = mixed(hash ^ load(text.data() + at, 8));
    }
    // The rest in two pieces that overlap: sizes known beforehand make memcpy one load.
    const std::size_t rest = text.size() - at;
    const char* const tail = text.data() + at;
    std::uint64_t word = 0;
    if (rest >= 4) {
        word = load(tail, 4) | load(tail + rest - 4, 4) << 32U;
    } else if (rest >= 2) {
        word = load(tail, 2) | load(tail + rest - 2, 2) << 16U;
    } else if (rest == 1) {
        word = load(tail, 1);
    }
    return mixed(mixed(hash ^ word));
}

void SymbolTable::grow() {
    constexpr std::size_t kFirst = 1024;
    slots_.assign(std::max(kFirst, 2 * slots_.size()), {});
    for (Symbol symbol = 0; symbol < texts_.size(); ++symbol) {
        const std::uint64_t hash = hash_of(texts_[symbol]);
        slots_[slot_of(texts_[symbol], hash)] = {static_cast<std::uint32_t>(hash >> 32), symbol};
    }
}

}  // namespace csg::scad
