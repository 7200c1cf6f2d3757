#include "ui/command_line/files.h"

#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "csg/scad/source/source.h"
#include "ui/command_line/child_process.h"
#include "ui/command_line/options.h"
#include "ui/command_line/standard_streams.h"

namespace ui {

namespace {

/// What a name needs to stand in a makefile.
std::string escape_for_make(const std::string& name) {
    std::string escaped;
    for (const char c : name) {
        if (c == ' ' || c == '#' || c == '\\') {
            escaped += '\\';
        }
        escaped += c == '$' ? "$$" : std::string(1, c);
    }
    return escaped;
}

}  // namespace

std::string read_source(const std::string& path) {
    auto text = csg::scad::read_source_file(path);
    if (const auto* error = std::get_if<csg::scad::ReadError>(&text)) {
        throw UsageError(error->text);
    }
    return std::get<std::string>(std::move(text));
}

std::string read_standard_input() {
    std::string text;
    std::array<char, 65536> chunk{};
    while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), stdin)) {
        text.append(chunk.data(), count);
        if (text.size() > csg::scad::kMaxSourceBytes) {
            throw UsageError(fmt::format("standard input: longer than {} MiB", csg::scad::kMaxSourceBytes >> 20));
        }
    }
    if (std::ferror(stdin) != 0) {
        throw UsageError(fmt::format("standard input: {}", std::strerror(errno)));
    }
    return text;
}

OutputFile::OutputFile(const std::string& path) {
    if (path != "-") {
        file_.emplace(path);
    }
}

void OutputFile::write(std::string_view bytes) {
    constexpr std::size_t kPiece = std::size_t{1} << 16;
    if (file_) {
        file_->write(bytes);
        return;
    }
    waiting_ += bytes;
    if (waiting_.size() >= kPiece) {
        write_standard_output(waiting_);
        waiting_.clear();
    }
}

void OutputFile::finish() {
    if (file_) {
        file_->finish();
    } else {
        write_standard_output(waiting_);
        waiting_.clear();
    }
}

void write_output(const std::string& path, const std::string& bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.finish();
}

std::string text_of(const Json& json) {
    return json.dump(2) + "\n";
}

std::string dependency_rules(const std::vector<std::string>& targets, const std::vector<std::string>& sources) {
    std::string rules;
    for (const std::string& target : targets) {
        rules += escape_for_make(target) + ":";
        for (const std::string& source : sources) {
            rules += " \\\n\t" + escape_for_make(source);
        }
        rules += '\n';
    }
    return rules;
}

std::string run_make_command(const std::string& command, const std::string& path) {
    std::string line = command + " '";
    for (const char c : path) {
        line += c == '\'' ? "'\\''" : std::string(1, c);
    }
    line += '\'';
    // The shell passes on what ends it, to all that the command has begun.
    const char* const kScript = "trap 'trap - TERM; kill 0' TERM; (eval \"$1\") & wait $!";
    const int status = ChildProcess({"sh", "-c", kScript, "sh", line}, -1, SIGTERM).wait();
    if (status == 0) {
        return {};
    }
    return WIFEXITED(status) ? fmt::format("-m: {} ended with status {}", line, WEXITSTATUS(status))
                             : fmt::format("-m: {} did not end by itself", line);
}

}  // namespace ui
