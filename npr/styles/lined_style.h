// Styles that are an edge map and one pass over the picture.
#pragma once

#include <optional>

#include "npr/edges/edge_map.h"
#include "npr/edges/line_types.h"
#include "npr/guard_band.h"
#include "npr/styles/pixel_style.h"

namespace npr {

/// Of styles that draw no hidden lines.
struct VisibleLines : LinedSettings {
    void complete(const Picture& picture) {
        visible_only = true;
        complete_lines(picture);
    }
};

/// What a lined style's .glsl file finds: the frame with its lines, and the settings.
template <typename Settings, typename Lines = LinedFrame>
struct LinedPixels : Lines, Settings {
    LinedPixels(const CpuFrame& frame, const CpuEdges& edges, const Settings& settings)
        : Lines(frame, edges, settings), Settings(settings) {}
};

/// The same where surfaces change from pixel to pixel: by light, fog or strokes.
template <typename Settings, typename Lines = LinedFrame>
struct ShadedPixels : LinedPixels<Settings, Lines> {
    using LinedPixels<Settings, Lines>::LinedPixels;
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return this->surface_ids(p, 0).x == Lines::kNoSurface && Lines::as_left(p);
    }
};

/// `Settings` are LinedSettings and the style's own.
template <typename Settings>
class LinedStyle : public Style {
  public:
    /// As StylePass takes it. Throws gl::Error.
    LinedStyle(const gl::Functions& gl, std::string_view fragment)
        : gl_(gl), fragment_(fragment), edge_map_(gl), pass_(gl, fragment, {Settings::table().declarations()}) {}

    void draw(const Frame& frame) override {
        const Settings settings = settings_of<Settings>(frame.picture);
        edge_map_.draw(frame, settings);
        StylePass& pass = settings.facts ? typed_pass(settings) : pass_;
        pass.set(settings);
        pass.draw(frame);
    }

  private:
    /// The same for lines drawn by their types.
    StylePass& typed_pass(const LinedSettings& settings) {
        if (!typed_pass_) {
            const OwnShaders own{Settings::table().declarations(), {}, {{"LINE_TYPES", "1"}}};
            typed_pass_.emplace(gl_, fragment_, own);
            types_ = gl::Buffer(gl_);
        }
        types_.upload<LineType>(settings.types.rows, GL_DYNAMIC_DRAW);
        types_.bind(GL_SHADER_STORAGE_BUFFER, 4);
        typed_pass_->program().set("line_unit", settings.line_unit);
        typed_pass_->program().set("line_halo", settings.halo_gap);
        typed_pass_->program().set("line_taper", settings.taper);
        typed_pass_->program().set("line_taper_ends", settings.taper_ends);
        return *typed_pass_;
    }

    const gl::Functions& gl_;
    std::string_view fragment_;
    EdgeMap edge_map_;
    StylePass pass_;
    std::optional<StylePass> typed_pass_;  ///< Made when first asked for, as the buffer.
    gl::Buffer types_;
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
            names.layers,
            [](const Picture& picture) {
                const Settings settings = settings_of<Settings>(picture);
                return settings.hard ? 0 : reach_of_lines(settings.width);
            }};
}

}  // namespace npr
