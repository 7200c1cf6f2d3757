#include "ui/command_line/openscad_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

namespace ui {

namespace {

namespace fs = std::filesystem;

/// Did it run and end with 0? What it prints is dropped.
bool run(std::vector<std::string> command) {
    std::vector<char*> arguments;
    for (std::string& word : command) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // However this process ends.
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

}  // namespace

OpenscadProcess::OpenscadProcess(std::string input) : input_(std::move(input)) {
    std::string folder = (fs::temp_directory_path() / "csgscope.XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
        throw std::runtime_error(fmt::format("{}: cannot be created", folder));
    }
    folder_ = folder;
}

OpenscadProcess::~OpenscadProcess() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

csg::reference::Mesh OpenscadProcess::mesh() const {
    const fs::path path = folder_ / "mesh.off";
    if (!run({"openscad", "-q", "-o", path.string(), input_})) {
        throw std::runtime_error("openscad is not installed, or made no mesh of the model");
    }
    return csg::reference::decode_mesh(read(path));
}

std::string OpenscadProcess::tree() const {
    const fs::path path = folder_ / "tree.csg";
    if (!run({"openscad", "-q", "-o", path.string(), input_})) {
        throw std::runtime_error("openscad is not installed, or the model has errors there");
    }
    return read(path);
}

std::optional<base::Image> OpenscadProcess::picture(const base::Camera& camera, int size) const {
    const fs::path path = folder_ / "picture.png";
    std::vector<std::string> command{
        "openscad",
        "-q",
        "--render",
        "-o",
        path.string(),
        fmt::format("--imgsize={0},{0}", size),
        fmt::format("--projection={}", camera.projection == base::Projection::Orthographic ? "o" : "p"),
        fmt::format("--camera={},{},{},{},{},{},{}", camera.target.x, camera.target.y, camera.target.z,
                    camera.rotation.x, camera.rotation.y, camera.rotation.z, camera.distance),
        input_};
    if (std::getenv("DISPLAY") == nullptr) {
        command.insert(command.begin(), {"xvfb-run", "-a"});
    }
    return run(std::move(command)) ? std::optional(base::read_png(path)) : std::nullopt;
}

}  // namespace ui
