// Code points of strings.
#include <algorithm>
#include <cstring>

#include "csg/scad/value/value.h"

namespace csg::scad {

namespace {

/// What the first byte says; 1 for bytes that begin nothing.
std::size_t claimed_bytes(unsigned char lead) {
    return lead < 0xc0 || lead >= 0xfe ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf8 ? 4 : lead < 0xfc ? 5 : 6;
}

/// Whether `bytes` bytes at `at` are one code point in its shortest form, and one that there is.
bool is_valid(std::string_view text, std::size_t at, std::size_t bytes) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
    if (bytes == 1) {
        return byte(0) < 0x80;
    }
    if (bytes > 4 || byte(0) < 0xc2 || byte(0) > 0xf4 || at + bytes > text.size()) {
        return false;
    }
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) {
            return false;
        }
    }
    // The second byte bounds what the first leaves open: no longer forms, no surrogates, nothing above U+10FFFF.
    const unsigned char lowest = byte(0) == 0xe0 ? 0xa0 : byte(0) == 0xf0 ? 0x90 : 0x80;
    const unsigned char highest = byte(0) == 0xed ? 0x9f : byte(0) == 0xf4 ? 0x8f : 0xbf;
    return byte(1) >= lowest && byte(1) <= highest;
}

}  // namespace

std::size_t code_point_bytes(std::string_view text, std::size_t at) {
    return std::min(claimed_bytes(static_cast<unsigned char>(text[at])), text.size() - at);
}

bool is_valid_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t bytes = claimed_bytes(static_cast<unsigned char>(text[at]));
        if (!is_valid(text, at, bytes)) {
            return false;
        }
        at += bytes;
    }
    return true;
}

std::size_t code_point_count(std::string_view text) {
    // Eight bytes of ASCII at a time: strings that grow are counted again and again.
    constexpr std::uint64_t kHighBits = 0x8080808080808080U;
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size();) {
        std::uint64_t word = kHighBits;
        if (text.size() - at >= sizeof word) {
            std::memcpy(&word, text.data() + at, sizeof word);
        }
        if ((word & kHighBits) == 0) {
            at += sizeof word;
            count += sizeof word;
        } else {
            at += code_point_bytes(text, at);
            ++count;
        }
    }
    return count;
}

char32_t decode_code_point(std::string_view text, std::size_t at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t bytes = claimed_bytes(lead);
    if (!is_valid(text, at, bytes)) {
        return U'\uFFFD';
    }
    if (bytes == 1) {
        return lead;
    }
    char32_t result = lead & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        result = result << 6 | (static_cast<unsigned char>(text[at + i]) & 0x3fU);
    }
    return result;
}

void append_utf8(std::string& text, char32_t c) {
    const auto put = [&text](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (c < 0x80) {
        put(c);
        return;
    }
    if (c < 0x800) {
        put(0xc0 | c >> 6);
    } else {
        if (c < 0x10000) {
            put(0xe0 | c >> 12);
        } else {
            put(0xf0 | c >> 18);
            put(0x80 | (c >> 12 & 0x3f));
        }
        put(0x80 | (c >> 6 & 0x3f));
    }
    put(0x80 | (c & 0x3f));
}

}  // namespace csg::scad
