#include "ui/viewer/window.h"

#include "ui/viewer/window_loop.h"

namespace ui {

WindowEnd run_window(const WindowOptions& options) {
    auto loop = std::make_unique<WindowLoop>(options);
    const WindowEnd end = loop->run();
    if (end == WindowEnd::StillDrawing) {
        (void)loop.release();  // Its end would wait for the thread.
    }
    return end;
}

}  // namespace ui
