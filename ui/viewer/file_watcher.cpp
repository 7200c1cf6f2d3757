#include "ui/viewer/file_watcher.h"

#include <sys/stat.h>

#include <utility>

namespace ui {

namespace {

// Seconds without change before a file counts as written, and before a file that is away counts as gone: editors that
// save by way of a backup leave a gap.
constexpr double kSettled = 0.1, kGone = 0.4;

}  // namespace

FileStamp stamp_of(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) {
        return {};
    }
    return {true,
            static_cast<std::uint64_t>(status.st_dev),
            static_cast<std::uint64_t>(status.st_ino),
            static_cast<std::uint64_t>(status.st_size),
            static_cast<std::int64_t>(status.st_mtim.tv_sec),
            static_cast<std::int64_t>(status.st_mtim.tv_nsec)};
}

FileWatcher::FileWatcher(std::string main_file) : main_file_(std::move(main_file)) {
    watch({});
}

void FileWatcher::watch(const std::map<std::string, FileStamp>& files) {
    std::map<std::string, Watched> watched;
    for (const auto& [path, stamp] : files) {
        watched[path] = {stamp, stamp, 0};
    }
    if (!main_file_.empty() && !watched.contains(main_file_)) {
        const auto before = files_.find(main_file_);
        const FileStamp stamp = before == files_.end() ? stamp_of(main_file_) : before->second.known;
        watched[main_file_] = {stamp, stamp, 0};
    }
    files_ = std::move(watched);
}

bool FileWatcher::poll(double now) {
    bool changed = false;
    for (auto& [path, file] : files_) {
        const bool is_main = path == main_file_;
        if (const FileStamp stamp = stamp_of(path); stamp != file.seen) {
            file.seen = stamp;
            file.seen_since = now;
        }
        const double still = now - file.seen_since;
        if (is_main) {
            main_gone_ = !file.seen.exists && still >= kGone;
        }
        if (file.seen == file.known || still < (file.seen.exists ? kSettled : kGone)) {
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
