// SVG: shapes and paths with their transforms. As in OpenSCAD closed shapes count as filled, whatever fills them, and
// open lines are as wide as their strokes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "csg/solid/import_outline.h"
#include "csg/solid/solid.h"
#include "csg/solid/stroke.h"
#include "csg/solid/svg_document.h"
#include "csg/solid/svg_path.h"
#include "csg/solid/svg_viewport.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostShapes = std::size_t{1} << 20;
constexpr int kDeepestUse = 512;  ///< Elements within each other, uses unfolded.
constexpr int kMostUses = 16;     ///< Within each other.

/// What an element has from those about it.
struct State {
    glm::dmat4 matrix{1.0};
    bool shown = true;  ///< Of the layer or id that is asked for.
    Stroke stroke;
    int depth = 0, uses = 0;
};

bool never_drawn(const std::string& name) {
    return name == "defs" || name == "clipPath" || name == "mask" || name == "symbol" || name == "pattern" ||
           name == "marker" || name == "linearGradient" || name == "radialGradient" || name == "filter" ||
           name == "style" || name == "metadata";
}

class Svg {
  public:
    Svg(const SvgDocument& document, const Import& import, Remarks& remarks)
        : document_(document), import_(import), remarks_(remarks) {}

    std::vector<std::shared_ptr<const Outline>> draw() {
        if (document_.empty()) {
            return {};
        }
        State state;
        state.shown = !is_filtered();
        const SvgElement& root = document_.element(0);
        if (root.name == "svg") {
            state.matrix = svg_page(root, import_.dpi);
        }
        draw(root, state, root.name == "svg");
        if (is_filtered() && !found_) {
            warn_once(fmt::format("nothing in the SVG file has the id or the layer that import() names"));
        }
        return std::move(shapes_);
    }

  private:
    [[nodiscard]] bool is_filtered() const { return !import_.id.empty() || !import_.layer.empty(); }
    [[nodiscard]] bool wanted(std::string_view id, std::string_view layer) const {
        return (import_.id.empty() || id == import_.id) && (import_.layer.empty() || layer == import_.layer);
    }
    void warn_once(std::string text) {
        if (told_.insert(text).second) {
            remarks_.warnings.push_back(std::move(text));
        }
    }
    void fail_once(std::string text) {
        if (told_.insert(text).second) {
            remarks_.failures.push_back(std::move(text));
        }
    }
    [[nodiscard]] double length(const SvgElement& e, std::string_view name) const {
        return svg_length(attribute(e.attributes, name), import_.dpi);
    }

    /// `used`: the element is drawn in its own right although such elements are not by themselves.
    void draw(const SvgElement& e, State state, bool used = false) {
        if ((never_drawn(e.name) && !used) || document_.property(e, "display") == "none") {
            return;
        }
        if (++state.depth > kDeepestUse || shapes_.size() >= kMostShapes || ++visited_ > kMostShapes) {
            fail_once("SVG file draws too much; the rest is left out");
            return;
        }
        state.matrix *= read_svg_transform(attribute(e.attributes, "transform"));
        if (is_filtered() && wanted(attribute(e.attributes, "id"), attribute(e.attributes, "label"))) {
            state.shown = found_ = true;
        }
        inherit(e, state);
        if (e.name == "svg" && !used) {
            state.matrix *= viewport(e, e);
        }
        if (e.name == "use") {
            use(e, state);
        } else if (e.name == "text") {
            warn_once("text in an SVG file is not drawn; make it a path");
            return;
        } else if (state.shown) {
            shape(e, state);
        }
        for (const std::size_t child : e.children) {
            draw(document_.element(child), state);
        }
    }

    void inherit(const SvgElement& e, State& state) const {
        Stroke& stroke = state.stroke;
        if (const auto width = document_.property(e, "stroke-width"); !width.empty()) {
            constexpr double kThinnest = 0.01;  // OpenSCAD's: thinner lines are 1 wide.
            stroke.width = svg_length(width, import_.dpi);
            if (!(stroke.width >= kThinnest)) {
                stroke.width = 1;
            }
        }
        if (const auto cap = document_.property(e, "stroke-linecap"); !cap.empty()) {
            stroke.cap = cap == "square"  ? Stroke::Cap::Square
                         : cap == "round" ? Stroke::Cap::Round
                                          : Stroke::Cap::Butt;
        }
        if (const auto join = document_.property(e, "stroke-linejoin"); !join.empty()) {
            stroke.join = join == "round"   ? Stroke::Join::Round
                          : join == "bevel" ? Stroke::Join::Bevel
                                            : Stroke::Join::Miter;
        }
        if (const auto limit = document_.property(e, "stroke-miterlimit"); !limit.empty()) {
            stroke.miter_limit = svg_length(limit, import_.dpi);
        }
    }

    /// Of an svg or a symbol within the page; `sized` has the width and the height, if any has.
    [[nodiscard]] glm::dmat4 viewport(const SvgElement& e, const SvgElement& sized) const {
        glm::dmat4 m(1.0);
        const glm::dvec2 view = svg_view_size(e);
        if (e.name == "svg") {
            m[3] = {length(e, "x"), length(e, "y"), 0, 1};
        }
        const auto side = [&](std::string_view name, double whole) {
            const std::string_view text = attribute(sized.attributes, name);
            return text.empty() ? whole : svg_length(text, import_.dpi, whole);
        };
        return m * svg_fit(e, {side("width", view.x), side("height", view.y)});
    }

    void use(const SvgElement& e, State state) {
        const std::string_view link = attribute(e.attributes, "href");
        const SvgElement* meant = link.starts_with('#') ? document_.find(link.substr(1)) : nullptr;
        if (meant == nullptr) {
            warn_once(fmt::format("SVG use of '{:.40}', which is not in the file", link));
            return;
        }
        if (++state.uses > kMostUses) {
            warn_once(fmt::format("SVG element '{:.40}' uses itself", link.substr(1)));
            return;
        }
        glm::dmat4 moved(1.0);
        moved[3] = {length(e, "x"), length(e, "y"), 0, 1};
        state.matrix *= moved;
        const bool box = meant->name == "symbol" || meant->name == "svg";
        if (box) {
            state.matrix *= viewport(*meant, attribute(e.attributes, "width").empty() ? *meant : e);
        }
        draw(*meant, state, box);
    }

    void shape(const SvgElement& e, const State& state) {
        // As in OpenSCAD: by the radius before it is transformed, and not below the 40 of former days.
        constexpr int kLeastAround = 40;
        const auto around = [&](double radius) {
            return std::max(kLeastAround, circle_segments(radius, import_.fineness));
        };
        std::vector<SvgSubpath> lines;
        const auto ellipse = [&](double rx, double ry) {
            if (rx > 0 && ry > 0) {
                add_arc(lines.emplace_back(SvgSubpath{{}, true}).points, {length(e, "cx"), length(e, "cy")}, {rx, 0},
                        {0, ry}, 0, 360, around(std::max(rx, ry)));
            }
        };
        if (e.name == "path") {
            lines = read_svg_path(attribute(e.attributes, "d"), around(10));
        } else if (e.name == "rect") {
            rectangle(e, lines, around(std::max(length(e, "rx"), length(e, "ry"))));
        } else if (e.name == "circle") {
            ellipse(length(e, "r"), length(e, "r"));
        } else if (e.name == "ellipse") {
            ellipse(length(e, "rx"), length(e, "ry"));
        } else if (e.name == "line") {
            lines.push_back({{{length(e, "x1"), length(e, "y1")}, {length(e, "x2"), length(e, "y2")}}, false});
        } else if (e.name == "polygon" || e.name == "polyline") {
            const std::vector<double> n = read_svg_numbers(attribute(e.attributes, "points"));
            SvgSubpath& line = lines.emplace_back();
            for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
                line.points.emplace_back(n[i], n[i + 1]);
            }
            line.closed = e.name == "polygon" || is_closed(line.points);
        }
        constexpr int kAroundStrokes = 256;
        fill_and_stroke(lines, state, kAroundStrokes);
    }

    void fill_and_stroke(const std::vector<SvgSubpath>& lines, const State& state, int around) {
        std::vector<Loop> loops;
        for (const SvgSubpath& line : lines) {
            if (line.closed) {
                loops.push_back(line.points);
            } else {
                add(stroke(line.points, state.stroke, around), state.matrix);
            }
        }
        if (!loops.empty()) {
            add(clean(loops, FillRule::EvenOdd), state.matrix);  // Whatever fill-rule says, as in OpenSCAD.
        }
    }

    void add(const Outline& outline, const glm::dmat4& matrix) {
        if (!outline.empty()) {
            shapes_.push_back(std::make_shared<Outline>(transform(outline, matrix)));
        }
    }

    void rectangle(const SvgElement& e, std::vector<SvgSubpath>& lines, int around) const {
        const double x = length(e, "x"), y = length(e, "y"), w = length(e, "width"), h = length(e, "height");
        if (!(w > 0) || !(h > 0)) {
            return;
        }
        double rx = length(e, "rx"), ry = length(e, "ry");
        rx = std::min(attribute(e.attributes, "rx").empty() ? ry : rx, w / 2);
        ry = std::min(attribute(e.attributes, "ry").empty() ? rx : ry, h / 2);
        Loop& loop = lines.emplace_back(SvgSubpath{{}, true}).points;
        if (!(rx > 0) || !(ry > 0)) {
            loop = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
            return;
        }
        const glm::dvec2 centers[4]{
            {x + w - rx, y + ry}, {x + w - rx, y + h - ry}, {x + rx, y + h - ry}, {x + rx, y + ry}};
        for (int i = 0; i < 4; ++i) {
            const glm::dvec2 starts[4]{{0, -ry}, {rx, 0}, {0, ry}, {-rx, 0}};
            loop.push_back(centers[i] + starts[i]);
            add_arc(loop, centers[i], {rx, 0}, {0, ry}, 90.0 * i - 90, 90.0 * i, around);
        }
    }

    const SvgDocument& document_;
    const Import& import_;
    Remarks& remarks_;
    std::vector<std::shared_ptr<const Outline>> shapes_;
    std::set<std::string> told_;
    std::size_t visited_ = 0;
    bool found_ = false;  ///< Something of the id and layer that are asked for.
};

}  // namespace

Outline read_svg(std::string_view text, const Import& import, Remarks& remarks) {
    const SvgDocument document(text, remarks.failures);
    return combine(BooleanKind::Union, Svg(document, import, remarks).draw());
}

}  // namespace csg::solid
