// Names and string literals of a program, each kept once.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace csg::scad {

/// Equal texts have equal symbols within one SymbolTable. Symbols count up from 0 in order of first appearance.
using Symbol = std::uint32_t;
inline constexpr Symbol kNoSymbol = ~Symbol{0};

class SymbolTable {
  public:
    SymbolTable() = default;
    SymbolTable(SymbolTable&&) noexcept = default;
    SymbolTable& operator=(SymbolTable&&) noexcept = default;

    Symbol intern(std::string_view text) {
        const std::uint64_t hash = hash_of(text);
        if (2 * (texts_.size() + 1) > slots_.size()) {
            grow();
        }
        Slot& slot = slots_[slot_of(text, hash)];
        if (slot.symbol == kNoSymbol) {
            slot = {static_cast<std::uint32_t>(hash >> 32), static_cast<Symbol>(texts_.size())};
            texts_.emplace_back(text);
        }
        return slot.symbol;
    }
    /// The symbol of `text`, or kNoSymbol where the program does not contain it.
    [[nodiscard]] Symbol find(std::string_view text) const {
        return slots_.empty() ? kNoSymbol : slots_[slot_of(text, hash_of(text))].symbol;
    }
    /// Valid as long as the table lives. Text may contain any byte.
    [[nodiscard]] const std::string& text(Symbol symbol) const { return texts_[symbol]; }
    [[nodiscard]] std::size_t size() const { return texts_.size(); }

    /// Of 64 bits that all depend on all of the text.
    [[nodiscard]] static std::uint64_t hash_of(std::string_view text);

  private:
    struct Slot {
        std::uint32_t high_hash = 0;  ///< Spares most comparisons of texts.
        Symbol symbol = kNoSymbol;
    };

    /// Of the text, or of the free slot where it would go. The table is never full.
    [[nodiscard]] std::size_t slot_of(std::string_view text, std::uint64_t hash) const {
        const std::size_t mask = slots_.size() - 1;
        const auto high = static_cast<std::uint32_t>(hash >> 32);
        std::size_t at = static_cast<std::size_t>(hash) & mask;
        while (slots_[at].symbol != kNoSymbol && (slots_[at].high_hash != high || texts_[slots_[at].symbol] != text)) {
            at = (at + 1) & mask;
        }
        return at;
    }
    void grow();

    std::deque<std::string> texts_;  // A deque, so that references to texts stay valid.
    std::vector<Slot> slots_;        // A power of two of them.
};

}  // namespace csg::scad
