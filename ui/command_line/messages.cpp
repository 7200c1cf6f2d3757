#include "ui/command_line/messages.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "ui/command_line/standard_streams.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

Messages::Messages(bool quiet) : quiet_(quiet) {
    if (const char* const said = std::getenv(kSaid)) {
        said_ = std::strtoul(said, nullptr, 10);
        unsetenv(kSaid);
    }
}

void Messages::print(const std::string& line) {
    if (count_ > said_) {
        say(line);
    }
}

void Messages::add(const csg::scad::Message& message, const csg::scad::SourceSet& sources) {
    using csg::scad::Severity;
    // As OpenSCAD does: files beside the main one, or below it, are named as seen from there.
    const std::string base =
        sources.size() == 0 ? std::string() : std::filesystem::path(sources[0].name()).parent_path().string();
    std::string line = csg::scad::render_openscad(message, sources, base) + '\n';
    if (each_once_ && !printed_.insert(line).second) {
        return;
    }
    echo_ += line;
    ++count_;
    warnings_ += message.severity == Severity::Warning || message.severity == Severity::Deprecated ? 1 : 0;
    if (message.severity != Severity::Echo) {
        line = printable(line);  // What a model echoes is its own affair.
    }
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
        print(printable(fmt::format("  at {}:{}:{}\n{}", sources[message.where.file].name(), message.where.line,
                                    message.where.column, excerpt.substr(excerpt.find('\n') + 1))));
    }
}

void Messages::warn(const std::string& text) {
    ++warnings_;
    ++count_;
    const std::string line = fmt::format("WARNING: {}\n", text);
    echo_ += line;
    if (!quiet_) {
        print(printable(line));
    }
}

void print_error(std::string_view text) {
    while (true) {
        const std::size_t end = text.find('\n');
        say(printable(fmt::format("csgscope: error: {}\n", text.substr(0, end))));
        if (end == std::string_view::npos) {
            break;
        }
        text.remove_prefix(end + 1);
    }
}

void print_out_of_memory(const std::vector<std::string>& arguments, const char* what_for) {
    const bool limited = std::any_of(arguments.begin(), arguments.end(),
                                     [](const std::string& a) { return a.starts_with("--memory-limit"); });
    say("csgscope: error: out of memory");
    if (what_for != nullptr) {
        say(" for ");
        say(what_for);
    }
    say(limited ? ": --memory-limit is too low for this run\n" : "\n");
}

}  // namespace ui
