#include "ui/viewer/window.h"

#include "ui/viewer/window_loop.h"

namespace ui {

int run_window(const WindowOptions& options) {
    check_picture(options.picture);  // Wrong options are told before a window opens.
    WindowLoop loop(options);
    loop.run();
    return 0;
}

}  // namespace ui
