#include "ui/pipeline/plain_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ui {

std::string plain(std::string_view text) {
    if (text.find("CGAL") != std::string_view::npos) {
        // "CGAL ERROR: precondition violation!" and the expression, file and line of CGAL, which say nothing about the
        // model; a text of ours stands before it.
        std::string_view ours = text.substr(0, text.find("CGAL"));
        while (!ours.empty() && (ours.back() == ' ' || ours.back() == ':')) {
            ours.remove_suffix(1);
        }
        return std::string(ours) + (ours.empty() ? "" : ": ") + "its faces cannot be resolved exactly";
    }
    if (text.starts_with("[json.exception")) {
        const std::size_t close = text.find("] ");
        return "not JSON: " + std::string(close == std::string_view::npos ? text : text.substr(close + 2));
    }
    return std::string(text);
}

namespace {

/// Bytes of the UTF-8 sequence that the text begins with (Unicode 15, table 3-7); 0 where it begins with none.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned lead = byte(0);
    if (lead < 0x80) {
        return 1;
    }
    const std::size_t length = lead >= 0xC2 && lead <= 0xDF   ? 2
                               : lead >= 0xE0 && lead <= 0xEF ? 3
                               : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                              : 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    const unsigned second = byte(1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool beyond = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
    return overlong || beyond ? 0 : length;
}

/// C0 but newline and tab, DEL, and C1 (U+0080 to U+009F).
bool is_control(std::string_view sequence) {
    const auto first = static_cast<unsigned char>(sequence[0]);
    return sequence.size() == 1 ? (first < 0x20 && first != '\n' && first != '\t') || first == 0x7F
                                : first == 0xC2 && static_cast<unsigned char>(sequence[1]) < 0xA0;
}

}  // namespace

std::string printable(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        const std::string_view sequence = text.substr(0, std::max<std::size_t>(length, 1));
        text.remove_prefix(sequence.size());
        if (length != 0 && !is_control(sequence)) {
            result += sequence;
            continue;
        }
        for (const char c : sequence) {
            const auto byte = static_cast<unsigned char>(c);
            result += "\\x";
            result += kDigits[byte >> 4U];
            result += kDigits[byte & 15U];
        }
    }
    return result;
}

std::string number_text(double value, double scale) {
    return fmt::format("{:.6g}", std::abs(value) < 1e-9 * scale ? 0.0 : value);
}

std::size_t character_count(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace ui
