#include "ui/viewer/export_job.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "base/program_arguments.h"

namespace ui {

namespace {

/// A file descriptor that is closed in the end.
class Descriptor {
  public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return fd_; }
    void close() {
        if (const int fd = std::exchange(fd_, -1); fd >= 0) {
            ::close(fd);
        }
    }

  private:
    int fd_;
};

/// A file in memory that begins with the text; -1 where there is no room for it.
int memory_file(const std::string& text) {
    const int fd = memfd_create("csgscope", MFD_CLOEXEC);
    for (std::size_t done = 0; fd >= 0 && done < text.size();) {
        const ssize_t written = write(fd, text.data() + done, text.size() - done);
        if (written <= 0) {
            ::close(fd);
            return -1;
        }
        done += static_cast<std::size_t>(written);
    }
    if (fd >= 0) {
        lseek(fd, 0, SEEK_SET);
    }
    return fd;
}

/// Starts it in the folder (empty: this one), with standard input and standard error as given; an error number, 0 where
/// it runs.
int start_program(std::vector<std::string> command, const std::string& folder, int input, int errors, pid_t& pid) {
    const std::vector<char*> arguments = base::program_arguments(command);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (input >= 0) {
        posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    } else {
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    }
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    if (!folder.empty()) {
        posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    }
    const int error = posix_spawn(&pid, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/// What comes until the other end is closed; the program is ended where that is asked for.
std::string read_all(int fd, pid_t pid, const std::stop_token& stop) {
    constexpr std::size_t kMost = std::size_t{1} << 20;
    constexpr int kLook = 50;  // Milliseconds.
    std::string text;
    std::array<char, 4096> buffer{};
    bool ended = false;
    for (;;) {
        if (stop.stop_requested() && !std::exchange(ended, true)) {
            kill(pid, SIGTERM);
        }
        pollfd waiting{fd, POLLIN, 0};
        if (poll(&waiting, 1, kLook) == 0) {
            continue;
        }
        const ssize_t count = read(fd, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count <= 0) {
            return text;
        }
        text.append(buffer.data(), text.size() < kMost ? static_cast<std::size_t>(count) : 0);
    }
}

Exported run(const Source& source, const std::filesystem::path& path, const std::vector<std::string>& more,
             const std::stop_token& stop) {
    Exported result{path, false, {}};
    const std::optional<std::string>& text = source.edited ? source.edited : source.text;
    const Descriptor input(text ? memory_file(*text) : -1);
    std::array<int, 2> ends{-1, -1};
    if ((text && input.get() < 0) || pipe2(ends.data(), O_CLOEXEC) != 0) {
        result.text = std::strerror(errno);
        return result;
    }
    const Descriptor from(ends[0]);
    Descriptor to(ends[1]);
    pid_t pid = 0;
    // What standard input includes is looked for in the folder that the program is in.
    std::error_code unknown;
    const std::string folder =
        source.edited ? std::filesystem::absolute(source.path, unknown).parent_path().string() : std::string();
    std::vector<std::string> arguments =
        export_arguments(source, source.edited ? std::filesystem::absolute(path, unknown) : path);
    arguments.insert(arguments.end(), more.begin(), more.end());
    if (const int error = start_program(arguments, folder, input.get(), to.get(), pid); error != 0) {
        result.text = std::strerror(error);
        return result;
    }
    to.close();
    result.text = read_all(from.get(), pid, stop);
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    result.good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return result;
}

}  // namespace

std::vector<std::string> export_arguments(const Source& source, const std::filesystem::path& path) {
    std::vector<std::string> arguments{"csgscope", source.text || source.edited ? "-" : source.path, "--quiet", "-o",
                                       path.string()};
    for (const auto* definitions : {&source.definitions, &source.customized}) {
        for (const std::string& definition : *definitions) {
            arguments.emplace_back("-D");
            arguments.push_back(definition);
        }
    }
    if (source.hard_warnings) {
        arguments.emplace_back("--hardwarnings");
    }
    for (const auto& [on, feature] :
         {std::pair(source.lazy_union, "lazy-union"), std::pair(source.by_error, "discretization-by-error")}) {
        if (on) {
            arguments.emplace_back("--enable");
            arguments.emplace_back(feature);
        }
    }
    return arguments;
}

void ExportJob::start(const Source& source, const std::filesystem::path& path, const std::vector<std::string>& more) {
    job_.start([source, path, more](const std::stop_token& stop) { return run(source, path, more, stop); });
}

}  // namespace ui
