// The window: shows a file and follows its changes.
#pragma once

#include <optional>
#include <string>

#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/viewer/revision.h"

namespace ui {

struct WindowOptions {
    Source source;
    CameraRequest camera;
    PictureRequest picture;  ///< Style, scheme, layers and samples to begin with; camera and size are not used.
    goldfeather::EngineOptions engine;
    std::string frames_log;  ///< File for one line of JSON per frame; empty: none.
};

/// Opens the window and returns when it is closed: the exit status 0. Throws std::runtime_error where there is no
/// display, no OpenGL 4.5, or the options do not fit.
[[nodiscard]] int run_window(const WindowOptions& options);

}  // namespace ui
