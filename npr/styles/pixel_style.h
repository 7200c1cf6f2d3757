// Styles that are one pass over the picture, made of little: a struct of settings, a fragment shader, and the same in
// C++.
#pragma once

#include <memory>

#include "npr/painter/cpu_paint.h"
#include "npr/settings.h"
#include "npr/style_pass.h"

namespace npr {

/// Settings of a style that has no parameters.
struct NoSettings {
    static const SettingsTable<NoSettings>& table() {
        static const SettingsTable<NoSettings> all{};
        return all;
    }
};

template <typename Settings>
class PixelStyle : public Style {
  public:
    /// As StylePass takes them. Throws gl::Error.
    PixelStyle(const gl::Functions& gl, std::string_view fragment, std::span<const gl::ShaderFile> files)
        : pass_(gl, fragment, {Settings::table().declarations(), files, {}}) {}

    void draw(const Frame& frame) override {
        pass_.set(settings_of<Settings>(frame.picture));
        pass_.draw(frame);
    }

  private:
    StylePass pass_;
};

/// Where a style is in the program and how many layers it looks at; see StyleInfo.
struct StyleNames {
    std::string_view name;      ///< For the command line.
    std::string_view label;     ///< For the window.
    std::string_view fragment;  ///< Its shader, which includes "npr/settings.glsl".
    int (*layers)(bool translucent) = all_layers;
    std::span<const gl::ShaderFile> files{};  ///< Shaders that are not in this folder.
};

/// `Pixels`: a painter as paint_tiles takes it, made of a CpuFrame and the settings.
template <typename Settings, typename Pixels>
[[nodiscard]] StyleInfo pixel_style(const StyleNames& names) {
    return {names.name,
            names.label,
            Settings::table().parameters(),
            [=](const gl::Functions& gl) -> std::unique_ptr<Style> {
                return std::make_unique<PixelStyle<Settings>>(gl, names.fragment, names.files);
            },
            [] {
                return Paint([](const CpuFrame& frame) {
                    paint_tiles(frame, [&, settings = settings_of<Settings>(frame.picture)] {
                        return Pixels(frame, settings);
                    });
                });
            },
            names.layers};
}

}  // namespace npr
