#include "ui/pipeline/suggestion.h"

#include <cctype>

#include <fmt/format.h>

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

}  // namespace

std::string suggestion(std::string_view name, std::span<const std::string> candidates, std::string_view fallback) {
    const std::string wanted = lower(name.substr(0, 64));
    std::size_t best = wanted.size() / 3 + 2;
    const std::string* nearest = nullptr;
    for (const std::string& candidate : candidates) {
        if (const std::size_t distance = npr::edit_distance(wanted, lower(candidate)); distance < best) {
            best = distance;
            nearest = &candidate;
        }
    }
    return nearest ? fmt::format(" Did you mean \"{}\"?", *nearest) : std::string(fallback);
}

}  // namespace ui
