#include "csg/scad/source/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace csg::scad {
namespace {

constexpr std::size_t kShownColumns = 120;  // Longer lines are cut around the caret.

bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// A run of bytes as blanks of the same width: a tab stays a tab, a code point becomes one space.
std::string blanks(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (!continues(c)) {
            result += c == '\t' ? '\t' : ' ';
        }
    }
    return result;
}

std::size_t code_points(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

/// The line with carets under [begin, end), both offsets in bytes.
std::string excerpt(std::string_view line, std::size_t begin, std::size_t end) {
    std::size_t from = 0;
    std::size_t to = line.size();
    if (line.size() > kShownColumns) {
        from = begin > kShownColumns / 2 ? begin - kShownColumns / 2 : 0;
        to = std::min(from + kShownColumns, line.size());
        while (from > 0 && continues(line[from])) {
            --from;
        }
        while (to < line.size() && continues(line[to])) {
            ++to;
        }
    }
    const std::string_view head = from > 0 ? "…" : "";
    const std::string_view tail = to < line.size() ? "…" : "";
    end = std::clamp(end, begin, to);
    const std::size_t carets = std::max<std::size_t>(1, code_points(line.substr(begin, end - begin)));
    return fmt::format("{}{}{}\n{}{}{}\n", head, line.substr(from, to - from), tail, blanks(head),
                       blanks(line.substr(from, begin - from)), std::string(carets, '^'));
}

std::string_view openscad_name(Severity severity) {
    switch (severity) {
        case Severity::Error:
            return "ERROR: ";
        case Severity::Warning:
            return "WARNING: ";
        case Severity::Echo:
            return "ECHO: ";
        case Severity::Deprecated:
            return "DEPRECATED: ";
        case Severity::Trace:
            return "TRACE: ";
        case Severity::Info:
            return "";
    }
    return "";
}

}  // namespace

std::string_view severity_name(Severity severity) {
    switch (severity) {
        case Severity::Error:
            return "error";
        case Severity::Warning:
            return "warning";
        case Severity::Echo:
            return "echo";
        case Severity::Deprecated:
            return "deprecated";
        case Severity::Trace:
            return "trace";
        case Severity::Info:
            return "info";
    }
    return "";
}

std::string render(const Message& message, const SourceSet& sources) {
    const std::string_view severity = severity_name(message.severity);
    if (!message.where.known() || message.where.file >= sources.size()) {
        return fmt::format("{}: {}\n", severity, message.text);
    }
    const SourceRange& where = message.where;
    const SourceFile& file = sources[where.file];
    const std::string_view line = file.line(where.line);
    const std::size_t begin = std::min<std::size_t>(where.column > 0 ? where.column - 1 : 0, line.size());
    const std::size_t end = where.end_line == where.line && where.end_column > 0 ? where.end_column - 1
                            : where.end_line > where.line                        ? line.size()
                                                                                 : begin + 1;
    return fmt::format("{}:{}:{}: {}: {}\n{}", file.name(), where.line, code_points(line.substr(0, begin)) + 1,
                       severity, message.text, excerpt(line, begin, end));
}

std::string render_openscad(const Message& message, const SourceSet& sources, std::string_view base_directory) {
    std::string text = fmt::format("{}{}", openscad_name(message.severity), message.text);
    const bool placed = message.where.known() && message.where.file < sources.size() &&
                        message.severity != Severity::Echo && message.severity != Severity::Info;
    if (!placed) {
        return text;
    }
    std::string_view name = sources[message.where.file].name();
    if (message.parsing && !base_directory.empty()) {
        std::error_code error;
        const std::string from_here = std::filesystem::proximate(name, error).string();
        return fmt::format("{} in file {}, line {}", text, error ? name : from_here, message.where.line);
    }
    if (!base_directory.empty() && !name.starts_with('<')) {  // Not a made-up name.
        const std::string from_base = std::filesystem::path(name).lexically_proximate(base_directory).generic_string();
        return fmt::format("{} in file {}, line {}", text, from_base, message.where.line);
    }
    return fmt::format("{} in file {}, line {}", text, name, message.where.line);
}

}  // namespace csg::scad
