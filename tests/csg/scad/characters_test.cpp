// Runs of bytes, found sixteen at a time or one by one.
#include "csg/scad/source/characters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "csg/scad/syntax/token.h"

namespace {

using Scan = const char* (*)(const char*, const char*);

/// Holds `scan` against a search by bytes for the first that is in no run, for every byte at every place of every
/// length.
template <typename InRun>
void expect_ends(Scan scan, char filler, const InRun& in_run) {
    for (std::size_t length = 0; length < 40; ++length) {
        std::string text(length, filler);
        EXPECT_EQ(scan(text.data(), text.data() + length), text.data() + length);
        for (std::size_t at = 0; at < length; ++at) {
            for (int byte = 0; byte < 256; ++byte) {
                text[at] = static_cast<char>(byte);
                const auto expected = std::find_if_not(text.begin(), text.end(), in_run) - text.begin();
                ASSERT_EQ(scan(text.data(), text.data() + length) - text.data(), expected) << byte << " at " << at;
            }
            text[at] = filler;
        }
    }
}

TEST(Characters, Words) {
    expect_ends(csg::scad::end_of_word, 'q', csg::scad::is_word);
}

TEST(Characters, Spaces) {
    expect_ends(csg::scad::end_of_spaces, ' ', [](char c) { return c == ' '; });
}

TEST(Characters, Lines) {
    expect_ends(csg::scad::end_of_line, '/', [](char c) { return c != '\n' && c != '\r'; });
}

/// By text, and by the first eight bytes as one number.
TEST(Characters, WordsOfTheLanguage) {
    const auto packed = [](std::string_view word) {
        std::uint64_t bytes = 0;
        for (std::size_t i = 0; i < word.size(); ++i) {
            bytes |= std::uint64_t{static_cast<unsigned char>(word[i])} << 8 * i;
        }
        return bytes;
    };
    int words = 0;
    for (int kind = 0; kind < 256; ++kind) {
        const std::string_view text = token_text(static_cast<csg::scad::TokenKind>(kind));
        if (text.empty() || !csg::scad::is_word(text[0])) {
            continue;
        }
        ++words;
        for (const std::string& word : {std::string(text), std::string(text.substr(1)) + text[0]}) {
            EXPECT_EQ(csg::scad::word_kind(packed(word)), csg::scad::word_kind(word)) << word;
        }
        EXPECT_EQ(csg::scad::word_kind(packed(text)), static_cast<csg::scad::TokenKind>(kind));
    }
    EXPECT_EQ(words, 12);
    EXPECT_EQ(csg::scad::word_kind(packed("x")), csg::scad::TokenKind::Identifier);
    EXPECT_EQ(csg::scad::word_kind(std::uint64_t{0}), csg::scad::TokenKind::Identifier);
}

}  // namespace
