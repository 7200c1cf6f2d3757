// Depiction techniques: what moves, in a picture that stands still (Nienhaus 2005, sections 7.5 to 7.7).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/pipeline/motion/motion.h"

namespace ui {

/// `TECHNIQUE {PART} [t0,t1] (name=value,…)`, as a person writes it.
struct Depiction {
    enum class Technique {
        Path,      ///< An arrow along the way of its middle, dashed where it lies in the future.
        Motion,    ///< Lines that it trails behind.
        Still,     ///< It, at a time, as if it stood there.
        Ghost,     ///< It, at several times, the fainter the farther off.
        Rotation,  ///< An arrow about the axis that it turns about.
        Auto,      ///< What goes with the character of its motion.
    };
    Technique technique = Technique::Auto;
    std::string part = "*";  ///< The name of a body as `csgscope motion` tells it, or of its module; "*": all.
    std::optional<std::pair<double, double>> times;  ///< Absent: the whole interval.
    int count = 5;                                   ///< `n`: ghosts, or lines.
    double squash = 0;  ///< Of still and ghost: by how much a body at its highest speed is stretched, its volume kept.
    std::optional<double> width;  ///< World units: of arrows and lines; absent: by the model's size.
    std::optional<csg::Rgba> color;
    std::string text;  ///< As it was written.
};

/// Throws std::runtime_error, with the place and what was expected there, where it is none.
[[nodiscard]] Depiction read_depiction(const std::string& text);

/// The model at the time `now` with the glyphs of the depictions: shapes in the scene, drawn as all others are.
/// `motion`: over an interval that holds their times. Throws std::runtime_error where a depiction names no body that
/// moves (and the nearest that does), or one that does not do what the technique shows.
[[nodiscard]] csg::Tree depict(const csg::Tree& model, const Motion& motion, const std::vector<Depiction>& depictions,
                               double now);

}  // namespace ui
