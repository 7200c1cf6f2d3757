// Outlines from DXF files.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "csg/solid/dxf_file.h"
#include "csg/solid/import_outline.h"
#include "csg/solid/solid.h"
#include "csg/solid/spline.h"
#include "csg/tree/degrees.h"
#include "csg/tree/finite.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostLines = std::size_t{1} << 21;
constexpr std::size_t kMostInserted = 10'000;

using Line = Loop;
using Entity = DxfEntity;
using Block = DxfFile::Blocks::value_type;

/// Of a polyline: a point, and what the way from it to the next one is bent by.
struct PolylineCorner {
    glm::dvec2 at;
    double bulge;
};

/// An arc between two points: `bulge` is the tangent of a quarter of its angle.
void add_bulge(Line& line, const glm::dvec2& from, const glm::dvec2& to, double bulge, const Fineness& fineness) {
    if (bulge == 0 || from == to) {
        line.push_back(to);
        return;
    }
    const glm::dvec2 chord = to - from;
    const glm::dvec2 left(-chord.y, chord.x);
    const glm::dvec2 center = 0.5 * (from + to) + left * ((1 - bulge * bulge) / (4 * bulge));
    const double radius = glm::length(from - center);
    const double begin = atan2_degrees(from.y - center.y, from.x - center.x);
    const double turn = 4 * atan_degrees(bulge);
    add_arc(line, center, {radius, 0}, {0, radius}, begin, begin + turn, circle_segments(radius, fineness));
    line.back() = to;
}

/// Degrees from one angle to another, counter-clockwise, at most a turn.
double sweep(double from, double to) {
    const double degrees = std::fmod(to - from, 360.0);
    return degrees > 0 ? degrees : degrees + 360;
}

class Drawing {
  public:
    Drawing(const DxfFile& file, const Import& import, Remarks& remarks)
        : file_(file), import_(import), remarks_(remarks) {}

    std::vector<Line> draw() {
        draw(file_.entities, glm::dmat4(1.0));
        for (const auto& [kind, count] : unknown_) {
            remarks_.warnings.push_back(
                fmt::format("Unsupported DXF Entity '{:.40}' ({:x}) in {}", kind, count, place_name()));
        }
        return std::move(lines_);
    }

  private:
    void draw(const std::vector<Entity>& entities, const glm::dmat4& placed) {
        std::vector<PolylineCorner> polyline;
        bool closed = false, wanted = true;
        for (const Entity& e : entities) {
            if (lines_.size() > kMostLines) {
                return fail_once(fmt::format("DXF file draws more than {} lines; the rest is left out", kMostLines));
            }
            constexpr int kFrame = 16;  // Of a spline, which has its points beside it.
            if (e.kind == "VERTEX") {
                if ((e.flags() & kFrame) != 0) {
                    continue;
                }
                polyline.push_back({e.point(10), e.number(42)});
                continue;
            }
            if (e.kind == "SEQEND") {
                if (wanted) {
                    add_polyline(polyline, closed, placed);
                }
                polyline.clear();
                continue;
            }
            wanted = import_.layer.empty() || e.layer == import_.layer || !drawn_.empty();
            if (!wanted) {
                continue;
            }
            if (e.kind == "POLYLINE") {
                closed = (e.flags() & 1) != 0;
            } else if (e.kind == "INSERT") {
                insert(e, placed);
            } else {
                draw(e, placed);
            }
        }
    }

    /// For a whole turn. Outside of blocks it is the radius after import()'s scale that counts, as in OpenSCAD.
    [[nodiscard]] int segments(double radius) const {
        return circle_segments(drawn_.empty() ? radius * std::abs(import_.scale) : radius, import_.fineness);
    }

    void draw(const Entity& e, const glm::dmat4& placed) {
        Line line;
        if (e.kind == "LINE") {
            add({e.point(10), e.point(11)}, false, placed);
        } else if (e.kind == "CIRCLE" || e.kind == "ARC") {
            const double r = e.number(40);
            const bool whole = e.kind == "CIRCLE";
            const double from = whole ? 0 : e.number(50);
            const double to = whole ? 360 : from + sweep(from, e.number(51));
            const glm::dvec2 center = e.point(10);
            line.push_back(center + r * glm::dvec2(cos_degrees(from), sin_degrees(from)));
            add_arc(line, center, {r, 0}, {0, r}, from, to, segments(r));
            add(line, whole, placed);
        } else if (e.kind == "ELLIPSE") {
            const glm::dvec2 axis = e.point(11), other = glm::dvec2(-axis.y, axis.x) * e.number(40, 1);
            constexpr double kDegrees = 180 / 3.14159265358979323846;
            const double from = e.number(41) * kDegrees;
            const double to = from + sweep(from, e.number(42, 360 / kDegrees) * kDegrees);
            line.push_back(e.point(10) + axis * cos_degrees(from) + other * sin_degrees(from));
            add_arc(line, e.point(10), axis, other, from, to, segments(glm::length(axis)));
            add(line, std::abs(to - from - 360) < 1e-6, placed);
        } else if (e.kind == "LWPOLYLINE") {
            light_polyline(e, placed);
        } else if (e.kind == "SPLINE") {
            spline(e, placed);
        } else if (e.kind != "DIMENSION" && e.kind != "VIEWPORT" && e.kind != "POINT") {
            ++unknown_[e.kind];
        }
    }

    /// By its control points; one that has only points to go through goes through them straight.
    void spline(const Entity& e, const glm::dmat4& placed) {
        Spline curve;
        curve.degree = static_cast<int>(std::clamp(e.number(71, 3), -1.0, 99.0));
        Loop through;
        for (const auto& [code, number] : e.series) {
            if (code == 40) {
                curve.knots.push_back(number);
            } else if (code == 41) {
                curve.weights.push_back(number);
            } else if (code == 10) {
                curve.points.emplace_back(number, 0);
            } else if (code == 20 && !curve.points.empty()) {
                curve.points.back().y = number;
            } else if (code == 11) {
                through.emplace_back(number, 0);
            } else if (code == 21 && !through.empty()) {
                through.back().y = number;
            }
        }
        const bool closed = (e.flags() & 1) != 0;
        if (curve.points.empty() && through.size() > 1) {
            add(std::move(through), closed, placed);
            return;
        }
        const double radius = glm::length(glm::dvec2(bounds_of(std::span(&curve.points, 1)).size())) / 2;
        constexpr int kSpansOfATurn = 4;
        auto points = points_along(curve, std::max(2, (segments(radius) + kSpansOfATurn - 1) / kSpansOfATurn));
        if (points) {
            add(std::move(*points), closed, placed);
        } else {
            fail_once(fmt::format("DXF SPLINE in \"{}\" has knots, points or weights that do not fit together",
                                  import_.file.shown));
        }
    }

    void light_polyline(const Entity& e, const glm::dmat4& placed) {
        std::vector<PolylineCorner> corners;
        for (const auto& [code, number] : e.series) {
            if (code == 10) {
                corners.push_back({{number, 0}, 0});
            } else if (!corners.empty() && (code == 20 || code == 42)) {
                (code == 20 ? corners.back().at.y : corners.back().bulge) = number;
            }
        }
        add_polyline(corners, (e.flags() & 1) != 0, placed);
    }

    void add_polyline(const std::vector<PolylineCorner>& corners, bool closed, const glm::dmat4& placed) {
        if (corners.empty()) {
            return;
        }
        Line line{corners[0].at};
        for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
            add_bulge(line, corners[i].at, corners[(i + 1) % corners.size()].at, corners[i].bulge, import_.fineness);
        }
        add(line, closed, placed);
    }

    void insert(const Entity& e, const glm::dmat4& placed) {
        const auto block = file_.blocks.find(e.block);
        if (block == file_.blocks.end()) {
            return;
        }
        if (std::find(drawn_.begin(), drawn_.end(), &*block) != drawn_.end()) {
            fail_once(fmt::format("DXF block '{:.40}' inserts itself", e.block));
            return;
        }
        if (++inserted_ > kMostInserted) {
            fail_once(fmt::format("DXF file inserts more than {} blocks; the rest is left out", kMostInserted));
            return;
        }
        const double c = cos_degrees(e.number(50)), s = sin_degrees(e.number(50));
        const double x = e.number(41, 1), y = e.number(42, 1);
        glm::dmat4 m(1.0);
        m[0] = {c * x, s * x, 0, 0};
        m[1] = {-s * y, c * y, 0, 0};
        m[3] = {e.number(10), e.number(20), 0, 1};
        drawn_.push_back(&*block);
        // Columns and rows, apart along the block's turned axes.
        const auto count = [&](int code) { return static_cast<int>(std::clamp(e.number(code, 1), 1.0, 1000.0)); };
        for (int row = 0; row < count(71); ++row) {
            for (int column = 0; column < count(70) && inserted_ <= kMostInserted; ++column) {
                inserted_ += row + column > 0 ? 1 : 0;
                const double across = column * e.number(44), up = row * e.number(45);
                glm::dmat4 copy = m;
                copy[3] += glm::dvec4(c * across - s * up, s * across + c * up, 0, 0);
                draw(block->second, placed * copy);
            }
        }
        drawn_.pop_back();
    }

    /// What a warning names.
    [[nodiscard]] std::string place_name() const {
        return import_.layer.empty() ? fmt::format("\"{}\".", import_.file.shown)
                                     : fmt::format("layer '{}' of {}", import_.layer, import_.file.shown);
    }

    void fail_once(std::string failure) {
        if (told_.insert(failure).second) {
            remarks_.failures.push_back(std::move(failure));
        }
    }

    void add(Line line, bool closed, const glm::dmat4& placed) {
        if (line.size() < 2) {
            return;
        }
        for (glm::dvec2& p : line) {
            p = glm::dvec2(placed * glm::dvec4(p, 0.0, 1.0));
        }
        if (!std::all_of(line.begin(), line.end(), is_finite<2>)) {
            fail_once("DXF file has coordinates that are no finite numbers; what has them is left out");
            return;
        }
        if (closed && line.front() != line.back()) {
            line.push_back(line.front());
        }
        lines_.push_back(std::move(line));
    }

    const DxfFile& file_;
    const Import& import_;
    Remarks& remarks_;
    std::vector<Line> lines_;
    std::set<std::string> told_;
    std::map<std::string, std::size_t> unknown_;  ///< How many entities of a kind cannot be drawn.
    std::vector<const Block*> drawn_;             ///< The blocks that this is part of, the outermost first.
    std::size_t inserted_ = 0;
};

/// Where lines meet: ends closer than OpenSCAD's coarse grid to one that came before are at the joint of that one.
class Joints {
  public:
    std::uint32_t at(const glm::dvec2& p) {
        // Of the points of one cell no two are apart, so a cell has one joint at most.
        const Cell cell{whole(p.x), whole(p.y)};
        for (long long i = cell.first - 1; i <= cell.first + 1; ++i) {
            for (long long j = cell.second - 1; j <= cell.second + 1; ++j) {
                const auto known = cells_.find({i, j});
                if (known != cells_.end() && is_near(points_[known->second], p)) {
                    return known->second;
                }
            }
        }
        const auto joint = static_cast<std::uint32_t>(points_.size());
        cells_.emplace(cell, joint);
        points_.push_back(p);
        return joint;
    }
    [[nodiscard]] std::size_t size() const { return points_.size(); }

  private:
    using Cell = std::pair<long long, long long>;
    static constexpr double kNear = 0x1p-10;
    static long long whole(double x) { return static_cast<long long>(std::floor(std::clamp(x / kNear, -1e18, 1e18))); }
    static bool is_near(const glm::dvec2& a, const glm::dvec2& b) {
        return std::abs(a.x - b.x) <= kNear && std::abs(a.y - b.y) <= kNear;
    }
    std::map<Cell, std::uint32_t> cells_;
    std::vector<glm::dvec2> points_;
};

/// Joins lines end to end, in either direction, and closes each chain straight, as OpenSCAD does: first those with an
/// end that meets no other line, then the rest, in the order of the file. A chain goes on through its beginning as long
/// as there are lines.
class Joining {
  public:
    explicit Joining(std::vector<Line> lines) : lines_(std::move(lines)), used_(lines_.size(), 0) {
        Joints joints;
        for (const Line& line : lines_) {
            const std::uint32_t first = joints.at(line.front());
            ends_.push_back({first, joints.at(line.back())});
        }
        meeting_.resize(joints.size());
        open_.resize(joints.size(), 0);
        for (std::size_t i = lines_.size(); i-- > 0;) {
            if (ends_[i][0] == ends_[i][1]) {
                continue;
            }
            for (const std::uint32_t end : ends_[i]) {
                meeting_[end].push_back(i);
                ++open_[end];
            }
        }
    }

    std::vector<Loop> join() {
        constexpr int kMostRounds = 64;  // Each goes through all lines.
        bool again = true;
        for (int round = 0; again && round < kMostRounds; ++round) {
            again = false;
            for (std::size_t i = 0; i < lines_.size(); ++i) {
                if (used_[i] != 0 || ends_[i][0] == ends_[i][1]) {
                    continue;
                }
                if (open_[ends_[i][0]] == 1) {
                    follow(i);
                    again = true;
                } else if (open_[ends_[i][1]] == 1) {
                    reverse(i);
                    follow(i);
                    again = true;
                }
            }
        }
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (used_[i] == 0) {
                follow(i, true);
            }
        }
        return std::move(loops_);
    }

  private:
    void reverse(std::size_t i) {
        std::reverse(lines_[i].begin(), lines_[i].end());
        std::swap(ends_[i][0], ends_[i][1]);
    }

    void use(std::size_t i) {
        used_[i] = 1;
        if (ends_[i][0] != ends_[i][1]) {
            --open_[ends_[i][0]];
            --open_[ends_[i][1]];
        }
    }

    /// `closed`: the chain's last point is taken to be its first one, as OpenSCAD does, though it ends elsewhere where
    /// an odd number of lines meet.
    void follow(std::size_t i, bool closed = false) {
        use(i);
        Loop loop = std::move(lines_[i]);
        const std::uint32_t begin = ends_[i][0];
        std::uint32_t end = ends_[i][1];
        for (bool on = begin != end; on;) {
            std::vector<std::size_t>& next = meeting_[end];  // The first line last.
            while (!next.empty() && used_[next.back()] != 0) {
                next.pop_back();
            }
            on = !next.empty();
            if (on) {
                const std::size_t taken = next.back();
                if (ends_[taken][0] != end) {
                    reverse(taken);
                }
                use(taken);
                loop.insert(loop.end(), lines_[taken].begin() + 1, lines_[taken].end());
                end = ends_[taken][1];
            }
        }
        if (closed || begin == end) {
            loop.pop_back();
        }
        if (loop.size() > 2) {
            loops_.push_back(std::move(loop));
        }
    }

    std::vector<Line> lines_;
    std::vector<char> used_;
    std::vector<std::array<std::uint32_t, 2>> ends_;  ///< Joints at the beginning and at the end of each line.
    std::vector<std::vector<std::size_t>> meeting_;   ///< By joint: lines that are no loops by themselves.
    std::vector<std::size_t> open_;                   ///< By joint: how many of these are not used.
    std::vector<Loop> loops_;
};

}  // namespace

void add_arc(Loop& loop, const glm::dvec2& center, const glm::dvec2& first_axis, const glm::dvec2& second_axis,
             double from, double to, int around) {
    const int steps = std::max(1, static_cast<int>(std::ceil(around * std::abs(to - from) / 360 - 1e-9)));
    for (int i = 1; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        loop.push_back(center + first_axis * cos_degrees(angle) + second_axis * sin_degrees(angle));
    }
}

static void place(std::vector<Loop>& loops, const Import& import) {
    for (Loop& loop : loops) {
        for (glm::dvec2& p : loop) {
            p = (p - import.origin) * import.scale;
        }
    }
}

std::vector<Loop> draw_dxf(const DxfFile& file, const Import& import, Remarks& remarks) {
    std::vector<Loop> lines = Drawing(file, import, remarks).draw();
    place(lines, import);
    return lines;
}

std::vector<Loop> read_dxf(std::string_view text, const Import& import, Remarks& remarks) {
    const DxfFile file = read_dxf_file(text);
    std::vector<Loop> loops = Joining(Drawing(file, import, remarks).draw()).join();
    place(loops, import);
    return loops;
}

}  // namespace csg::solid
