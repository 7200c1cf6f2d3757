#include "tests/ui/viewer/x_display.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace ui {

namespace {

bool in_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((folder + '/' + program).c_str(), X_OK) == 0) {
            return true;
        }
    }
    return false;
}

void set_environment(const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        unsetenv(assignment.c_str());
    } else {
        setenv(assignment.substr(0, equals).c_str(), assignment.c_str() + equals + 1, 1);
    }
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                 const std::string& output, int pass_descriptor) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    pid_ = fork();
    if (pid_ < 0) {
        throw std::runtime_error("fork failed");
    }
    if (pid_ == 0) {
        const int file = open(output.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        for (const std::string& assignment : environment) {
            set_environment(assignment);
        }
        if (pass_descriptor >= 0) {
            fcntl(pass_descriptor, F_SETFD, 0);
        }
        execvp(argv[0], argv.data());
        _exit(127);
    }
}

Process::~Process() {
    if (!status_) {
        kill(pid_, SIGTERM);  // Lets the X server remove its lock.
    }
    if (!wait(std::chrono::seconds(5))) {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
}

std::optional<int> Process::wait(std::chrono::seconds most) {
    const auto end = std::chrono::steady_clock::now() + most;
    while (!status_) {
        int status = 0;
        if (waitpid(pid_, &status, WNOHANG) == pid_) {
            status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        } else if (std::chrono::steady_clock::now() > end) {
            break;
        } else {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    }
    return status_;
}

void Process::kill_at_once() {
    if (!status_) {
        kill(pid_, SIGKILL);
        (void)wait(std::chrono::seconds(20));
    }
}

double Process::processor_seconds() const {
    std::ifstream file("/proc/" + std::to_string(pid_) + "/stat");
    std::string text;
    std::getline(file, text);
    std::istringstream fields(text.substr(text.rfind(')') + 1));  // The name before may hold anything.
    std::string skipped;
    for (int i = 0; i < 11; ++i) {
        fields >> skipped;
    }
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::size_t Process::resident_bytes() const {
    std::ifstream file("/proc/" + std::to_string(pid_) + "/statm");
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::string XDisplay::missing_program() {
    for (const char* program : {"Xvfb", "xdotool", "import"}) {
        if (!in_path(program)) {
            return program;
        }
    }
    return {};
}

XDisplay::XDisplay(std::string folder) : folder_(std::move(folder)) {
    if (pipe2(pipe_, O_CLOEXEC) != 0) {
        throw std::runtime_error("pipe failed");
    }
    server_.emplace(std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(pipe_[1]), "-screen", "0",
                                             "1360x880x24", "-nolisten", "tcp", "-noreset"},
                    std::vector<std::string>{}, folder_ + "/xvfb.log", pipe_[1]);
    close(pipe_[1]);
    // The server writes the number of the display once it takes connections.
    for (char c = 0; c != '\n';) {
        pollfd ready{pipe_[0], POLLIN, 0};
        if (poll(&ready, 1, 30'000) != 1 || read(pipe_[0], &c, 1) != 1) {
            close(pipe_[0]);
            throw std::runtime_error("Xvfb does not start");
        }
        name_ += c;
    }
    close(pipe_[0]);
    name_ = ':' + name_.substr(0, name_.size() - 1);
}

void XDisplay::robot(const std::string& commands) const {
    if (std::system(("DISPLAY=" + name_ + " xdotool " + commands + " >>'" + folder_ + "/xdotool.log' 2>&1").c_str()) !=
        0) {
        throw std::runtime_error("xdotool " + commands + " failed");
    }
}

base::Image XDisplay::screenshot() const {
    const std::string path = folder_ + "/screenshot.png";
    if (std::system(("import -display " + name_ + " -window root -depth 8 '" + path + "'").c_str()) != 0) {
        throw std::runtime_error("no screenshot");
    }
    return base::read_png(path);
}

}  // namespace ui
