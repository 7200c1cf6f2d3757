#include "ui/pipeline/editing/recovery.h"

#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill() is POSIX's.
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "base/file.h"

namespace ui {

namespace {

constexpr std::string_view kFirst = "csgscope recovery 1\n";

bool runs(pid_t process) {
    return kill(process, 0) == 0 || errno == EPERM;
}

/// A line up to its end, and behind it; nothing where none ends.
std::optional<std::string_view> take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    return line;
}

}  // namespace

std::string Recovery::stem() const {
    std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a.
    for (const char c : path_) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    }
    return fmt::format("{:016x}-", hash);
}

std::filesystem::path Recovery::own() const {
    return folder_ / (stem() + std::to_string(getpid()));
}

void Recovery::keep(const std::string& saved, const std::string& text) const {
    if (folder_.empty()) {
        return;
    }
    try {
        base::make_folder(folder_);
        base::write_file(own(), fmt::format("{}{}\n{}\n{}{}", kFirst, path_, saved.size(), saved, text));
    } catch (const std::runtime_error&) {
        // The text is on the screen.
    }
}

void Recovery::drop() const {
    std::error_code ignored;
    if (!folder_.empty()) {
        std::filesystem::remove(own(), ignored);
    }
}

std::optional<Recovery::Left> Recovery::left() const {
    std::optional<Left> newest;
    std::filesystem::file_time_type time;
    std::error_code error;
    if (folder_.empty()) {
        return newest;
    }
    for (std::filesystem::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string(), begin = stem();
        char* behind = nullptr;
        const long process = name.starts_with(begin) ? std::strtol(name.c_str() + begin.size(), &behind, 10) : 0;
        if (process <= 0 || *behind != '\0' || runs(static_cast<pid_t>(process))) {
            continue;
        }
        const std::string all = base::read_regular_file(at->path()).value_or("");
        std::string_view rest = all;
        if (!rest.starts_with(kFirst)) {
            continue;
        }
        rest.remove_prefix(kFirst.size());
        const auto path = take_line(rest), size = take_line(rest);
        const std::size_t saved = size ? std::strtoul(std::string(*size).c_str(), nullptr, 10) : 0;
        std::error_code unknown;
        const auto written = std::filesystem::last_write_time(at->path(), unknown);
        if (path == path_ && size && saved <= rest.size() && (!newest || written > time)) {
            newest = Left{at->path(), std::string(rest.substr(0, saved)), std::string(rest.substr(saved))};
            time = written;
        }
    }
    return newest;
}

void Recovery::forget(const Left& left) {
    std::error_code ignored;
    std::filesystem::remove(left.kept, ignored);
}

}  // namespace ui
