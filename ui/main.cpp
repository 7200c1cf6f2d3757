#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "base/temporary_names.h"
#include "ui/command_line/language_run.h"
#include "ui/command_line/messages.h"
#include "ui/command_line/standard_streams.h"
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
    ui::hold_standard_streams();
    base::remove_temporary_names_at_signals();
    ui::keep_freed_memory();
    const auto become_graphics = [argv] { return become("csgscope-graphics", argv); };
    const auto hand_over = [&become_graphics](std::size_t said) {
        setenv(ui::Messages::kSaid, std::to_string(said).c_str(), 1);
        std::exit(become_graphics());
    };
    if (const auto status = ui::run_language({argv + 1, argv + argc}, hand_over)) {
        return *status;
    }
    return become_graphics();
}
