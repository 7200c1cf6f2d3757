#include "ui/command_line/html.h"

#include <cstdint>

#include <fmt/format.h>

#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

std::string base64(const std::string& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            value = value << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += i + k <= bytes.size() ? digits[value >> (18 - 6 * k) & 63] : '=';
        }
    }
    return out;
}

}  // namespace

std::string html(const std::string& text) {
    std::string out;
    for (const char c : printable(text)) {
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    }
    return out;
}

std::string attribute(const std::string& text) {
    std::string out;
    for (const char c : html(text)) {
        out += c == '"' ? "&quot;" : c == '\n' ? "&#10;" : std::string(1, c);
    }
    return out;
}

std::string picture(const base::Image& image, const char* alt) {
    return fmt::format("<img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">", alt, image.width,
                       image.height, base64(base::encode_png(image)));
}

}  // namespace ui
