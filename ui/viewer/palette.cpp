#include "ui/viewer/palette.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace ui {

std::optional<int> fuzzy_score(std::string_view typed, std::string_view text) {
    const auto small = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    int score = 0;
    std::size_t from = 0;
    bool follows = false;
    for (const char wanted : typed) {
        if (wanted == ' ') {
            follows = false;
            continue;
        }
        // A word that begins so is meant rather than a letter in the middle of one before it.
        std::size_t found = std::string_view::npos;
        for (std::size_t at = from; at < text.size(); ++at) {
            if (small(text[at]) != small(wanted)) {
                continue;
            }
            const bool begins = at == 0 || !is_letter(text[at - 1]);
            if (found == std::string_view::npos || (begins && !(follows && found == from))) {
                found = at;
                if (begins || (follows && at == from)) {
                    break;
                }
            }
        }
        if (found == std::string_view::npos) {
            return std::nullopt;
        }
        const bool begins = found == 0 || !is_letter(text[found - 1]);
        score += 1 + (follows && found == from ? 6 : 0) + (begins ? 4 : 0);
        from = found + 1;
        follows = true;
    }
    return score * 100 - static_cast<int>(std::min<std::size_t>(text.size(), 99));
}

std::vector<PaletteEntry> palette_entries(std::string_view typed) {
    std::vector<std::pair<int, PaletteEntry>> found;
    for (const ActionInfo& each : actions()) {
        if (each.action == Action::Palette || each.action == Action::Close) {
            continue;
        }
        const std::string name = fmt::format("{} › {}", each.menu, each.label);
        if (const auto score = fuzzy_score(typed, name)) {
            found.emplace_back(typed.empty() ? 0 : *score, PaletteEntry{each.action, name});
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<PaletteEntry> entries;
    for (auto& [score, entry] : found) {
        entries.push_back(std::move(entry));
    }
    return entries;
}

}  // namespace ui
