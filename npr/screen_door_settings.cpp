#include "npr/screen_door_settings.h"

namespace npr {

const SettingsTable<ScreenDoorSettings>& ScreenDoorSettings::table() {
    using S = ScreenDoorSettings;
    static const SettingsTable<S> all{
        setting<&S::size>(Parameter::number("size", "Size of samples", 1, 0.5F, 16)),
        setting<&S::silhouettes>(Parameter::toggle("silhouettes", "Opaque silhouettes", true)),
    };
    return all;
}

}  // namespace npr
