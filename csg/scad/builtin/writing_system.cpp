#include "csg/scad/builtin/writing_system.h"

#include <algorithm>
#include <array>

#include "csg/scad/value/value.h"

namespace csg::scad {

namespace {

struct Letters {
    char32_t first, last;
    std::string_view tag;
};

constexpr std::array kLetters{
    Letters{0x41, 0x5A, "Latn"},     Letters{0x61, 0x7A, "Latn"},       Letters{0xAA, 0xAA, "Latn"},
    Letters{0xBA, 0xBA, "Latn"},     Letters{0xC0, 0xD6, "Latn"},       Letters{0xD8, 0xF6, "Latn"},
    Letters{0xF8, 0x2B8, "Latn"},    Letters{0x370, 0x373, "Grek"},     Letters{0x375, 0x377, "Grek"},
    Letters{0x37A, 0x37D, "Grek"},   Letters{0x386, 0x386, "Grek"},     Letters{0x388, 0x3E1, "Grek"},
    Letters{0x400, 0x52F, "Cyrl"},   Letters{0x531, 0x58F, "Armn"},     Letters{0x591, 0x5F4, "Hebr"},
    Letters{0x600, 0x604, "Arab"},   Letters{0x606, 0x60B, "Arab"},     Letters{0x620, 0x63F, "Arab"},
    Letters{0x641, 0x64A, "Arab"},   Letters{0x671, 0x6FF, "Arab"},     Letters{0x700, 0x74F, "Syrc"},
    Letters{0x900, 0x97F, "Deva"},   Letters{0x980, 0x9FF, "Beng"},     Letters{0xB80, 0xBFF, "Taml"},
    Letters{0xE01, 0xE3A, "Thai"},   Letters{0xE40, 0xE5B, "Thai"},     Letters{0x10A0, 0x10FF, "Geor"},
    Letters{0x1100, 0x11FF, "Hang"}, Letters{0x1E00, 0x1EFF, "Latn"},   Letters{0x1F00, 0x1FFE, "Grek"},
    Letters{0x3041, 0x309F, "Hira"}, Letters{0x30A1, 0x30FF, "Kana"},   Letters{0x3400, 0x9FFF, "Hani"},
    Letters{0xAC00, 0xD7A3, "Hang"}, Letters{0xFB00, 0xFB06, "Latn"},   Letters{0xFB1D, 0xFB4F, "Hebr"},
    Letters{0xFB50, 0xFDFF, "Arab"}, Letters{0xFE70, 0xFEFC, "Arab"},   Letters{0xFF21, 0xFF3A, "Latn"},
    Letters{0xFF41, 0xFF5A, "Latn"}, Letters{0x20000, 0x2FA1F, "Hani"},
};

struct Name {
    std::string_view name, tag;
};

constexpr std::array kNames{
    Name{"latin", "Latn"},  Name{"greek", "Grek"},    Name{"cyrillic", "Cyrl"}, Name{"armenian", "Armn"},
    Name{"hebrew", "Hebr"}, Name{"arabic", "Arab"},   Name{"syriac", "Syrc"},   Name{"devanagari", "Deva"},
    Name{"thai", "Thai"},   Name{"georgian", "Geor"}, Name{"hangul", "Hang"},   Name{"hiragana", "Hira"},
    Name{"han", "Hani"},    Name{"katakana", "Kana"}, Name{"tamil", "Taml"},    Name{"bengali", "Beng"},
};

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::string script_of_text(std::string_view text) {
    for (std::size_t at = 0; at < text.size(); at += code_point_bytes(text, at)) {
        const char32_t c = decode_code_point(text, at);
        const auto block = std::find_if(kLetters.begin(), kLetters.end(),
                                        [c](const Letters& b) { return b.first <= c && c <= b.last; });
        if (block != kLetters.end()) {
            return std::string(block->tag);
        }
    }
    return {};
}

std::string script_tag(std::string_view name) {
    std::string small(name);
    std::transform(small.begin(), small.end(), small.begin(), lower);
    const auto known = std::find_if(kNames.begin(), kNames.end(), [&](const Name& n) { return n.name == small; });
    if (known != kNames.end()) {
        return std::string(known->tag);
    }
    small.resize(std::min<std::size_t>(small.size(), 4));
    if (!small.empty() && small[0] >= 'a' && small[0] <= 'z') {
        small[0] = static_cast<char>(small[0] - 'a' + 'A');
    }
    return small;
}

bool is_right_to_left(std::string_view tag) {
    return tag == "Arab" || tag == "Hebr" || tag == "Syrc";
}

}  // namespace csg::scad
