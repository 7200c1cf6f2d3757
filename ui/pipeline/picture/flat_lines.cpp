#include "ui/pipeline/picture/flat_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace ui {

namespace {

constexpr double kWidth = 2;  // Pixels.

using Segment = std::array<glm::dvec4, 2>;

/// What lies in front of the eye.
std::optional<Segment> in_front(Segment s) {
    constexpr double kLeast = 1e-9;
    if (s[0].w < kLeast && s[1].w < kLeast) {
        return std::nullopt;
    }
    for (std::size_t end = 0; end < 2; ++end) {
        const glm::dvec4 &a = s[end], &b = s[1 - end];
        if (a.w < kLeast) {
            s[end] = a + (b - a) * ((kLeast - a.w) / (b.w - a.w));
        }
    }
    return s;
}

class LinePainter {
  public:
    LinePainter(base::Image& image, const glm::vec3& color) : image_(image) {
        for (int i = 0; i < 3; ++i) {
            rgb_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(color[i] * 255));
        }
    }

    /// In pixels from the upper left corner. A pixel belongs to the line that leaves the diamond about its center.
    void line(const glm::dvec2& a, const glm::dvec2& b) {
        const int major = std::abs(b.x - a.x) >= std::abs(b.y - a.y) ? 0 : 1, minor = 1 - major;
        const double way = b[major] - a[major];
        if (way == 0) {
            return;
        }
        const bool forwards = way > 0;
        // Columns, of lines that are steep rows, from the first to the last.
        const double first = column(a, major, forwards, true), last = column(b, major, forwards, false);
        const double least = std::max(std::min(first, last), 0.0);
        const double most = std::min(std::max(first, last), (major == 0 ? image_.width : image_.height) - 1.0);
        for (double at = least; at <= most && (forwards ? first <= last : first >= last); ++at) {
            const double across = a[minor] + (at + 0.5 - a[major]) * (b[minor] - a[minor]) / way;
            const double from = std::ceil(across - kWidth / 2 - 0.5);
            for (double step = 0; step < kWidth; ++step) {
                major == 0 ? set(at, from + step) : set(from + step, at);
            }
        }
    }

  private:
    static bool in_diamond(const glm::dvec2& p) {
        const glm::dvec2 off = p - glm::floor(p) - 0.5;
        return std::abs(off.x) + std::abs(off.y) < 0.5;
    }

    /// Where a line that goes on `forwards` begins (`start`) or ends at `p`.
    static double column(const glm::dvec2& p, int major, bool forwards, bool start) {
        const double whole = std::floor(p[major]), part = p[major] - whole;
        const bool past_center = forwards ? part > 0.5 : part < 0.5;
        const bool drawn = start ? !past_center || in_diamond(p) : past_center && !in_diamond(p);
        return drawn ? whole : whole + (forwards == start ? 1 : -1);
    }

    void set(double x, double y) {
        if (x >= 0 && y >= 0 && x < image_.width && y < image_.height) {
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
            std::copy(rgb_.begin(), rgb_.end(), image_.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixel));
            image_.rgba[4 * pixel + 3] = 255;
        }
    }

    base::Image& image_;
    std::array<std::uint8_t, 3> rgb_{};
};

}  // namespace

void draw_flat_lines(base::Image& image, const csg::solid::Outline& outline, const base::Camera& camera,
                     const glm::vec3& color) {
    const csg::Box box = csg::solid::bounds_of(outline.loops);
    const glm::dmat4 clip = base::View(camera, {image.width, image.height}, box.lo, box.hi).clip_from_world();
    const auto place = [&](const glm::dvec4& p) {
        return glm::dvec2((p.x / p.w + 1) / 2 * image.width, (1 - p.y / p.w) / 2 * image.height);
    };
    LinePainter canvas(image, color);
    for (const csg::solid::Loop& loop : outline.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Segment segment{clip * glm::dvec4(loop[i], 0, 1),
                                  clip * glm::dvec4(loop[(i + 1) % loop.size()], 0, 1)};
            if (const auto seen = in_front(segment)) {
                canvas.line(place((*seen)[0]), place((*seen)[1]));
            }
        }
    }
}

}  // namespace ui
