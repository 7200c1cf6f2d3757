// The page of a drawing as PDF (ISO 32000): written object by object, which needs no library and gives the same bytes
// on every machine.
#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "csg/solid/outline_files.h"

namespace csg::solid {
namespace {

constexpr double kPointsPerMillimeter = 72 / 25.4;
constexpr double kMargin = 15;      // millimeters: rulers and texts stand in it
constexpr double kInset = 5;        // of the rulers from the edge of the paper, which printers may not reach
constexpr double kLetters = 2.8;    // size of the type
constexpr double kHairline = 0.12;  // of rulers

/// The content of the page, in millimeters from its lower left corner.
class Canvas {
  public:
    Canvas() { raw(fmt::format("{} 0 0 {} 0 0 cm\n", number(kPointsPerMillimeter), number(kPointsPerMillimeter))); }

    void line(const glm::dvec2& from, const glm::dvec2& to) {
        raw(fmt::format("{} m {} l S\n", point(from), point(to)));
    }
    void stroke(const Rgb8& color, double width) { raw(fmt::format("{} RG {} w\n", components(color), number(width))); }
    /// Letters from `at` on; `quarter`: turned to run upwards.
    void text(const glm::dvec2& at, const std::string& text, bool quarter = false) {
        raw(fmt::format("BT /F {} Tf {} {} Tm ({}) Tj ET\n", number(kLetters), quarter ? "0 1 -1 0" : "1 0 0 1",
                        point(at), escaped(text)));
    }
    void region(const Outline& outline, const glm::dvec2& shift, const Paint& paint) {
        if (!paint.fill && !paint.stroke) {
            return;
        }
        raw("q\n");
        if (paint.fill) {
            raw(fmt::format("{} rg\n", components(paint.fill_color)));
        }
        if (paint.stroke) {
            raw(fmt::format("{} RG {} w 1 j\n", components(paint.stroke_color), number(paint.stroke_width)));
        }
        for (const Loop& loop : outline.loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                raw(fmt::format("{} {}\n", point(loop[i] + shift), i == 0 ? 'm' : 'l'));
            }
            raw("h\n");
        }
        raw(paint.fill && paint.stroke ? "B*\nQ\n" : paint.fill ? "f*\nQ\n" : "S\nQ\n");
    }

    [[nodiscard]] const std::string& content() const { return content_; }

  private:
    static std::string number(double value) {
        std::string text = fmt::format("{:.5f}", value);  // PDF knows no exponents.
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
        return text == "-0" ? "0" : text;
    }
    static std::string point(const glm::dvec2& p) { return number(p.x) + ' ' + number(p.y); }
    static std::string components(const Rgb8& color) {
        return fmt::format("{} {} {}", number(color[0] / 255.0), number(color[1] / 255.0), number(color[2] / 255.0));
    }
    /// The font knows what ASCII has; each character beyond becomes one '?'.
    static std::string escaped(const std::string& text) {
        std::string out;
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte >= 0x80 && byte < 0xC0) {
                continue;
            }
            if (c == '(' || c == ')' || c == '\\') {
                out += '\\';
            }
            out += byte < 32 || byte > 126 ? '?' : c;
        }
        return out;
    }
    void raw(const std::string& text) { content_ += text; }

    std::string content_;
};

/// UTF-8 as PDF's text string: UTF-16 in hexadecimal digits.
std::string text_string(const std::string& text) {
    std::string out = "<FEFF";
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        std::uint32_t code = length == 1 ? lead : lead & (0x7Fu >> length);
        for (std::size_t k = 1; k < length && i + k < text.size(); ++k) {
            code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3Fu);
        }
        i += length;
        if (code < 0x10000) {
            out += fmt::format("{:04X}", code);
        } else {
            out += fmt::format("{:04X}{:04X}", 0xD800 + ((code - 0x10000) >> 10), 0xDC00 + ((code - 0x10000) & 0x3FF));
        }
    }
    return out + ">";
}

/// Objects, their table, and where it is.
std::string document(const std::vector<std::string>& objects, const std::string& trailer) {
    std::string out = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";
    std::vector<std::size_t> offsets;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        offsets.push_back(out.size());
        out += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
    }
    const std::size_t table = out.size();
    out += fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
    for (const std::size_t offset : offsets) {
        out += fmt::format("{:010} 00000 n \n", offset);
    }
    return out + fmt::format("trailer\n<< /Size {} {} >>\nstartxref\n{}\n%%EOF\n", objects.size() + 1, trailer, table);
}

glm::dvec2 paper_of(const PdfPage& page, const glm::dvec2& drawing) {
    const bool wide = page.turn == PageTurn::Landscape || (page.turn == PageTurn::Auto && drawing.x > drawing.y);
    return wide ? glm::dvec2(page.paper.y, page.paper.x) : page.paper;
}

void draw_grid(Canvas& canvas, const glm::dvec2& paper, const glm::dvec2& shift, double size) {
    canvas.stroke({191, 210, 220}, kHairline);
    for (int axis = 0; axis < 2; ++axis) {
        const double from = kMargin - shift[axis], to = paper[axis] - kMargin - shift[axis];
        for (double i = std::ceil(from / size); i * size <= to; ++i) {
            glm::dvec2 lo(kMargin), hi = paper - kMargin;
            lo[axis] = hi[axis] = i * size + shift[axis];
            canvas.line(lo, hi);
        }
    }
}

/// A mark every millimeter, longer ones every 5 and 10, numbers every 20: the model's coordinates.
void draw_ruler(Canvas& canvas, const glm::dvec2& paper, const glm::dvec2& shift, int axis) {
    const int across = 1 - axis;
    glm::dvec2 from(0.0), to(0.0);
    from[axis] = kMargin;
    to[axis] = paper[axis] - kMargin;
    from[across] = to[across] = kInset;
    canvas.line(from, to);
    const long last = std::lround(std::floor(to[axis] - shift[axis]));
    for (long mark = std::lround(std::ceil(from[axis] - shift[axis])); mark <= last; ++mark) {
        from[axis] = to[axis] = static_cast<double>(mark) + shift[axis];
        to[across] = kInset + (mark % 10 == 0 ? 4 : mark % 5 == 0 ? 2.5 : 1.5);
        canvas.line(from, to);
        if (mark % 20 == 0) {
            glm::dvec2 at = to;
            at[axis] += 0.6;
            at[across] += axis == 0 ? -1.2 : 1.2 + 0.35 * kLetters;
            canvas.text(at, fmt::format("{}", mark), axis == 1);
        }
    }
}

}  // namespace

bool beyond_page(const Outline& outline, const PdfPage& page) {
    const glm::dvec2 size(bounds_of(outline.loops).size());
    const glm::dvec2 room = paper_of(page, size) - 2 * kMargin;
    return size.x > room.x || size.y > room.y;
}

std::string encode_pdf(const Outline& outline, const PdfPage& page) {
    const Box box = bounds_of(outline.loops);
    const glm::dvec2 paper = paper_of(page, glm::dvec2(box.size()));
    // The model's origin on the paper.
    const glm::dvec2 shift = 0.5 * paper - glm::dvec2(box.center());
    Canvas canvas;
    if (page.grid) {
        draw_grid(canvas, paper, shift, page.grid_size);
    }
    canvas.region(outline, shift, page.paint);
    canvas.stroke({0, 0, 0}, kHairline);
    if (page.scale) {
        draw_ruler(canvas, paper, shift, 0);
        draw_ruler(canvas, paper, shift, 1);
    }
    if (page.scale && page.scale_message) {
        canvas.text({kMargin, paper.y - 8}, "True size: the rulers are in millimeters. Measure both on the print.");
    }
    if (!page.file_name.empty()) {
        canvas.text({kMargin, paper.y - 12}, page.file_name);
    }

    const glm::dvec2 points = paper * kPointsPerMillimeter;
    std::string properties = "/Producer (csgscope)";
    for (const auto& [key, value] : {std::pair("Title", page.title), std::pair("Author", page.author),
                                     std::pair("Subject", page.subject), std::pair("Keywords", page.keywords)}) {
        if (!value.empty()) {
            properties += fmt::format(" /{} {}", key, text_string(value));
        }
    }
    return document({"<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
                     fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {:.3f} {:.3f}] /Contents 4 0 R "
                                 "/Resources << /Font << /F 5 0 R >> >> >>",
                                 points.x, points.y),
                     fmt::format("<< /Length {} >>\nstream\n{}endstream", canvas.content().size(), canvas.content()),
                     "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
                     "<< " + properties + " >>"},
                    "/Root 1 0 R /Info 6 0 R");
}

}  // namespace csg::solid
