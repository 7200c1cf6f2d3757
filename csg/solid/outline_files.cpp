#include "csg/solid/outline_files.h"

#include <fmt/format.h>

namespace csg::solid {
namespace {

using Text = fmt::memory_buffer;

template <typename... Args>
void put(Text& out, fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(fmt::appender(out), format, std::forward<Args>(args)...);
}

std::string css(const Rgb8& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

}  // namespace

std::string encode_svg(const Outline& outline, const Paint& paint) {
    const Box box = bounds_of(outline.loops);
    const glm::dvec3 size = box.size();
    Text out;
    put(out,
        "<?xml version=\"1.0\" standalone=\"no\"?>\n"
        "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\">\n"
        "<svg width=\"{}mm\" height=\"{}mm\" viewBox=\"{} {} {} {}\" xmlns=\"http://www.w3.org/2000/svg\" "
        "version=\"1.1\">\n<title>OpenSCAD Model</title>\n<path fill-rule=\"evenodd\" fill=\"{}\" stroke=\"{}\" "
        "stroke-width=\"{}\" d=\"",
        size.x, size.y, box.lo.x + 0.0, 0.0 - box.hi.y, size.x, size.y, paint.fill ? css(paint.fill_color) : "none",
        paint.stroke ? css(paint.stroke_color) : "none", paint.stroke_width);
    for (const Loop& loop : outline.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            put(out, "\n{} {} {}", i == 0 ? 'M' : 'L', loop[i].x + 0.0, 0.0 - loop[i].y);
        }
        put(out, " z");
    }
    put(out, "\"/>\n</svg>\n");
    return fmt::to_string(out);
}

std::string encode_dxf(const Outline& outline) {
    const Box box = bounds_of(outline.loops);
    Text out;
    put(out,
        "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n"
        "9\n$EXTMIN\n10\n{}\n20\n{}\n9\n$EXTMAX\n10\n{}\n20\n{}\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n",
        box.lo.x + 0.0, box.lo.y + 0.0, box.hi.x + 0.0, box.hi.y + 0.0);
    for (const Loop& loop : outline.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 from = loop[i] + 0.0, to = loop[(i + 1) % loop.size()] + 0.0;
            put(out, "0\nLINE\n8\n0\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", from.x, from.y, to.x, to.y);
        }
    }
    put(out, "0\nENDSEC\n0\nEOF\n");
    return fmt::to_string(out);
}

}  // namespace csg::solid
