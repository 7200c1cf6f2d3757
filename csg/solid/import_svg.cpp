// SVG: basic shapes and paths with their transforms; every shape counts as filled, as in OpenSCAD.
#include <algorithm>
#include <cmath>

#include "csg/solid/file_text.h"
#include "csg/solid/files.h"
#include "csg/solid/import_outline.h"
#include "csg/solid/solid.h"
#include "csg/solid/svg_path.h"
#include "csg/solid/xml.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;
constexpr std::size_t kMostLoops = std::size_t{1} << 20;

/// Millimetres in one of the units; 0 for a percentage, the pixel's size for none.
double unit(std::string_view name, double pixel) {
    if (name == "mm")
        return 1;
    if (name == "cm")
        return 10;
    if (name == "in")
        return 25.4;
    if (name == "pt")
        return 25.4 / 72;
    if (name == "pc")
        return 25.4 / 6;
    return name == "%" ? 0 : pixel;
}

struct Length {
    double number = 0;
    std::string_view unit;
};

Length length(std::string_view text) {
    const std::size_t end = text.find_first_not_of("0123456789.+-eE");
    std::string_view digits = text.substr(0, end), name = end == std::string_view::npos ? "" : text.substr(end);
    // The e of "em" belongs to no number.
    while (!digits.empty() && (digits.back() == 'e' || digits.back() == 'E'))
        digits.remove_suffix(1);
    return {to_number(digits).value_or(0), name};
}

class Svg {
  public:
    explicit Svg(const Import& import) : import_(import) { stack_.push_back({glm::dmat4(1.0), wanted("", "")}); }

    void open(const std::string& name, const Attributes& a) {
        State state = stack_.back();
        state.matrix *= read_svg_transform(attribute(a, "transform"));
        state.shown = state.shown || (is_filtered() && wanted(attribute(a, "id"), attribute(a, "label")));
        state.hidden = state.hidden || name == "defs" || name == "clipPath" || name == "mask" || name == "symbol" ||
                       name == "pattern" || name == "marker" || attribute(a, "display") == "none";
        if (name == "svg" && stack_.size() == 1)
            page(a, state);
        stack_.push_back(state);
        if (!state.hidden && state.shown && shapes_.size() < kMostLoops)
            draw(name, a, state.matrix);
    }
    void close() {
        if (stack_.size() > 1)
            stack_.pop_back();
    }
    std::vector<std::shared_ptr<const Outline>> take() { return std::move(shapes_); }

  private:
    struct State {
        glm::dmat4 matrix;
        bool shown;  ///< Of the layer or id that is asked for.
        bool hidden = false;
    };

    [[nodiscard]] bool is_filtered() const { return !import_.id.empty() || !import_.layer.empty(); }
    [[nodiscard]] bool wanted(std::string_view id, std::string_view layer) const {
        return (import_.id.empty() || id == import_.id) && (import_.layer.empty() || layer == import_.layer);
    }

    /// To millimetres, y up from the page's lower edge.
    void page(const Attributes& a, State& state) const {
        const double pixel = 25.4 / import_.dpi;
        const Length w = length(attribute(a, "width")), h = length(attribute(a, "height"));
        std::vector<double> box = read_svg_numbers(attribute(a, "viewBox"));
        if (box.size() != 4 || !(box[2] > 0) || !(box[3] > 0))
            box.clear();
        const double wide = w.number * unit(w.unit, pixel), high = h.number * unit(h.unit, pixel);
        glm::dvec2 scale(pixel);
        double height = high;
        if (!box.empty()) {
            scale = {wide > 0 ? wide / box[2] : pixel, high > 0 ? high / box[3] : pixel};
            const double both = std::min(scale.x, scale.y);
            scale = glm::dvec2(both);
            height = high > 0 ? high : box[3] * both;
        }
        glm::dmat4 m(1.0);
        m[0][0] = scale.x;
        m[1][1] = -scale.y;
        m[3] = {box.empty() ? 0 : -box[0] * scale.x, height + (box.empty() ? 0 : box[1] * scale.y), 0, 1};
        state.matrix = m * state.matrix;
    }

    void draw(const std::string& name, const Attributes& a, const glm::dmat4& matrix) {
        const auto number = [&](std::string_view key) { return length(attribute(a, key)).number; };
        std::vector<Loop> loops;
        const double size = std::sqrt(std::abs(matrix[0][0] * matrix[1][1] - matrix[1][0] * matrix[0][1]));
        const auto around = [&](double radius) { return circle_segments(radius * size, import_.fineness); };
        const auto ellipse = [&](double rx, double ry) {
            if (rx > 0 && ry > 0)
                add_arc(loops.emplace_back(), {number("cx"), number("cy")}, {rx, 0}, {0, ry}, 0, 360,
                        around(std::max(rx, ry)));
        };
        if (name == "path") {
            loops = read_svg_path(attribute(a, "d"), around(10 / std::max(size, 1e-9)));
        } else if (name == "rect") {
            rectangle(a, loops, around(std::max(number("rx"), number("ry"))));
        } else if (name == "circle") {
            ellipse(number("r"), number("r"));
        } else if (name == "ellipse") {
            ellipse(number("rx"), number("ry"));
        } else if (name == "polygon" || name == "polyline") {
            const std::vector<double> n = read_svg_numbers(attribute(a, "points"));
            Loop& loop = loops.emplace_back();
            for (std::size_t i = 0; i + 1 < n.size(); i += 2)
                loop.emplace_back(n[i], n[i + 1]);
        }
        if (loops.empty())
            return;
        const bool even_odd = attribute(a, "fill-rule") == "evenodd" ||
                              attribute(a, "style").find("fill-rule:evenodd") != std::string_view::npos;
        shapes_.push_back(std::make_shared<Outline>(
            transform(clean(loops, even_odd ? FillRule::EvenOdd : FillRule::NonZero), matrix)));
    }

    static void rectangle(const Attributes& a, std::vector<Loop>& loops, int around) {
        const auto number = [&](std::string_view key) { return length(attribute(a, key)).number; };
        const double x = number("x"), y = number("y"), w = number("width"), h = number("height");
        if (!(w > 0) || !(h > 0))
            return;
        double rx = number("rx"), ry = number("ry");
        rx = std::min(attribute(a, "rx").empty() ? ry : rx, w / 2);
        ry = std::min(attribute(a, "ry").empty() ? rx : ry, h / 2);
        Loop& loop = loops.emplace_back();
        if (!(rx > 0) || !(ry > 0)) {
            loop = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
            return;
        }
        const glm::dvec2 centres[4]{
            {x + w - rx, y + ry}, {x + w - rx, y + h - ry}, {x + rx, y + h - ry}, {x + rx, y + ry}};
        for (int i = 0; i < 4; ++i) {
            const glm::dvec2 starts[4]{{0, -ry}, {rx, 0}, {0, ry}, {-rx, 0}};
            loop.push_back(centres[i] + starts[i]);
            add_arc(loop, centres[i], {rx, 0}, {0, ry}, 90.0 * i - 90, 90.0 * i, around);
        }
    }

    const Import& import_;
    std::vector<State> stack_;
    std::vector<std::shared_ptr<const Outline>> shapes_;
};

void centre(Outline& outline) {
    const glm::dvec2 middle(bounds_of(outline.loops).centre());
    for (Loop& loop : outline.loops) {
        for (glm::dvec2& p : loop)
            p -= middle;
    }
}

}  // namespace

Outline read_svg(std::string_view text, const Import& import, std::vector<std::string>& warnings) {
    Svg svg(import);
    XmlEvents events;
    events.open = [&](const std::string& name, const Attributes& attributes) { svg.open(name, attributes); };
    events.close = [&](const std::string&, const std::string&) { svg.close(); };
    read_xml(text, events, warnings);
    return combine(BooleanKind::Union, svg.take());
}

Outline import_outline(const Import& import, std::vector<std::string>& warnings) {
    const auto text = read_file(import.file.path, kMostBytes, warnings);
    if (!text)
        return {};
    Outline outline = file_suffix(import.file.path) == "svg"
                          ? read_svg(*text, import, warnings)
                          : clean(read_dxf(*text, import, warnings), FillRule::EvenOdd);
    if (import.center)
        centre(outline);
    return outline;
}

}  // namespace csg::solid
