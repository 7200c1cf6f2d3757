#include "csg/solid/svg_path.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "csg/solid/import_outline.h"
#include "csg/tree/degrees.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostPoints = std::size_t{1} << 22;

/// Numbers may follow each other without a separator where a sign or a second dot begins one.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    void skip() {
        while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == ',')) {
            ++at_;
        }
    }
    /// A letter that begins a command; 0 where a number or the end comes.
    char command() {
        skip();
        if (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
            return text_[at_++];
        }
        return 0;
    }
    [[nodiscard]] bool at_end() {
        skip();
        return at_ >= text_.size();
    }
    std::optional<double> number() {
        skip();
        std::size_t from = at_ + (at_ < text_.size() && text_[at_] == '+');
        double value = 0;
        const auto [end, error] = std::from_chars(text_.data() + from, text_.data() + text_.size(), value);
        if (error != std::errc() || !std::isfinite(value)) {
            return std::nullopt;
        }
        at_ = static_cast<std::size_t>(end - text_.data());
        return value;
    }
    std::optional<double> flag() {
        skip();
        if (at_ < text_.size() && (text_[at_] == '0' || text_[at_] == '1')) {
            return text_[at_++] - '0';
        }
        return std::nullopt;
    }
    /// A word of letters.
    std::string_view word() {
        skip();
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
        return text_.substr(begin, at_ - begin);
    }
    /// What stands in the next pair of parentheses.
    std::string_view parenthesis() {
        const std::size_t open = text_.find('(', at_);
        const std::size_t close = open == std::string_view::npos ? open : text_.find(')', open);
        if (close == std::string_view::npos) {
            at_ = text_.size();
            return {};
        }
        at_ = close + 1;
        return text_.substr(open + 1, close - open - 1);
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

class PathReader {
  public:
    PathReader(std::string_view text, int around) : scanner_(text), around_(std::max(around, 8)) {}

    std::vector<SvgSubpath> run() {
        char command = 0;
        while (!scanner_.at_end()) {
            if (points_ >= kMostPoints) {
                throw GeometryError(fmt::format("a path in an SVG file has more than {} points", kMostPoints));
            }
            if (const char next = scanner_.command(); next != 0) {
                command = next;
            } else if (command == 'M' || command == 'm') {
                command = command == 'M' ? 'L' : 'l';  // More pairs of a move are lines.
            } else if (command == 0 || command == 'Z' || command == 'z') {
                break;
            }
            if (!step(command)) {
                break;
            }
        }
        finish(false);
        return std::move(lines_);
    }

  private:
    bool step(char command) {
        const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
        const glm::dvec2 base = relative ? at_ : glm::dvec2(0.0);
        const char last = std::exchange(last_, kind);
        glm::dvec2 a, b, c;
        switch (kind) {
            case 'Z':
                finish(true);
                at_ = start_;
                return true;
            case 'M':
                if (!point(base, a)) {
                    return false;
                }
                finish(false);
                start_ = at_ = a;
                loop_ = {a};
                return true;
            case 'L':
                return point(base, a) && line_to(a);
            case 'H':
            case 'V': {
                const auto n = scanner_.number();
                if (!n) {
                    return false;
                }
                return line_to(kind == 'H' ? glm::dvec2(base.x + *n, at_.y) : glm::dvec2(at_.x, base.y + *n));
            }
            case 'C':
                return point(base, a) && point(base, b) && point(base, c) && cubic(a, b, c);
            case 'S':
                a = last == 'C' || last == 'S' ? 2.0 * at_ - control_ : at_;
                return point(base, b) && point(base, c) && cubic(a, b, c);
            case 'Q':
                return point(base, a) && point(base, b) && quadratic(a, b);
            case 'T':
                a = last == 'Q' || last == 'T' ? 2.0 * at_ - control_ : at_;
                return point(base, b) && quadratic(a, b);
            case 'A':
                return arc(base);
            default:
                return false;
        }
    }

    bool point(const glm::dvec2& base, glm::dvec2& out) {
        const auto x = scanner_.number(), y = scanner_.number();
        if (!x || !y) {
            return false;
        }
        out = base + glm::dvec2(*x, *y);
        return true;
    }
    bool line_to(const glm::dvec2& p) {
        if (loop_.empty()) {
            loop_.push_back(at_);  // After a close the path goes on from its start.
        }
        loop_.push_back(at_ = p);
        ++points_;
        return true;
    }
    bool cubic(const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
        const glm::dvec2 a = at_;
        const int steps = around_ / 2;
        for (int i = 1; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps, u = 1 - t;
            line_to(a * (u * u * u) + b * (3 * u * u * t) + c * (3 * u * t * t) + d * (t * t * t));
        }
        control_ = c;
        return true;
    }
    bool quadratic(const glm::dvec2& b, const glm::dvec2& c) {
        const glm::dvec2 a = at_;
        const int steps = around_ / 2;
        for (int i = 1; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps, u = 1 - t;
            line_to(a * (u * u) + b * (2 * u * t) + c * (t * t));
        }
        control_ = b;
        return true;
    }
    /// From the end points to the center (SVG 1.1, appendix F.6.5).
    bool arc(const glm::dvec2& base) {
        const auto rx = scanner_.number(), ry = scanner_.number(), turn = scanner_.number();
        const auto large = scanner_.flag(), sweep = scanner_.flag();
        glm::dvec2 to;
        if (!rx || !ry || !turn || !large || !sweep || !point(base, to)) {
            return false;
        }
        double a = std::abs(*rx), b = std::abs(*ry);
        if (a == 0 || b == 0 || to == at_) {
            return line_to(to);
        }
        const double c = cos_degrees(*turn), s = sin_degrees(*turn);
        const glm::dvec2 half = 0.5 * (at_ - to);
        const glm::dvec2 p(c * half.x + s * half.y, -s * half.x + c * half.y);
        const double reach = (p.x * p.x) / (a * a) + (p.y * p.y) / (b * b);
        if (reach > 1) {
            a *= std::sqrt(reach);
            b *= std::sqrt(reach);
        }
        const double below = a * a * p.y * p.y + b * b * p.x * p.x;
        const double root = std::sqrt(std::max(0.0, (a * a * b * b - below) / below));
        const double sign = (*large != 0) == (*sweep != 0) ? -1 : 1;
        const glm::dvec2 center(sign * root * a * p.y / b, -sign * root * b * p.x / a);
        const double from = atan2_degrees((p.y - center.y) / b, (p.x - center.x) / a);
        double end = atan2_degrees((-p.y - center.y) / b, (-p.x - center.x) / a);
        if (*sweep != 0 && end < from) {
            end += 360;
        }
        if (*sweep == 0 && end > from) {
            end -= 360;
        }
        const glm::dvec2 middle =
            0.5 * (at_ + to) + glm::dvec2(c * center.x - s * center.y, s * center.x + c * center.y);
        if (loop_.empty()) {
            loop_.push_back(at_);
        }
        const std::size_t before = loop_.size();
        add_arc(loop_, middle, glm::dvec2(c, s) * a, glm::dvec2(-s, c) * b, from, end, around_);
        points_ += loop_.size() - before;
        loop_.back() = at_ = to;
        return true;
    }
    void finish(bool closed) {
        closed = closed || is_closed(loop_);
        if (loop_.size() > (closed ? 2U : 1U)) {
            lines_.push_back({std::move(loop_), closed});
        }
        loop_.clear();
    }

    Scanner scanner_;
    const int around_;
    std::vector<SvgSubpath> lines_;
    Loop loop_;
    glm::dvec2 at_{0.0}, start_{0.0}, control_{0.0};
    char last_ = 0;
    std::size_t points_ = 0;
};

glm::dmat4 affine(double a, double b, double c, double d, double e, double f) {
    glm::dmat4 m(1.0);
    m[0] = {a, b, 0, 0};
    m[1] = {c, d, 0, 0};
    m[3] = {e, f, 0, 1};
    return m;
}

}  // namespace

bool is_closed(const Loop& points) {
    constexpr double kNear = 0.1;
    return points.size() > 2 && glm::length(points.front() - points.back()) <= kNear;
}

std::vector<SvgSubpath> read_svg_path(std::string_view text, int around) {
    return PathReader(text, around).run();
}

std::vector<double> read_svg_numbers(std::string_view text) {
    Scanner scanner(text);
    std::vector<double> numbers;
    while (const auto number = scanner.number()) {
        numbers.push_back(*number);
    }
    return numbers;
}

glm::dmat4 read_svg_transform(std::string_view text) {
    Scanner scanner(text);
    glm::dmat4 all(1.0);
    while (!scanner.at_end()) {
        const std::string_view name = scanner.word();
        std::vector<double> n = read_svg_numbers(scanner.parenthesis());
        const std::size_t given = n.size();
        n.resize(6, 0.0);
        if (name == "matrix" && given == 6) {
            all *= affine(n[0], n[1], n[2], n[3], n[4], n[5]);
        } else if (name == "translate") {
            all *= affine(1, 0, 0, 1, n[0], n[1]);
        } else if (name == "scale") {
            all *= affine(n[0], 0, 0, given > 1 ? n[1] : n[0], 0, 0);
        } else if (name == "rotate") {
            const double c = cos_degrees(n[0]), s = sin_degrees(n[0]);
            all *= affine(1, 0, 0, 1, n[1], n[2]) * affine(c, s, -s, c, 0, 0) * affine(1, 0, 0, 1, -n[1], -n[2]);
        } else if (name == "skewX") {
            all *= affine(1, 0, tan_degrees(n[0]), 1, 0, 0);
        } else if (name == "skewY") {
            all *= affine(1, tan_degrees(n[0]), 0, 1, 0, 0);
        } else {
            break;
        }
    }
    return all;
}

}  // namespace csg::solid
