// Tells when files change, by looking at them: works for editors that write in place, that rename a new file over the
// old one, and on file systems without notification.
#pragma once

#include <map>
#include <string>

#include "csg/scad/source/disk_state.h"

namespace ui {

using csg::scad::DiskState;

class FileWatcher {
  public:
    /// The file without which there is nothing to do; it is always watched. Empty: there is none.
    explicit FileWatcher(std::string main_file = {});

    /// Replaces the files that are watched. The states are those that are known; those taken before a file was read
    /// make sure that no change is missed.
    void watch(const std::map<std::string, DiskState>& files);

    /// Looks at the files. True where one has changed and then kept still for a moment, so that a file is not read
    /// while it is written, or has kept changing for longer than anybody waits; the new state is known from then on.
    /// `now`: seconds of any steady clock.
    [[nodiscard]] bool poll(double now);

    /// The main file was gone at the last poll, and long enough not to be in the middle of being replaced. A main file
    /// that is gone counts as changed only when it is back.
    [[nodiscard]] bool main_file_gone() const { return main_gone_; }

  private:
    struct Watched {
        DiskState known, seen;
        double seen_since = 0;
        double changing_since = 0;  ///< Since when it has not been as it is known.
    };

    std::string main_file_;
    std::map<std::string, Watched> files_;
    bool main_gone_ = false;
};

}  // namespace ui
