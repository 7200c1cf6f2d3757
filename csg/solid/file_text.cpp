#include "csg/solid/file_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace csg::solid {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

}  // namespace

std::optional<std::string> read_file(const std::string& path, std::size_t most, std::vector<std::string>& warnings) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (path.empty() || !fs::is_regular_file(path, error)) {
        warnings.push_back(fmt::format("Can't open import file '{}'", path));
        return std::nullopt;
    }
    const auto size = fs::file_size(path, error);
    if (error || size > most) {
        warnings.push_back(fmt::format("import file '{}' is larger than {} bytes; it is left out", path, most));
        return std::nullopt;
    }
    std::ifstream in(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, in.gcount())));
    return text;
}

std::string file_suffix(const std::string& path) {
    std::string suffix = std::filesystem::path(path).extension().string();
    for (char& c : suffix) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return suffix.empty() ? suffix : suffix.substr(1);
}

std::optional<double> to_number(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

void Words::skip() {
    while (at_ < text_.size()) {
        if (comments_ && text_[at_] == '#') {
            while (at_ < text_.size() && text_[at_] != '\n') {
                ++at_;
            }
        } else if (is_blank(text_[at_])) {
            ++at_;
        } else {
            return;
        }
    }
}

bool Words::at_end() {
    skip();
    return at_ >= text_.size();
}

std::string_view Words::next() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) {
        ++at_;
    }
    return text_.substr(begin, at_ - begin);
}

std::optional<double> Words::number() {
    return to_number(next());
}

std::optional<std::size_t> Words::count() {
    const auto value = number();
    if (!value || *value < 0 || *value > 4294967295.0) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(*value);
}

std::string_view Words::line() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n') {
        ++at_;
    }
    const std::string_view line = text_.substr(begin, at_ - begin);
    at_ += at_ < text_.size();
    return line;
}

}  // namespace csg::solid
