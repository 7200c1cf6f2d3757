#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "ui/command_line/language_run.h"
#include "ui/command_line/messages.h"
#include "ui/pipeline/heap.h"

namespace {

/// Becomes the program `name` in this program's folder, with the same arguments; comes back only where that fails.
int become(const char* name, char** arguments) {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::string program = (self.parent_path() / name).string();
    execv(program.c_str(), arguments);
    ui::print_error("cannot run " + program + ": " + std::strerror(errno));
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    ui::keep_freed_memory();
    if (const auto status = ui::run_language({argv + 1, argv + argc})) {
        return *status;
    }
    return become("csgscope-graphics", argv);
}
