#include "ui/pipeline/suggestion.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

#include <fmt/format.h>

namespace ui {

namespace {

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// Levenshtein's distance, upper and lower case being the same.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (lower(a[i]) != lower(b[j]) ? 1 : 0);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string suggestion(std::string_view name, std::span<const std::string> candidates, std::string_view fallback) {
    name = name.substr(0, 64);
    std::size_t best = name.size() / 3 + 2;
    const std::string* nearest = nullptr;
    for (const std::string& candidate : candidates) {
        if (const std::size_t distance = edit_distance(name, candidate); distance < best) {
            best = distance;
            nearest = &candidate;
        }
    }
    return nearest ? fmt::format(" Did you mean \"{}\"?", *nearest) : std::string(fallback);
}

}  // namespace ui
