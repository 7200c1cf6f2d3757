#include "ui/viewer/window.h"

#include "ui/viewer/window_loop.h"

namespace ui {

int run_window(const WindowOptions& options) {
    (void)view_state_of(options.picture);  // Wrong options are told before a window opens.
    WindowLoop loop(options);
    loop.run();
    return 0;
}

}  // namespace ui
