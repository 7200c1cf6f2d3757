#include "csg/scad/builtin/color_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <string>

namespace csg::scad {

namespace {

struct Entry {
    std::string_view name;
    std::uint32_t rgb;
};

/// CSS Color Module Level 4, in order of their names.
constexpr std::array kColors{
    Entry{"aliceblue", 0xf0f8ff},
    Entry{"antiquewhite", 0xfaebd7},
    Entry{"aqua", 0x00ffff},
    Entry{"aquamarine", 0x7fffd4},
    Entry{"azure", 0xf0ffff},
    Entry{"beige", 0xf5f5dc},
    Entry{"bisque", 0xffe4c4},
    Entry{"black", 0x000000},
    Entry{"blanchedalmond", 0xffebcd},
    Entry{"blue", 0x0000ff},
    Entry{"blueviolet", 0x8a2be2},
    Entry{"brown", 0xa52a2a},
    Entry{"burlywood", 0xdeb887},
    Entry{"cadetblue", 0x5f9ea0},
    Entry{"chartreuse", 0x7fff00},
    Entry{"chocolate", 0xd2691e},
    Entry{"coral", 0xff7f50},
    Entry{"cornflowerblue", 0x6495ed},
    Entry{"cornsilk", 0xfff8dc},
    Entry{"crimson", 0xdc143c},
    Entry{"cyan", 0x00ffff},
    Entry{"darkblue", 0x00008b},
    Entry{"darkcyan", 0x008b8b},
    Entry{"darkgoldenrod", 0xb8860b},
    Entry{"darkgray", 0xa9a9a9},
    Entry{"darkgreen", 0x006400},
    Entry{"darkgrey", 0xa9a9a9},
    Entry{"darkkhaki", 0xbdb76b},
    Entry{"darkmagenta", 0x8b008b},
    Entry{"darkolivegreen", 0x556b2f},
    Entry{"darkorange", 0xff8c00},
    Entry{"darkorchid", 0x9932cc},
    Entry{"darkred", 0x8b0000},
    Entry{"darksalmon", 0xe9967a},
    Entry{"darkseagreen", 0x8fbc8f},
    Entry{"darkslateblue", 0x483d8b},
    Entry{"darkslategray", 0x2f4f4f},
    Entry{"darkslategrey", 0x2f4f4f},
    Entry{"darkturquoise", 0x00ced1},
    Entry{"darkviolet", 0x9400d3},
    Entry{"deeppink", 0xff1493},
    Entry{"deepskyblue", 0x00bfff},
    Entry{"dimgray", 0x696969},
    Entry{"dimgrey", 0x696969},
    Entry{"dodgerblue", 0x1e90ff},
    Entry{"firebrick", 0xb22222},
    Entry{"floralwhite", 0xfffaf0},
    Entry{"forestgreen", 0x228b22},
    Entry{"fuchsia", 0xff00ff},
    Entry{"gainsboro", 0xdcdcdc},
    Entry{"ghostwhite", 0xf8f8ff},
    Entry{"gold", 0xffd700},
    Entry{"goldenrod", 0xdaa520},
    Entry{"gray", 0x808080},
    Entry{"green", 0x008000},
    Entry{"greenyellow", 0xadff2f},
    Entry{"grey", 0x808080},
    Entry{"honeydew", 0xf0fff0},
    Entry{"hotpink", 0xff69b4},
    Entry{"indianred", 0xcd5c5c},
    Entry{"indigo", 0x4b0082},
    Entry{"ivory", 0xfffff0},
    Entry{"khaki", 0xf0e68c},
    Entry{"lavender", 0xe6e6fa},
    Entry{"lavenderblush", 0xfff0f5},
    Entry{"lawngreen", 0x7cfc00},
    Entry{"lemonchiffon", 0xfffacd},
    Entry{"lightblue", 0xadd8e6},
    Entry{"lightcoral", 0xf08080},
    Entry{"lightcyan", 0xe0ffff},
    Entry{"lightgoldenrodyellow", 0xfafad2},
    Entry{"lightgray", 0xd3d3d3},
    Entry{"lightgreen", 0x90ee90},
    Entry{"lightgrey", 0xd3d3d3},
    Entry{"lightpink", 0xffb6c1},
    Entry{"lightsalmon", 0xffa07a},
    Entry{"lightseagreen", 0x20b2aa},
    Entry{"lightskyblue", 0x87cefa},
    Entry{"lightslategray", 0x778899},
    Entry{"lightslategrey", 0x778899},
    Entry{"lightsteelblue", 0xb0c4de},
    Entry{"lightyellow", 0xffffe0},
    Entry{"lime", 0x00ff00},
    Entry{"limegreen", 0x32cd32},
    Entry{"linen", 0xfaf0e6},
    Entry{"magenta", 0xff00ff},
    Entry{"maroon", 0x800000},
    Entry{"mediumaquamarine", 0x66cdaa},
    Entry{"mediumblue", 0x0000cd},
    Entry{"mediumorchid", 0xba55d3},
    Entry{"mediumpurple", 0x9370db},
    Entry{"mediumseagreen", 0x3cb371},
    Entry{"mediumslateblue", 0x7b68ee},
    Entry{"mediumspringgreen", 0x00fa9a},
    Entry{"mediumturquoise", 0x48d1cc},
    Entry{"mediumvioletred", 0xc71585},
    Entry{"midnightblue", 0x191970},
    Entry{"mintcream", 0xf5fffa},
    Entry{"mistyrose", 0xffe4e1},
    Entry{"moccasin", 0xffe4b5},
    Entry{"navajowhite", 0xffdead},
    Entry{"navy", 0x000080},
    Entry{"oldlace", 0xfdf5e6},
    Entry{"olive", 0x808000},
    Entry{"olivedrab", 0x6b8e23},
    Entry{"orange", 0xffa500},
    Entry{"orangered", 0xff4500},
    Entry{"orchid", 0xda70d6},
    Entry{"palegoldenrod", 0xeee8aa},
    Entry{"palegreen", 0x98fb98},
    Entry{"paleturquoise", 0xafeeee},
    Entry{"palevioletred", 0xdb7093},
    Entry{"papayawhip", 0xffefd5},
    Entry{"peachpuff", 0xffdab9},
    Entry{"peru", 0xcd853f},
    Entry{"pink", 0xffc0cb},
    Entry{"plum", 0xdda0dd},
    Entry{"powderblue", 0xb0e0e6},
    Entry{"purple", 0x800080},
    Entry{"rebeccapurple", 0x663399},
    Entry{"red", 0xff0000},
    Entry{"rosybrown", 0xbc8f8f},
    Entry{"royalblue", 0x4169e1},
    Entry{"saddlebrown", 0x8b4513},
    Entry{"salmon", 0xfa8072},
    Entry{"sandybrown", 0xf4a460},
    Entry{"seagreen", 0x2e8b57},
    Entry{"seashell", 0xfff5ee},
    Entry{"sienna", 0xa0522d},
    Entry{"silver", 0xc0c0c0},
    Entry{"skyblue", 0x87ceeb},
    Entry{"slateblue", 0x6a5acd},
    Entry{"slategray", 0x708090},
    Entry{"slategrey", 0x708090},
    Entry{"snow", 0xfffafa},
    Entry{"springgreen", 0x00ff7f},
    Entry{"steelblue", 0x4682b4},
    Entry{"tan", 0xd2b48c},
    Entry{"teal", 0x008080},
    Entry{"thistle", 0xd8bfd8},
    Entry{"tomato", 0xff6347},
    Entry{"turquoise", 0x40e0d0},
    Entry{"violet", 0xee82ee},
    Entry{"wheat", 0xf5deb3},
    Entry{"white", 0xffffff},
    Entry{"whitesmoke", 0xf5f5f5},
    Entry{"yellow", 0xffff00},
    Entry{"yellowgreen", 0x9acd32},
};

Rgba from_bytes(std::uint32_t r, std::uint32_t g, std::uint32_t b, std::uint32_t a) {
    const auto part = [](std::uint32_t byte) { return static_cast<float>(byte) / 255.0F; };
    return {part(r), part(g), part(b), part(a)};
}

std::optional<Rgba> from_digits(std::string_view digits) {
    const bool is_short = digits.size() == 3 || digits.size() == 4;
    if (!is_short && digits.size() != 6 && digits.size() != 8) {
        return std::nullopt;
    }
    std::array<std::uint32_t, 8> values{};
    for (std::size_t i = 0; i < digits.size(); ++i) {
        const auto c = static_cast<unsigned char>(digits[i]);
        if (std::isxdigit(c) == 0) {
            return std::nullopt;
        }
        values[i] = std::isdigit(c) != 0 ? c - std::uint32_t{'0'}
                                         : static_cast<std::uint32_t>(std::tolower(c)) - std::uint32_t{'a'} + 10;
    }
    std::array<std::uint32_t, 4> bytes{0, 0, 0, 255};
    const std::size_t count = digits.size() / (is_short ? 1 : 2);
    for (std::size_t i = 0; i < count; ++i) {
        bytes[i] = is_short ? values[i] * 17 : values[2 * i] * 16 + values[2 * i + 1];
    }
    return from_bytes(bytes[0], bytes[1], bytes[2], bytes[3]);
}

}  // namespace

std::optional<Rgba> find_color(std::string_view text) {
    if (text.starts_with('#')) {
        return from_digits(text.substr(1));
    }
    std::string name(text);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (name == "transparent") {
        return Rgba{0, 0, 0, 0};
    }
    const auto found = std::lower_bound(kColors.begin(), kColors.end(), name,
                                        [](const Entry& e, const std::string& n) { return e.name < n; });
    if (found == kColors.end() || found->name != name) {
        return std::nullopt;
    }
    return from_bytes(found->rgb >> 16, found->rgb >> 8 & 0xffU, found->rgb & 0xffU, 255);
}

}  // namespace csg::scad
