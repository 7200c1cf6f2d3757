#include "ui/viewer/editor.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <thread>

#include <fmt/format.h>

#include "base/program_arguments.h"

namespace ui {

namespace {

enum class Way { PlusLine, PlusLineColumn, Colons, Goto, Options };

struct Known {
    std::string_view name;
    Way way = Way::PlusLine;
    bool terminal = false;
};

constexpr std::array kKnown{Known{"code", Way::Goto},
                            Known{"codium", Way::Goto},
                            Known{"subl", Way::Colons},
                            Known{"zed", Way::Colons},
                            Known{"kate", Way::Options},
                            Known{"kwrite", Way::Options},
                            Known{"gedit", Way::PlusLineColumn},
                            Known{"emacs", Way::PlusLineColumn},
                            Known{"emacsclient", Way::PlusLineColumn},
                            Known{"gvim", Way::PlusLine},
                            Known{"vi", Way::PlusLine, true},
                            Known{"vim", Way::PlusLine, true},
                            Known{"nvim", Way::PlusLine, true},
                            Known{"nano", Way::PlusLine, true},
                            Known{"hx", Way::Colons, true},
                            Known{"micro", Way::Colons, true}};

}  // namespace

std::vector<std::string> editor_command(std::string_view editor, const std::string& path, std::uint32_t line,
                                        std::uint32_t column) {
    std::vector<std::string> command;
    std::istringstream words{std::string(editor)};
    for (std::string word; words >> word;) {
        command.push_back(word);
    }
    if (command.empty()) {
        return command;
    }
    const std::string name = std::filesystem::path(command[0]).filename().string();
    const auto* const found = std::ranges::find(kKnown, name, &Known::name);
    const Known known = found == kKnown.end() ? Known{} : *found;
    switch (known.way) {
        case Way::Goto:
            command.emplace_back("--goto");
            command.push_back(fmt::format("{}:{}:{}", path, line, column));
            break;
        case Way::Colons:
            command.push_back(fmt::format("{}:{}:{}", path, line, column));
            break;
        case Way::Options:
            command.emplace_back("--line");
            command.push_back(std::to_string(line));
            command.emplace_back("--column");
            command.push_back(std::to_string(column));
            command.push_back(path);
            break;
        case Way::PlusLineColumn:
            command.push_back(fmt::format("+{}:{}", line, column));
            command.push_back(path);
            break;
        case Way::PlusLine:
            command.push_back(fmt::format("+{}", line));
            command.push_back(path);
            break;
    }
    if (known.terminal) {
        command.emplace(command.begin(), "-e");
        command.emplace(command.begin(), "x-terminal-emulator");
    }
    return command;
}

std::string open_editor(const std::string& path, std::uint32_t line, std::uint32_t column) {
    const auto variable = [](const char* name) {
        const char* const value = std::getenv(name);
        return std::string(value != nullptr ? value : "");
    };
    const std::string editor = variable("VISUAL").empty() ? variable("EDITOR") : variable("VISUAL");
    std::vector<std::string> command = editor_command(editor, path, line, column);
    if (command.empty()) {
        return "No editor is set: $VISUAL names it";
    }
    const std::vector<char*> arguments = base::program_arguments(command);
    pid_t child = 0;
    const int error = posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ);
    if (error != 0) {
        return fmt::format("{}: {}", command[0], std::strerror(error));
    }
    std::thread([child] { (void)waitpid(child, nullptr, 0); }).detach();  // It ends when it likes.
    return "";
}

}  // namespace ui
