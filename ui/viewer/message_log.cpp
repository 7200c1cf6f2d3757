#include "ui/viewer/message_log.h"

#include <filesystem>

#include <fmt/format.h>

namespace ui {

namespace {

constexpr std::size_t kMostLines = 20'000, kMostBytes = std::size_t{8} << 20, kLongestLine = 4000;
constexpr std::size_t kMostErrors = 200;

LineKind kind_of(csg::scad::Severity severity) {
    using csg::scad::Severity;
    switch (severity) {
        case Severity::Error:
            return LineKind::Error;
        case Severity::Warning:
        case Severity::Deprecated:
            return LineKind::Warning;
        case Severity::Echo:
            return LineKind::Echo;
        case Severity::Trace:
        case Severity::Info:
            break;
    }
    return LineKind::Note;
}

/// Cut to what a line may be, never within a UTF-8 character.
std::string shortened(std::string_view line) {
    if (line.size() <= kLongestLine) {
        return std::string(line);
    }
    std::size_t end = kLongestLine;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) {
        --end;
    }
    return std::string(line.substr(0, end)) + "…";
}

std::string first_line(std::string_view text) {
    return shortened(text.substr(0, text.find('\n')));
}

}  // namespace

bool MessageLog::count(LineKind kind) {
    if (kind == LineKind::Warning) {
        ++warnings_;
    }
    return kind == LineKind::Error && errors_++ == 0;
}

bool MessageLog::room_for(LineKind kind) {
    const bool full = lines_.size() >= kMostLines || bytes_ >= kMostBytes;
    if (full && (kind != LineKind::Error || errors_ > kMostErrors)) {
        ++left_out_;
        return false;
    }
    return true;
}

void MessageLog::append(LineKind kind, const std::string& text, const std::shared_ptr<const TextPlace>& place) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines_.push_back({begin == 0 ? kind : LineKind::Excerpt,
                          shortened(std::string_view(text).substr(begin, end - begin)), place});
        bytes_ += lines_.back().text.size();
        begin = end + 1;
    }
}

void MessageLog::add(const csg::scad::Message& message, const csg::scad::SourceSet& sources) {
    const LineKind kind = kind_of(message.severity);
    const bool located = message.where.known() && message.where.file < sources.size();
    if (count(kind)) {
        std::string headline = message.text;
        if (located) {
            const std::filesystem::path name(sources[message.where.file].name());
            headline = fmt::format("{}:{}:{}: {}", name.filename().string(), message.where.line, message.where.column,
                                   message.text);
        }
        first_error_ = first_line(headline);
    }
    if (room_for(kind)) {
        const bool excerpt = located && (kind == LineKind::Error || kind == LineKind::Warning);
        const auto place =
            located ? std::make_shared<const TextPlace>(TextPlace{sources.shared(message.where.file), message.where})
                    : nullptr;
        append(kind, excerpt ? csg::scad::render(message, sources) : csg::scad::render_openscad(message, sources),
               place);
    }
}

void MessageLog::add(LineKind kind, const std::string& text) {
    if (count(kind)) {
        first_error_ = first_line(text);
    }
    if (room_for(kind)) {
        append(kind, text);
    }
}

std::string MessageLog::text() const {
    std::string all;
    for (const LogLine& line : lines_) {
        all += line.text + '\n';
    }
    if (left_out_ != 0) {
        all += fmt::format("… and {} more messages\n", left_out_);
    }
    return all;
}

}  // namespace ui
