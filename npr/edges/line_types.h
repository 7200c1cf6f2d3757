// How lines are drawn by what they are, as data that all lined styles share.
#pragma once

#include <array>

#include "npr/edges/edge_parameters.h"
#include "npr/edges/line_code.h"
#include "npr/picture.h"

namespace npr {

/// By the solids before a line (npr/edges/line_facts.glsl).
enum class Visibility { Visible, Hidden, DeeplyHidden };

/// See npr/edges/line_types.glsl.
struct LineType {
    float width = 1;
    float strength = 1;
    float dash = 0;
    float gap = 0;
    bool operator==(const LineType&) const = default;
};

/// A type for each kind of line and visibility.
struct LineTypes {
    static constexpr std::size_t kKinds = shader::LineCode().kLineKinds;
    static constexpr std::size_t kVisibilities = shader::LineCode().kVisibilities;

    std::array<LineType, kKinds * kVisibilities> rows;  ///< In the order of type_of_line.

    [[nodiscard]] LineType& of(LineKind kind, Visibility visibility) {
        return rows[kVisibilities * (static_cast<std::size_t>(kind) - 1) + static_cast<std::size_t>(visibility)];
    }
    bool operator==(const LineTypes&) const = default;
};

/// What a style with lines knows of them. Lines of three widths and two strengths, by whether a surface is before them
/// and whether the surface ends there, are drawn from the edge map alone. Where the table of types tells more than
/// that, the lines' facts are asked for, and each line is drawn as its type says.
struct LinedSettings : EdgeSettings {
    float width{};               ///< Pixels; that of outlines. Where edges of cuts are wider, completed to theirs.
    float inner_share = 0.7F;    ///< Of that width: inner edges.
    float hidden_share = 0.5F;   ///< The same of hidden lines.
    float section_share = 1.5F;  ///< The same of edges of faces that sections leave, where there are sections.
    float halo = 0;              ///< Pixels; see line_halo().
    float taper = 0;             ///< See line_taper().
    float taper_ends = 0;        ///< See line_taper_ends().
    float halo_gap = 0;          ///< From the border of what hides a line to where the line begins; 0: no gaps.
    float inner_width{};         ///< Pixels, as the next.
    float hidden_width{};
    float profile_strength = 1, inner_strength = 1;
    bool hard = false;    ///< Without smoothing. Not with types.
    bool dashes = false;  ///< Whether lines behind solids are dashed, and dotted behind more than one.
    LineTypes types;
    float line_unit = 1;  ///< Of the world: as large as a pixel at what the camera looks at.

    /// To be called when the fields above the types are set.
    void complete_lines(const Picture& picture);
};

/// Types that tell no more than three widths and two strengths.
[[nodiscard]] LineTypes plain_types(const LinedSettings& settings);

/// "dashes": see LinedSettings.
[[nodiscard]] Parameter line_dashes();

}  // namespace npr
