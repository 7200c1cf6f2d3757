// What is to be drawn of a motion, as a person writes it (Nienhaus 2005, section 7.7).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/tree/tree.h"

namespace ui {

/// `TECHNIQUE {PART} [t0,t1] (name=value,…)`.
struct Depiction {
    enum class Technique {
        Path,       ///< An arrow along the way of its middle, dashed where it lies in the future.
        Motion,     ///< Lines that it trails behind.
        Still,      ///< It, at a time, as if it stood there.
        Ghost,      ///< It, at several times, the fainter the farther off.
        Rotation,   ///< An arrow about the axis that it turns about.
        Collision,  ///< A star where it begins to touch something.
        Frame,      ///< A frame about it, in the picture.
        Speak,      ///< A speech bubble.
        Camera,     ///< How the program's camera moves ($vpr, $vpt, $vpd).
        Auto,       ///< What goes with the character of its motion.
    };
    Technique technique = Technique::Auto;
    /// The name of a body as `csgscope motion` tells it, or of its module, with `*` for any characters; several with
    /// commas between; "*": all.
    std::string part = "*";
    std::optional<std::pair<double, double>> times;  ///< Absent: the whole interval.
    int count = 5;                                   ///< `n`: ghosts, lines, or shots.
    double squash = 0;  ///< Of still and ghost: by how much a body at its highest speed is stretched, its volume kept.
    std::optional<double> width;  ///< World units, of frames pixels: of arrows and lines; absent: by the model's size.
    std::optional<csg::Rgba> color;
    std::string with = "*";    ///< Of collision: with what; as `part`.
    std::string say;           ///< `text`: of bubbles, frames and stars.
    std::string style;         ///< Of still and ghost: STYLE,PARAMETER=VALUE,…; empty: that of the picture.
    std::size_t style_at = 0;  ///< Where that is in the text.
    std::string text;          ///< As it was written.
    /// One of a file of rules: it may name nothing, or what does not do what the technique shows; where its part is
    /// "*", it is for what no other rule names (section 7.9).
    bool rule = false;
};

/// As expressions name them.
[[nodiscard]] std::vector<std::string> technique_names();

/// Throws std::runtime_error, with the place and what was expected there, where it is none.
[[nodiscard]] Depiction read_depiction(const std::string& text);

/// One rule a line; what is behind a # is no part of it. Throws std::runtime_error, which begins with
/// file:line:column, where a line is none.
[[nodiscard]] std::vector<Depiction> read_depiction_rules(const std::string& text, const std::string& file);

/// Is a body or part that is called `name` meant? "wheel" means wheel, wheel 2, …; "wheel 2" that one.
[[nodiscard]] bool names_body(const std::string& pattern, const std::string& name);

}  // namespace ui
