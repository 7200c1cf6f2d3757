#include "ui/command_line/messages.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

namespace ui {

Messages::Messages(bool quiet) : quiet_(quiet) {
    if (const char* const said = std::getenv(kSaid)) {
        said_ = std::strtoul(said, nullptr, 10);
        unsetenv(kSaid);
    }
}

void Messages::print(const std::string& line) {
    if (count_ > said_) {
        fmt::print(stderr, "{}", line);
    }
}

void Messages::add(const csg::scad::Message& message, const csg::scad::SourceSet& sources) {
    using csg::scad::Severity;
    // As OpenSCAD does: files beside the main one, or below it, are named as seen from there.
    const std::string base =
        sources.size() == 0 ? std::string() : std::filesystem::path(sources[0].name()).parent_path().string();
    const std::string line = csg::scad::render_openscad(message, sources, base) + '\n';
    echo_ += line;
    ++count_;
    warnings_ += message.severity == Severity::Warning || message.severity == Severity::Deprecated ? 1 : 0;
    if (message.severity != Severity::Error) {
        if (!quiet_) {
            print(line);
        }
        return;
    }
    print(line);
    if (message.where.known()) {
        // The compiler's form, without its own first line, which says what `line` has said.
        const std::string excerpt = csg::scad::render(message, sources);
        print(fmt::format("  at {}:{}:{}\n{}", sources[message.where.file].name(), message.where.line,
                          message.where.column, excerpt.substr(excerpt.find('\n') + 1)));
    }
}

void Messages::warn(const std::string& text) {
    ++warnings_;
    ++count_;
    const std::string line = fmt::format("WARNING: {}\n", text);
    echo_ += line;
    if (!quiet_) {
        print(line);
    }
}

void print_error(const std::string& text) {
    fmt::print(stderr, "csgscope: error: {}\n", text);
}

void print_out_of_memory(const std::vector<std::string>& arguments) {
    const bool limited = std::any_of(arguments.begin(), arguments.end(),
                                     [](const std::string& a) { return a.starts_with("--memory-limit"); });
    std::fputs(limited ? "csgscope: error: out of memory: --memory-limit is too low for this run\n"
                       : "csgscope: error: out of memory\n",
               stderr);
}

}  // namespace ui
