// The window: shows a file and follows its changes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/viewer/dynamics_commands.h"
#include "ui/viewer/revision.h"

namespace ui {

struct WindowOptions {
    Source source;
    CameraRequest camera;
    PictureRequest picture;  ///< Style, scheme, layers and samples to begin with; camera and size are not used.
    goldfeather::EngineOptions engine;
    std::string frames_log;            ///< File for one line of JSON per frame; empty: none.
    std::filesystem::path settings{};  ///< Kept there; empty: as by default, and not kept.
    GlyphTexts glyphs{};               ///< To begin with.
};

/// How things stand when the window is closed.
enum class WindowEnd {
    Done,
    /// A thread draws still: a model that is made ready for drawing cannot be stopped. The thread and what it draws are
    /// left alone for ever; the process must end without running down (std::_Exit).
    StillDrawing,
};

/// Where settings are kept: $XDG_STATE_HOME/csgscope/settings, by default below ~/.local/state; empty where there is no
/// home.
[[nodiscard]] std::filesystem::path settings_file();

/// Opens the window and returns when it is closed. Throws std::runtime_error where there is no display or no
/// OpenGL 4.5.
[[nodiscard]] WindowEnd run_window(const WindowOptions& options);

}  // namespace ui
