// How a style drawn by hand finds its settings. Internal to npr/styles.
#pragma once

#include "npr/styles/sketch_settings.h"

namespace npr {

struct Hand {
    const SettingsTable<SketchSettings>* table = nullptr;
    void (*set)(SketchSettings&) = nullptr;

    [[nodiscard]] SketchSettings settings(const Picture& picture) const {
        SketchSettings s = table->settings(picture.parameters, picture.pixels_per_millimeter());
        set(s);
        s.complete(picture);
        return s;
    }
};

}  // namespace npr
