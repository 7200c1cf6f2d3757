// Names and string literals of a program, each kept once.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>

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
        if (const auto found = index_.find(text); found != index_.end()) {
            return found->second;
        }
        const auto symbol = static_cast<Symbol>(texts_.size());
        index_.emplace(texts_.emplace_back(text), symbol);
        return symbol;
    }
    /// The symbol of `text`, or kNoSymbol where the program does not contain it.
    [[nodiscard]] Symbol find(std::string_view text) const {
        const auto found = index_.find(text);
        return found == index_.end() ? kNoSymbol : found->second;
    }
    /// Valid as long as the table lives. Text may contain any byte.
    [[nodiscard]] const std::string& text(Symbol symbol) const { return texts_[symbol]; }
    [[nodiscard]] std::size_t size() const { return texts_.size(); }

  private:
    std::deque<std::string> texts_;  // A deque, so that the views in index_ stay valid.
    std::unordered_map<std::string_view, Symbol> index_;
};

}  // namespace csg::scad
