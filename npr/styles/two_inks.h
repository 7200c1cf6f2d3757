// Lines whose profile and inner edges have colors of their own.
#pragma once

#include "npr/styles/lined_style.h"

namespace npr {

/// A LinedFrame that keeps the ink of profile and inner edges apart.
struct TwoInksFrame : LinedFrame {
    TwoInksFrame(const CpuFrame& frame, const CpuEdges& edges, const LinedSettings& lines)
        : LinedFrame(frame, edges, pen(lines, 1, 0)), inner_ink(frame, edges, pen(lines, 0, 1)) {}

    TileInk inner_ink;

    void begin(int tile) {
        LinedFrame::begin(tile);
        inner_ink.draw(tile, *this);
    }
    [[nodiscard]] Edge line_edge(int layer) const { return {ink.ink(layer, at), inner_ink.ink(layer, at)}; }

  private:
    static LinedSettings pen(LinedSettings lines, float profile, float inner) {
        lines.profile_strength = profile;
        lines.inner_strength = inner;
        return lines;
    }
};

}  // namespace npr
