#include "tests/edges/line_widths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "npr/painter/cpu_frame.h"
#include "npr/style.h"

namespace edges {
namespace {

constexpr double kAbout = 7;     ///< Pixels within which there must be no other line.
constexpr double kBeside = 0.2;  ///< Pixels by which points of a line may lie beside it.

/// The darkness of a picture's pixels.
class Darkness {
  public:
    Darkness(const layers::HostStack& stack, const base::View& view, const Drawing& drawing)
        : size_(view.size()), drawing_(drawing), light_(painted(stack, view, drawing)) {}

    /// Between pixels' centers, linearly.
    [[nodiscard]] double at(const glm::dvec2& p) const {
        const glm::dvec2 low = glm::floor(p - 0.5), part = p - 0.5 - low;
        const auto dark = [&](int x, int y) {
            const glm::ivec2 pixel = glm::clamp(glm::ivec2(low) + glm::ivec2(x, y), glm::ivec2(0), size_ - 1);
            const double light = light_[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size_.x) +
                                        static_cast<std::size_t>(pixel.x)]
                                     .x;
            const double bright = light > 0.0031308 ? 1.055 * std::pow(light, 1 / 2.4) - 0.055 : 12.92 * light;
            return (drawing_.ground - bright) / (drawing_.ground - drawing_.ink);
        };
        return glm::mix(glm::mix(dark(0, 0), dark(1, 0), part.x), glm::mix(dark(0, 1), dark(1, 1), part.x), part.y);
    }

  private:
    glm::ivec2 size_;
    const Drawing& drawing_;
    std::vector<glm::vec4> light_;
};

double square(double x) {
    return x * x;
}

/// The direction of the straight line that points are on; {0, 0} where they are on none.
glm::dvec2 direction_of(const std::vector<glm::dvec2>& points, const glm::dvec2& at) {
    glm::dvec2 end = at;
    for (const glm::dvec2& p : points) {
        end = glm::distance(p, at) > glm::distance(end, at) ? p : end;
    }
    if (glm::distance(end, at) < kAbout - 1) {
        return {0, 0};
    }
    const glm::dvec2 along = glm::normalize(end - at);
    double lo = 0, hi = 0;
    for (const glm::dvec2& p : points) {
        if (std::abs(along.x * (p.y - at.y) - along.y * (p.x - at.x)) > kBeside + square(glm::distance(p, at)) / 60) {
            return {0, 0};
        }
        lo = std::min(lo, glm::dot(p - at, along));
        hi = std::max(hi, glm::dot(p - at, along));
    }
    return lo < 1 - kAbout && hi > kAbout - 1 ? along : glm::dvec2(0, 0);
}

}  // namespace

std::vector<glm::vec4> painted(const layers::HostStack& stack, const base::View& view, const Drawing& drawing,
                               double dots_per_inch) {
    npr::Picture picture = npr::default_picture();
    picture.draw_as(*npr::find_style(drawing.style));
    picture.size = view.size();
    picture.samples = 1;
    picture.dots_per_inch = dots_per_inch;
    picture.camera = view.camera();
    for (const auto& [name, value] : drawing.settings) {
        picture.parameters.read(name, value);
    }
    picture.scheme.background = picture.scheme.background_stop = glm::vec3(static_cast<float>(drawing.ground));
    std::vector<glm::vec4> light(static_cast<std::size_t>(picture.size.x) * static_cast<std::size_t>(picture.size.y),
                                 glm::vec4(0));
    picture.style->make_paint()({picture, view, stack, light});
    return light;
}

Drawing black_on_paper(double width) {
    return {"edges",
            {{"shade", "0"},
             {"edge-color", "#000000"},
             {"inner", "1"},
             {"inner-width", "1"},
             {"width", fmt::format("{}", width)}}};
}

std::vector<Width> line_widths(const layers::HostStack& stack, const base::View& view, const std::vector<Point>& truth,
                               const Drawing& drawing, bool hidden) {
    const Darkness darkness(stack, view, drawing);
    std::vector<Width> widths;
    std::vector<glm::dvec2> about;
    for (const Point& p : truth) {
        if (p.hidden != hidden || p.at.x < kAbout || p.at.y < kAbout || p.at.x > view.size().x - kAbout ||
            p.at.y > view.size().y - kAbout) {
            continue;
        }
        about.clear();
        for (const Point& q : truth) {
            if ((hidden || !q.hidden) && glm::distance(p.at, q.at) < kAbout) {
                about.push_back(q.at);
            }
        }
        const glm::dvec2 along = direction_of(about, p.at);
        if (along == glm::dvec2(0, 0)) {
            continue;
        }
        // Over one pixel along the line, which evens out where links are.
        double ink = 0;
        constexpr double kStep = 0.125;
        constexpr int kAlong = 8, kAcross = 40;
        for (int i = 0; i < kAlong; ++i) {
            for (int j = -kAcross; j <= kAcross; ++j) {
                ink +=
                    darkness.at(p.at + along * ((i + 0.5) * kStep - 0.5) + glm::dvec2(-along.y, along.x) * (j * kStep));
            }
        }
        widths.push_back({p.at, ink * kStep / kAlong, p.kind});
    }
    return widths;
}

}  // namespace edges
