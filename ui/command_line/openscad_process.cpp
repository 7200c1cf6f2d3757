#include "ui/command_line/openscad_process.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ui/command_line/child_process.h"

namespace ui {

namespace {

using ProcessArguments = std::vector<std::string>;

/// A file descriptor that programs started do not inherit.
class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {
        if (fd < 0) {
            throw std::system_error(errno, std::generic_category(), "openscad cannot be run");
        }
    }
    ~Descriptor() { close(fd_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return fd_; }

  private:
    int fd_;
};

/// A file in memory.
class MemoryFile {
  public:
    MemoryFile() : file_(memfd_create("csgscope", MFD_CLOEXEC)) {}
    [[nodiscard]] int descriptor() const { return file_.get(); }
    /// To be opened by this process.
    [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", file_.get()); }

  private:
    Descriptor file_;
};

/// Writes to `out`. Did it run and end with 0?
bool run(ProcessArguments command, const MemoryFile& out) {
    return ChildProcess(std::move(command), out.descriptor(), SIGKILL).wait() == 0;
}

/// A display that nobody sees, by Xvfb.
class VirtualDisplay {
  public:
    VirtualDisplay() {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) {
            return;
        }
        const Descriptor from(ends[0]);
        {
            const Descriptor to(ends[1]);
            // At SIGTERM it removes its files.
            server_.emplace(
                ProcessArguments{"Xvfb", "-displayfd", "1", "-screen", "0", "1280x1024x24", "-nolisten", "tcp"},
                to.get(), SIGTERM);
        }
        for (char digit = 0; ::read(from.get(), &digit, 1) == 1 && digit != '\n';) {
            number_ += digit;
        }
    }
    /// As the variable DISPLAY has it; none where there is no Xvfb.
    [[nodiscard]] std::optional<std::string> name() const {
        return number_.empty() ? std::nullopt : std::optional(":" + number_);
    }

  private:
    std::optional<ChildProcess> server_;
    std::string number_;
};

std::string read(const MemoryFile& file) {
    std::ifstream in(file.path(), std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

}  // namespace

OpenscadProcess::OpenscadProcess(std::string input) : input_(std::move(input)) {}

csg::reference::Mesh OpenscadProcess::mesh() const {
    const MemoryFile file;
    if (!run({"openscad", "-q", "-o", "-", "--export-format", "off", input_}, file)) {
        throw std::runtime_error("openscad is not installed, or made no mesh of the model");
    }
    return csg::reference::decode_mesh(read(file));
}

std::string OpenscadProcess::tree() const {
    const MemoryFile file;
    if (!run({"openscad", "-q", "-o", "-", "--export-format", "csg", input_}, file)) {
        throw std::runtime_error("openscad is not installed, or the model has errors there");
    }
    return read(file);
}

std::optional<base::Image> OpenscadProcess::picture(const base::Camera& camera, glm::ivec2 size) const {
    ProcessArguments command{
        "openscad",
        "-q",
        "--render",
        "-o",
        "-",
        "--export-format",
        "png",
        fmt::format("--imgsize={},{}", size.x, size.y),
        fmt::format("--projection={}", camera.projection == base::Projection::Orthographic ? "o" : "p"),
        fmt::format("--camera={},{},{},{},{},{},{}", camera.target.x, camera.target.y, camera.target.z,
                    camera.rotation.x, camera.rotation.y, camera.rotation.z, camera.distance),
        input_};
    std::optional<VirtualDisplay> display;
    if (std::getenv("DISPLAY") == nullptr) {
        const std::optional<std::string> name = display.emplace().name();
        if (!name) {
            return std::nullopt;
        }
        command.insert(command.begin(), {"env", "DISPLAY=" + *name});
    }
    const MemoryFile file;
    return run(std::move(command), file) ? std::optional(base::read_png(file.path())) : std::nullopt;
}

}  // namespace ui
