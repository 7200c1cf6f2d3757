// DXF: pairs of a group code and a value, a line each.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "csg/solid/file_text.h"
#include "csg/solid/import_outline.h"
#include "csg/solid/solid.h"
#include "csg/tree/degrees.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostLines = std::size_t{1} << 21;
constexpr int kDeepest = 16;

using Line = Loop;  ///< Open, of at least two points; or closed, with the first point again at its end.

struct Entity {
    std::string kind, layer;
    std::map<int, double> numbers;               ///< The last of each code.
    std::vector<std::pair<int, double>> series;  ///< 10, 20 and 42 in their order.
    std::string block;                           ///< INSERT: the name.

    [[nodiscard]] double number(int code, double otherwise = 0) const {
        const auto found = numbers.find(code);
        return found == numbers.end() ? otherwise : found->second;
    }
    [[nodiscard]] glm::dvec2 point(int code) const { return {number(code), number(code + 10)}; }
};

std::string_view trimmed(std::string_view line) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
        line.remove_suffix(1);
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t'))
        line.remove_prefix(1);
    return line;
}

struct File {
    std::vector<Entity> entities;
    std::map<std::string, std::vector<Entity>> blocks;
};

File read(std::string_view text) {
    File file;
    Words words(text);
    std::string section, block;
    bool in_block = false;
    Entity entity;
    const auto finish_entity = [&] {
        if (entity.kind == "BLOCK")
            block = entity.block;
        else if (!entity.kind.empty() && section == "ENTITIES")
            file.entities.push_back(std::move(entity));
        else if (!entity.kind.empty() && section == "BLOCKS" && in_block)
            file.blocks[block].push_back(std::move(entity));
        entity = {};
    };
    while (!words.at_end()) {
        const auto code_word = to_number(trimmed(words.line()));
        const std::string_view value = trimmed(words.line());
        if (!code_word)
            continue;
        const int code = static_cast<int>(std::clamp(*code_word, -1.0, 2000.0));
        if (code == 0) {
            finish_entity();
            if (value == "BLOCK")
                in_block = true;
            else if (value == "ENDBLK")
                in_block = false;
            if (value == "ENDSEC")
                section.clear();
            else
                entity.kind = value;
        } else if (code == 2 && entity.kind == "SECTION") {
            section = value;
            entity.kind.clear();
        } else if (code == 2) {
            entity.block = value;
        } else if (code == 8) {
            entity.layer = value;
        } else if (const auto number = to_number(value)) {
            entity.numbers[code] = *number;
            if (code == 10 || code == 20 || code == 42)
                entity.series.emplace_back(code, *number);
        }
    }
    finish_entity();
    return file;
}

/// An arc between two points: `bulge` is the tangent of a quarter of its angle.
void add_bulge(Line& line, const glm::dvec2& from, const glm::dvec2& to, double bulge, const Fineness& fineness) {
    if (bulge == 0 || from == to) {
        line.push_back(to);
        return;
    }
    const glm::dvec2 chord = to - from;
    const glm::dvec2 left(-chord.y, chord.x);
    const glm::dvec2 centre = 0.5 * (from + to) + left * ((1 - bulge * bulge) / (4 * bulge));
    const double radius = glm::length(from - centre);
    const double begin = atan2_degrees(from.y - centre.y, from.x - centre.x);
    const double turn = 4 * atan_degrees(bulge);
    add_arc(line, centre, {radius, 0}, {0, radius}, begin, begin + turn, circle_segments(radius, fineness));
    line.back() = to;
}

/// Degrees from one angle to another, counter-clockwise, at most a turn.
double sweep(double from, double to) {
    const double degrees = std::fmod(to - from, 360.0);
    return degrees > 0 ? degrees : degrees + 360;
}

class Drawing {
  public:
    Drawing(const File& file, const Import& import, std::vector<std::string>& warnings)
        : file_(file), import_(import), warnings_(warnings) {}

    std::vector<Line> draw() {
        draw(file_.entities, glm::dmat4(1.0), 0);
        return std::move(lines_);
    }

  private:
    void draw(const std::vector<Entity>& entities, const glm::dmat4& placed, int depth) {
        Line polyline;
        bool closed = false;
        for (const Entity& e : entities) {
            if (lines_.size() > kMostLines)
                return;
            if (e.kind == "VERTEX") {
                polyline.push_back(e.point(10));
                continue;
            }
            if (e.kind == "SEQEND") {
                add(polyline, closed, placed);
                polyline.clear();
                continue;
            }
            if (!import_.layer.empty() && e.layer != import_.layer && depth == 0)
                continue;
            if (e.kind == "POLYLINE")
                closed = (static_cast<int>(e.number(70)) & 1) != 0;
            else if (e.kind == "INSERT")
                insert(e, placed, depth);
            else
                draw(e, placed);
        }
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
            const glm::dvec2 centre = e.point(10);
            line.push_back(centre + r * glm::dvec2(cos_degrees(from), sin_degrees(from)));
            add_arc(line, centre, {r, 0}, {0, r}, from, to, circle_segments(r, import_.fineness));
            add(line, whole, placed);
        } else if (e.kind == "ELLIPSE") {
            const glm::dvec2 axis = e.point(11), other = glm::dvec2(-axis.y, axis.x) * e.number(40, 1);
            constexpr double kDegrees = 180 / 3.14159265358979323846;
            const double from = e.number(41) * kDegrees;
            const double to = from + sweep(from, e.number(42, 360 / kDegrees) * kDegrees);
            line.push_back(e.point(10) + axis * cos_degrees(from) + other * sin_degrees(from));
            add_arc(line, e.point(10), axis, other, from, to, circle_segments(glm::length(axis), import_.fineness));
            add(line, std::abs(to - from - 360) < 1e-6, placed);
        } else if (e.kind == "LWPOLYLINE") {
            light_polyline(e, placed);
        } else if (e.kind != "DIMENSION" && e.kind != "VIEWPORT" && e.kind != "POINT" &&
                   unknown_.insert(e.kind).second) {
            warnings_.push_back(fmt::format("Unsupported DXF Entity '{}' in \"{}\"", e.kind, import_.file.shown));
        }
    }

    void light_polyline(const Entity& e, const glm::dmat4& placed) {
        struct Corner {
            glm::dvec2 at;
            double bulge;
        };
        std::vector<Corner> corners;
        for (const auto& [code, number] : e.series) {
            if (code == 10)
                corners.push_back({{number, 0}, 0});
            else if (!corners.empty())
                (code == 20 ? corners.back().at.y : corners.back().bulge) = number;
        }
        if (corners.empty())
            return;
        const bool closed = (static_cast<int>(e.number(70)) & 1) != 0;
        Line line{corners[0].at};
        for (std::size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i)
            add_bulge(line, corners[i].at, corners[(i + 1) % corners.size()].at, corners[i].bulge, import_.fineness);
        add(line, closed, placed);
    }

    void insert(const Entity& e, const glm::dmat4& placed, int depth) {
        const auto block = file_.blocks.find(e.block);
        if (block == file_.blocks.end() || depth >= kDeepest || ++inserted_ > 100'000)
            return;
        const double c = cos_degrees(e.number(50)), s = sin_degrees(e.number(50));
        const double x = e.number(41, 1), y = e.number(42, 1);
        glm::dmat4 m(1.0);
        m[0] = {c * x, s * x, 0, 0};
        m[1] = {-s * y, c * y, 0, 0};
        m[3] = {e.number(10), e.number(20), 0, 1};
        draw(block->second, placed * m, depth + 1);
    }

    void add(Line line, bool closed, const glm::dmat4& placed) {
        if (line.size() < 2)
            return;
        for (glm::dvec2& p : line)
            p = glm::dvec2(placed * glm::dvec4(p, 0.0, 1.0));
        if (closed && line.front() != line.back())
            line.push_back(line.front());
        lines_.push_back(std::move(line));
    }

    const File& file_;
    const Import& import_;
    std::vector<std::string>& warnings_;
    std::vector<Line> lines_;
    std::set<std::string> unknown_;
    std::size_t inserted_ = 0;
};

/// Ends closer than OpenSCAD's coarse grid are one.
constexpr double kNear = 0x1p-10;

bool is_near(const glm::dvec2& a, const glm::dvec2& b) {
    return std::abs(a.x - b.x) <= kNear && std::abs(a.y - b.y) <= kNear;
}

/// The ends of lines, by cells.
class Ends {
  public:
    void add(const glm::dvec2& p, std::size_t line) { cells_.emplace(cell(p), End{p, line}); }
    /// The first line that has an end near p and is not used.
    [[nodiscard]] std::optional<std::size_t> find(const glm::dvec2& p, const std::vector<char>& used) const {
        const auto [x, y] = cell(p);
        for (long long i = x - 1; i <= x + 1; ++i) {
            for (long long j = y - 1; j <= y + 1; ++j) {
                const auto [from, to] = cells_.equal_range({i, j});
                for (auto end = from; end != to; ++end) {
                    if (used[end->second.line] == 0 && is_near(end->second.at, p))
                        return end->second.line;
                }
            }
        }
        return std::nullopt;
    }

  private:
    struct End {
        glm::dvec2 at;
        std::size_t line;
    };
    static std::pair<long long, long long> cell(const glm::dvec2& p) {
        const auto whole = [](double x) {
            return static_cast<long long>(std::floor(std::clamp(x / kNear, -1e18, 1e18)));
        };
        return {whole(p.x), whole(p.y)};
    }
    std::multimap<std::pair<long long, long long>, End> cells_;
};

/// Closed lines as they are; others end to end, in either direction. Where no line goes on, the loop is closed
/// straight, as in OpenSCAD.
std::vector<Loop> join(std::vector<Line> lines) {
    std::vector<Loop> loops;
    Ends ends;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_near(lines[i].front(), lines[i].back()))
            continue;
        ends.add(lines[i].front(), i);
        ends.add(lines[i].back(), i);
    }
    std::vector<char> used(lines.size(), 0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (used[i] != 0)
            continue;
        used[i] = 1;
        Loop loop = std::move(lines[i]);
        bool reversed = false;
        while (!is_near(loop.front(), loop.back())) {
            const auto next = ends.find(loop.back(), used);
            if (!next) {
                if (reversed)
                    break;
                reversed = true;  // On from where it began.
                std::reverse(loop.begin(), loop.end());
                continue;
            }
            Line& line = lines[*next];
            used[*next] = 1;
            if (!is_near(line.front(), loop.back()))
                std::reverse(line.begin(), line.end());
            loop.insert(loop.end(), line.begin() + 1, line.end());
        }
        if (is_near(loop.front(), loop.back()))
            loop.pop_back();
        if (loop.size() > 2)
            loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace

void add_arc(Loop& loop, const glm::dvec2& centre, const glm::dvec2& first_axis, const glm::dvec2& second_axis,
             double from, double to, int around) {
    const int steps = std::max(1, static_cast<int>(std::ceil(around * std::abs(to - from) / 360 - 1e-9)));
    for (int i = 1; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        loop.push_back(centre + first_axis * cos_degrees(angle) + second_axis * sin_degrees(angle));
    }
}

std::vector<Loop> read_dxf(std::string_view text, const Import& import, std::vector<std::string>& warnings) {
    const File file = read(text);
    std::vector<Loop> loops = join(Drawing(file, import, warnings).draw());
    for (Loop& loop : loops) {
        for (glm::dvec2& p : loop)
            p = (p - import.origin) * import.scale;
    }
    return loops;
}

}  // namespace csg::solid
