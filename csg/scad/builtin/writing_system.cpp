#include "csg/scad/builtin/writing_system.h"

#include <algorithm>
#include <array>

#include "csg/scad/value/value.h"

namespace csg::scad {

namespace {

struct Block {
    char32_t first, last;
    std::string_view tag;
};

constexpr std::array kBlocks{
    Block{0x41, 0x5A, "Latn"},     Block{0x61, 0x7A, "Latn"},       Block{0xAA, 0xAA, "Latn"},
    Block{0xBA, 0xBA, "Latn"},     Block{0xC0, 0xD6, "Latn"},       Block{0xD8, 0xF6, "Latn"},
    Block{0xF8, 0x2B8, "Latn"},    Block{0x370, 0x373, "Grek"},     Block{0x375, 0x377, "Grek"},
    Block{0x37A, 0x37D, "Grek"},   Block{0x386, 0x386, "Grek"},     Block{0x388, 0x3E1, "Grek"},
    Block{0x400, 0x52F, "Cyrl"},   Block{0x531, 0x58F, "Armn"},     Block{0x591, 0x5F4, "Hebr"},
    Block{0x600, 0x604, "Arab"},   Block{0x606, 0x60B, "Arab"},     Block{0x620, 0x63F, "Arab"},
    Block{0x641, 0x64A, "Arab"},   Block{0x671, 0x6FF, "Arab"},     Block{0x700, 0x74F, "Syrc"},
    Block{0x900, 0x97F, "Deva"},   Block{0x980, 0x9FF, "Beng"},     Block{0xB80, 0xBFF, "Taml"},
    Block{0xE01, 0xE3A, "Thai"},   Block{0xE40, 0xE5B, "Thai"},     Block{0x10A0, 0x10FF, "Geor"},
    Block{0x1100, 0x11FF, "Hang"}, Block{0x1E00, 0x1EFF, "Latn"},   Block{0x1F00, 0x1FFE, "Grek"},
    Block{0x3041, 0x309F, "Hira"}, Block{0x30A1, 0x30FF, "Kana"},   Block{0x3400, 0x9FFF, "Hani"},
    Block{0xAC00, 0xD7A3, "Hang"}, Block{0xFB00, 0xFB06, "Latn"},   Block{0xFB1D, 0xFB4F, "Hebr"},
    Block{0xFB50, 0xFDFF, "Arab"}, Block{0xFE70, 0xFEFC, "Arab"},   Block{0xFF21, 0xFF3A, "Latn"},
    Block{0xFF41, 0xFF5A, "Latn"}, Block{0x20000, 0x2FA1F, "Hani"},
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
        const auto block =
            std::find_if(kBlocks.begin(), kBlocks.end(), [c](const Block& b) { return b.first <= c && c <= b.last; });
        if (block != kBlocks.end()) {
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
