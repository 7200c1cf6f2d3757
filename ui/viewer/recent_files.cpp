#include "ui/viewer/recent_files.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/file.h"

namespace ui {

RecentFiles::RecentFiles(std::filesystem::path file) : file_(std::move(file)) {
    read();
}

void RecentFiles::read() {
    paths_.clear();
    std::istringstream lines(file_.empty() ? "" : base::read_regular_file(file_).value_or(""));
    for (std::string line; paths_.size() < kMost && std::getline(lines, line);) {
        std::error_code error;
        if (std::filesystem::is_regular_file(line, error)) {
            paths_.push_back(line);
        }
    }
}

void RecentFiles::add(const std::filesystem::path& opened) {
    std::error_code error;
    const std::string path = std::filesystem::absolute(opened, error).lexically_normal().string();
    if (error || path.find('\n') != std::string::npos || !std::filesystem::is_regular_file(path, error)) {
        return;
    }
    read();
    std::erase(paths_, path);
    paths_.insert(paths_.begin(), path);
    paths_.resize(std::min(paths_.size(), kMost));
    if (file_.empty()) {
        return;
    }
    std::string text;
    for (const std::string& each : paths_) {
        text += each + '\n';
    }
    try {
        base::make_folder(file_.parent_path());
        base::write_file(file_, text);
    } catch (const std::runtime_error&) {
        // The list of this run is as good.
    }
}

std::filesystem::path RecentFiles::state_file() {
    const auto variable = [](const char* name) {
        const char* const value = std::getenv(name);
        return std::filesystem::path(value != nullptr ? value : "");
    };
    std::filesystem::path state = variable("XDG_STATE_HOME");
    if (!state.is_absolute()) {
        const std::filesystem::path home = variable("HOME");
        if (!home.is_absolute()) {
            return {};
        }
        state = home / ".local" / "state";
    }
    return state / "csgscope" / "recent";
}

}  // namespace ui
