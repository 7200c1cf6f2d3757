// Styles that are an edge map and one pass over the picture.
#pragma once

#include "npr/edges/edge_map.h"
#include "npr/styles/pixel_style.h"

namespace npr {

/// `Settings` are EdgeSettings and the style's own.
template <typename Settings>
class LinedStyle : public Style {
  public:
    /// As StylePass takes it. Throws gl::Error.
    LinedStyle(const gl::Functions& gl, std::string_view fragment)
        : edge_map_(gl), pass_(gl, fragment, {Settings::table().declarations()}) {}

    void draw(const Frame& frame) override {
        const Settings settings = settings_of<Settings>(frame.picture);
        edge_map_.draw(frame, settings);
        pass_.set(settings);
        pass_.draw(frame);
    }

  private:
    EdgeMap edge_map_;
    StylePass pass_;
};

/// `Pixels`: a LinedFrame, made of a CpuFrame, its edges and the settings.
template <typename Settings, typename Pixels>
[[nodiscard]] StyleInfo lined_style(const StyleNames& names) {
    return {names.name,
            names.label,
            Settings::table().parameters(),
            [fragment = names.fragment](const gl::Functions& gl) -> std::unique_ptr<Style> {
                return std::make_unique<LinedStyle<Settings>>(gl, fragment);
            },
            [] {
                return Paint([](const CpuFrame& frame) {
                    const Settings settings = settings_of<Settings>(frame.picture);
                    const CpuEdges edges = find_edges(frame, settings);
                    paint_tiles(frame, [&] { return Pixels(frame, edges, settings); });
                });
            },
            names.layers};
}

}  // namespace npr
