// The comment behind a parameter's value: how a customizer is to show it. "// [1:10]", "// [S:Small, L:Large]", "// 5".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace csg::scad {

struct CommentValue {
    enum class Kind : std::uint8_t {
        Text,
        Number,
        List,  ///< items: texts, numbers, and pairs of a value and its label, which are lists of two
        Range  ///< items: two numbers, begin and end; or three, with the step in the middle
    };
    Kind kind = Kind::Text;
    std::string text;
    double number = 0;
    std::vector<CommentValue> items;
};

/// `comment` is what stands after the two slashes. A comment that does not have the form of any value is the empty
/// text.
[[nodiscard]] CommentValue parse_parameter_comment(std::string_view comment);

/// As the .ast output shows it: `[1 : 10]`, `[["S", "Small"], ["L", "Large"]]`, `5`, `"text"`.
[[nodiscard]] std::string comment_value_text(const CommentValue& value);

}  // namespace csg::scad
