#include "ui/pipeline/suggestion.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "npr/edit_distance.h"

namespace ui {

namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

std::string without_dashes(const std::string& name) {
    return name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

std::string quoted(const std::string& name) {
    return fmt::format("\"{}\"", name);
}

constexpr std::size_t kMostNamed = 3;

}  // namespace

std::string suggestion(std::string_view name, std::span<const std::string> candidates, std::string_view fallback) {
    const std::string wanted = without_dashes(lower(name.substr(0, 64)));
    std::vector<std::string> begun, nearest;  // Those that go on where `name` ends; those with the fewest differences.
    std::size_t best = wanted.size() / 3 + 1;
    for (const std::string& candidate : candidates) {
        const std::string known = without_dashes(lower(candidate));
        if (!wanted.empty() && known.starts_with(wanted)) {
            begun.push_back(quoted(candidate));
        }
        const std::size_t distance = npr::edit_distance(wanted, known);
        if (distance > std::min(best, known.size() / 2)) {
            continue;  // Of a short name little may differ.
        }
        if (distance < best) {
            best = distance;
            nearest.clear();
        }
        nearest.push_back(quoted(candidate));
    }
    std::vector<std::string>& found = begun.empty() ? nearest : begun;
    if (found.size() > kMostNamed) {
        found.erase(found.begin() + kMostNamed, found.end());
    }
    return found.empty() ? std::string(fallback) : fmt::format(" Did you mean {}?", fmt::join(found, " or "));
}

}  // namespace ui
