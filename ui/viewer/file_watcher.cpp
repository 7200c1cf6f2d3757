#include "ui/viewer/file_watcher.h"

#include <utility>

namespace ui {

namespace {

// Seconds without change before a file counts as written, and before a file that is away counts as gone: editors that
// save by way of a backup leave a gap.
constexpr double kSettled = 0.1, kGone = 0.4;
/// Seconds after which a file that is written again and again is read all the same.
constexpr double kLongestWait = 0.5;

}  // namespace

FileWatcher::FileWatcher(std::string main_file) : main_file_(std::move(main_file)) {
    watch({});
}

void FileWatcher::watch(const std::map<std::string, DiskState>& files) {
    std::map<std::string, Watched> watched;
    for (const auto& [path, stamp] : files) {
        watched[path] = {stamp, stamp, 0, 0};
    }
    if (!main_file_.empty() && !watched.contains(main_file_)) {
        const auto before = files_.find(main_file_);
        const DiskState stamp = before == files_.end() ? csg::scad::disk_state(main_file_) : before->second.known;
        watched[main_file_] = {stamp, stamp, 0, 0};
    }
    files_ = std::move(watched);
}

bool FileWatcher::poll(double now) {
    bool changed = false;
    for (auto& [path, file] : files_) {
        const bool is_main = path == main_file_;
        if (const DiskState stamp = csg::scad::disk_state(path); stamp != file.seen) {
            file.changing_since = file.seen == file.known ? now : file.changing_since;
            file.seen = stamp;
            file.seen_since = now;
        }
        const double still = now - file.seen_since;
        if (is_main) {
            main_gone_ = !file.seen.exists && still >= kGone;
        }
        const bool waits = still < (file.seen.exists ? kSettled : kGone) &&
                           !(file.seen.exists && now - file.changing_since >= kLongestWait);
        if (file.seen == file.known || waits) {
            continue;
        }
        if (is_main && !file.seen.exists) {
            file.known = {};  // Whatever comes back is new.
            continue;
        }
        file.known = file.seen;
        changed = true;
    }
    return changed;
}

}  // namespace ui
