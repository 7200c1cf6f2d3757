// Reading files with a bound.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace csg::solid {

/// The whole of a regular file of at most `most` bytes; else nothing, and a warning.
[[nodiscard]] std::optional<std::string> read_file(const std::string& path, std::size_t most,
                                                   std::vector<std::string>& warnings);

/// In lower case, without the dot: "stl".
[[nodiscard]] std::string file_suffix(const std::string& path);

/// Words and numbers, separated by blanks. `#` begins a comment where asked for.
class Words {
  public:
    explicit Words(std::string_view text, bool comments = false) : text_(text), comments_(comments) {}
    /// Empty at the end.
    std::string_view next();
    /// The next word as a number that is finite; nothing (and the word is used up) where it is none.
    std::optional<double> number();
    /// A whole number of at least 0.
    std::optional<std::size_t> count();
    /// The rest of the line, which is used up.
    std::string_view line();
    [[nodiscard]] bool at_end();

  private:
    void skip();
    std::string_view text_;
    std::size_t at_ = 0;
    bool comments_;
};

/// The whole text as a finite number.
[[nodiscard]] std::optional<double> to_number(std::string_view text);

}  // namespace csg::solid
