#include "ui/pipeline/picture/view_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace ui {

namespace {

/// In pixels from the lower left corner, with the depth of base::View.
using ScreenPoint = glm::dvec3;

/// Draws with the depth of the picture.
class DepthCanvas {
  public:
    DepthCanvas(base::Image& image, const base::View& view, const layers::HostStack& first)
        : image_(image), clip_(view.clip_from_world()), first_(first) {}

    /// `share`: of what is drawn; the rest is what was there.
    void set_color(const glm::vec3& color, double share = 1) {
        share_ = share;
        for (int i = 0; i < 3; ++i) {
            rgb_[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(color[i] * 255));
        }
    }

    enum class Line : std::uint8_t { Solid, Dashed, OnSurface };

    /// World coordinates. What lies behind the eye is not seen.
    void line(const glm::dvec3& from, const glm::dvec3& to, Line kind = Line::Solid) {
        constexpr double kLeast = 1e-9;
        glm::dvec4 a = clip_ * glm::dvec4(from, 1), b = clip_ * glm::dvec4(to, 1);
        if (a.w < kLeast && b.w < kLeast) {
            return;
        }
        if (a.w < kLeast) {
            a += (b - a) * ((kLeast - a.w) / (b.w - a.w));
        } else if (b.w < kLeast) {
            b += (a - b) * ((kLeast - b.w) / (a.w - b.w));
        }
        line_on_screen(on_screen(a), on_screen(b), kind);
    }

    [[nodiscard]] ScreenPoint place(const glm::dvec3& point) const { return on_screen(clip_ * glm::dvec4(point, 1)); }
    [[nodiscard]] bool before_eye(const glm::dvec3& point) const { return (clip_ * glm::dvec4(point, 1)).w > 0; }

    /// The depth of base::View is an affine function of the pixel along a line.
    void line_on_screen(const ScreenPoint& a, const ScreenPoint& b, Line kind = Line::Solid) {
        const int major = std::abs(b.x - a.x) >= std::abs(b.y - a.y) ? 0 : 1;
        const double way = b[major] - a[major];
        const double size = major == 0 ? image_.width : image_.height;
        const double least = std::max(std::ceil(std::min(a[major], b[major]) - 0.5), 0.0);
        const double most = std::min(std::floor(std::max(a[major], b[major]) - 0.5), size - 1);
        for (double at = least; at <= most; ++at) {
            const double part = way == 0 ? 0 : (at + 0.5 - a[major]) / way;
            const ScreenPoint p = a + part * (b - a);
            constexpr double kDash = 3;  // Pixels on, and off.
            if (kind == Line::OnSurface) {
                lighten(p);
            } else if (kind == Line::Solid || std::fmod(std::floor(std::abs(at + 0.5 - a[major]) / kDash), 2) == 0) {
                set(p);
            }
        }
    }

  private:
    [[nodiscard]] ScreenPoint on_screen(const glm::dvec4& p) const {
        return {(p.x / p.w + 1) / 2 * image_.width, (p.y / p.w + 1) / 2 * image_.height, p.z / p.w};
    }

    void set(const ScreenPoint& p) {
        const double x = std::floor(p.x), y = std::floor(p.y);
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) {
            return;
        }
        const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
        const auto width = static_cast<std::size_t>(image_.width);
        constexpr double kShare = 1e-5;  // What lies in a face is seen.
        if (!first_.planes.empty() &&
            p.z < static_cast<double>(first_.planes[0].depth[row * width + column]) * (1 - kShare)) {
            return;
        }
        const std::size_t pixel = (static_cast<std::size_t>(image_.height) - 1 - row) * width + column;
        std::transform(rgb_.begin(), rgb_.end(), image_.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixel),
                       image_.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixel),
                       [this](std::uint8_t mark, std::uint8_t ground) {
                           return static_cast<std::uint8_t>(std::lround(share_ * mark + (1 - share_) * ground));
                       });
        image_.rgba[4 * pixel + 3] = 255;
    }

    /// Where it lies in the surface that is seen, as far as the pixels about it tell.
    void lighten(const ScreenPoint& p) {
        const double x = std::floor(p.x), y = std::floor(p.y);
        if (x < 0 || y < 0 || x >= image_.width || y >= image_.height || first_.planes.empty()) {
            return;
        }
        const int column = static_cast<int>(x), row = static_cast<int>(y);
        const auto depth_at = [this](int i, int j) {
            return static_cast<double>(
                first_.planes[0].depth[static_cast<std::size_t>(j) * static_cast<std::size_t>(image_.width) +
                                       static_cast<std::size_t>(i)]);
        };
        if (depth_at(column, row) == 0) {
            return;
        }
        double least = std::numeric_limits<double>::infinity(), most = 0;
        for (int j = std::max(row - 1, 0); j <= std::min(row + 1, image_.height - 1); ++j) {
            for (int i = std::max(column - 1, 0); i <= std::min(column + 1, image_.width - 1); ++i) {
                if (const double depth = depth_at(i, j); depth > 0) {
                    least = std::min(least, depth);
                    most = std::max(most, depth);
                }
            }
        }
        constexpr double kShare = 1e-5;
        if (p.z < least * (1 - kShare) || p.z > most * (1 + kShare)) {
            return;
        }
        std::uint8_t* pixel =
            &image_
                 .rgba[4 * (static_cast<std::size_t>(image_.height - 1 - row) * static_cast<std::size_t>(image_.width) +
                            static_cast<std::size_t>(column))];
        std::transform(pixel, pixel + 3, pixel,
                       [](std::uint8_t c) { return static_cast<std::uint8_t>((c + 255) / 2); });
    }

    base::Image& image_;
    glm::dmat4 clip_;
    const layers::HostStack& first_;
    std::array<std::uint8_t, 3> rgb_{};
    double share_ = 1;
};

/// The seven strokes of a digit as letters: a is the top, then clockwise, g in the middle; '.' and '-' as they are.
std::string_view strokes_of(char c) {
    constexpr std::array<std::string_view, 10> kDigits{"abcdef", "bc",     "abged", "abgcd",   "fgbc",
                                                       "afgcd",  "afgedc", "abc",   "abcdefg", "abcdfg"};
    return c == '-' ? "g" : c == '.' ? "." : kDigits[static_cast<std::size_t>(c - '0')];
}

void put_number(DepthCanvas& canvas, ScreenPoint at, const std::string& number) {
    constexpr double kWide = 4, kHigh = 8, kNext = 7;
    for (const char c : number) {
        for (const char stroke : strokes_of(c)) {
            const auto piece = [&](double x0, double y0, double x1, double y1) {
                canvas.line_on_screen(at + ScreenPoint(x0, y0, 0), at + ScreenPoint(x1, y1, 0));
            };
            switch (stroke) {
                case 'a':
                    piece(0, kHigh, kWide + 1, kHigh);
                    break;
                case 'b':
                    piece(kWide, kHigh / 2, kWide, kHigh);
                    break;
                case 'c':
                    piece(kWide, 0, kWide, kHigh / 2);
                    break;
                case 'd':
                    piece(0, 0, kWide + 1, 0);
                    break;
                case 'e':
                    piece(0, 0, 0, kHigh / 2);
                    break;
                case 'f':
                    piece(0, kHigh / 2, 0, kHigh);
                    break;
                case 'g':
                    piece(0, kHigh / 2, kWide + 1, kHigh / 2);
                    break;
                default:
                    piece(kWide / 2, 0, kWide / 2 + 1, 0);
            }
        }
        at.x += kNext;
    }
}

/// Between faces of different planes.
void draw_edges(DepthCanvas& canvas, const csg::solid::PlacedLeaf& leaf) {
    using Corners = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Corners, csg::solid::PlaneRef> half;  // Edges of which one side is known.
    for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
        const glm::uvec3& triangle = leaf.triangles[t];
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
            const auto [known, added] = half.try_emplace(std::minmax(from, to), leaf.planes[t]);
            if (!added) {
                if (known->second.index != leaf.planes[t].index) {
                    canvas.line(leaf.points[from], leaf.points[to], DepthCanvas::Line::OnSurface);
                }
                half.erase(known);
            }
        }
    }
}

/// Ten small steps are a large one, which has its number.
void draw_scale(DepthCanvas& canvas, int axis, double reach) {
    constexpr int kSmall = 10;
    const double exponent = std::floor(std::log10(reach));  // Of the large steps.
    const double step = std::pow(10.0, exponent - 1);
    const int decimals = std::clamp(static_cast<int>(-exponent), 0, 15);
    const int across = axis == 2 ? 0 : 1 - axis;  // x beside y, y and z beside x.
    const auto most = static_cast<int>(std::floor(reach / step));
    for (int i = -most; i <= most; ++i) {
        if (i == 0) {
            continue;
        }
        glm::dvec3 on(0.0), beside(0.0);
        on[axis] = i * step;
        beside = on;
        const bool large = i % kSmall == 0;
        beside[across] = reach / (large ? 40 : 80);
        canvas.line(on, beside);
        if (large && canvas.before_eye(beside)) {
            constexpr double kBeside = 3;  // Pixels.
            put_number(canvas, canvas.place(beside) + ScreenPoint(kBeside, 0, 0),
                       fmt::format("{:.{}f}", i * step, decimals));
        }
    }
}

/// Of z = 0, as far as the axes go; each tenth line is a large step's.
void draw_grid(DepthCanvas& canvas, const glm::vec3& color, double reach) {
    constexpr int kSmall = 10;
    const double step = std::pow(10.0, std::floor(std::log10(reach)) - 1);
    const int most = std::min(static_cast<int>(std::floor(reach / step)), 5 * kSmall);
    const double end = most * step;
    for (int i = -most; i <= most; ++i) {
        canvas.set_color(color, i % kSmall == 0 ? 0.35 : 0.15);
        canvas.line({i * step, -end, 0}, {i * step, end, 0});
        canvas.line({-end, i * step, 0}, {end, i * step, 0});
    }
}

}  // namespace

void draw_view_marks(base::Image& image, const ViewMarks& marks, const MarkColors& colors, const base::View& view,
                     const csg::solid::Geometry& geometry, const layers::HostStack& first) {
    DepthCanvas canvas(image, view, first);
    const base::Camera& camera = view.camera();
    if (marks.edges) {
        for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
            draw_edges(canvas, leaf);
        }
    }
    if (marks.grid) {
        draw_grid(canvas, colors.axes, camera.distance);
    }
    if (marks.axes) {
        canvas.set_color(colors.axes);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 end(0.0);
            end[axis] = camera.distance;
            canvas.line(glm::dvec3(0.0), end);
            canvas.line(glm::dvec3(0.0), -end, DepthCanvas::Line::Dashed);
            if (marks.scales) {
                draw_scale(canvas, axis, camera.distance);
            }
        }
    }
    if (marks.crosshairs) {
        canvas.set_color(colors.crosshairs);
        const double reach = camera.distance / 8;  // The four diagonals of a cube about where the eye looks.
        for (int corner = 0; corner < 4; ++corner) {
            const glm::dvec3 half((corner & 1) != 0 ? reach : -reach, (corner & 2) != 0 ? reach : -reach, reach);
            canvas.line(camera.target - half, camera.target + half);
        }
    }
}

}  // namespace ui
