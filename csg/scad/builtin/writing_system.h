// Which script a text is written in, by its Unicode blocks.
#pragma once

#include <string>
#include <string_view>

namespace csg::scad {

/// The ISO 15924 tag ("Latn", "Cyrl", …) of the first character that has a script of its own; empty where none has.
[[nodiscard]] std::string script_of_text(std::string_view text);

/// The tag that a name such as "latin" or "arabic" stands for; other texts give their first four letters, as a tag.
[[nodiscard]] std::string script_tag(std::string_view name);

[[nodiscard]] bool is_right_to_left(std::string_view tag);

}  // namespace csg::scad
