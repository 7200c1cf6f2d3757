// Parameters of screen-door transparency (docs/transparency/screen-door.md).
#pragma once

#include "npr/settings.h"

namespace npr {

struct ScreenDoorSettings {
    float size{};        ///< Of a surface's samples, by those of the picture.
    bool silhouettes{};  ///< Tilted surfaces are more opaque.

    static const SettingsTable<ScreenDoorSettings>& table();
};

}  // namespace npr
