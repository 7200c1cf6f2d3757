// A cursor in a text, and what keys do to both. Counts bytes; steps over characters of several bytes at once.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ui {

class TextCaret {
  public:
    enum class Way { Left, Right, WordLeft, WordRight, Up, Down, LineBegin, LineEnd, Begin, End };

    [[nodiscard]] std::size_t at() const { return at_; }
    /// What is selected lies between the two, in any order; they are one where nothing is.
    [[nodiscard]] std::size_t anchor() const { return anchor_; }
    [[nodiscard]] std::size_t begin() const { return at_ < anchor_ ? at_ : anchor_; }
    [[nodiscard]] std::size_t end() const { return at_ < anchor_ ? anchor_ : at_; }
    [[nodiscard]] bool selects() const { return at_ != anchor_; }

    /// Where it was put by a hand; `more`: the anchor stays.
    void put(std::size_t at, bool more);
    void select(std::size_t from, std::size_t to);
    /// The word that the place is in, or the characters between two.
    void select_word(const std::string& text, std::size_t at);
    /// No farther than the text.
    void keep_within(const std::string& text);
    /// `lines`: of Up and Down.
    void move(const std::string& text, Way way, bool more, int lines = 1);

    // These change the text.
    void insert(std::string& text, std::string_view typed);
    /// What is selected, else what lies on that way.
    void erase(std::string& text, Way way);
    /// With the blanks that the line begins with, and more behind an opening bracket.
    void new_line(std::string& text);
    /// Four blanks more, or fewer, at the cursor or before all lines that are selected.
    void indent(std::string& text, bool less);

  private:
    [[nodiscard]] std::size_t destination(const std::string& text, Way way) const;
    void move_lines(const std::string& text, int lines);

    std::size_t at_ = 0, anchor_ = 0;
    std::size_t column_ = 0;  ///< That Up and Down keep to, …
    bool keeps_ = false;      ///< … as long as nothing else was done.
};

/// What kind each byte of a program's text is of: 'c' comment, 's' string, 'n' number, 'k' keyword, 'f' name of what is
/// called, '$' special variable, ' ' all else.
[[nodiscard]] std::string highlighted(std::string_view text);

}  // namespace ui
