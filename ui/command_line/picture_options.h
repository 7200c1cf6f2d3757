// What the command line says of the picture in words that only the lists of styles and schemes explain.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "npr/picture.h"

namespace ui {

struct PictureTexts {
    std::string style = "shaded";
    std::vector<std::pair<std::string, std::string>> settings{};  ///< Style parameters by name; the rest are defaults.
    std::string scheme = "Cornfield";
    std::vector<std::string> part_styles{};  ///< As read_part_style takes them.
    std::vector<std::string> reveal{};       ///< As read_revealed_part takes them.

    bool operator==(const PictureTexts&) const = default;
};

/// The picture with its style, parameters and scheme. Throws std::runtime_error where there is no such style,
/// parameter, value or scheme; names the nearest one.
[[nodiscard]] npr::Picture picture_of(npr::Picture picture, const PictureTexts& texts);

/// "a, b or c (a)", with the default in brackets.
[[nodiscard]] std::string style_names();

}  // namespace ui
