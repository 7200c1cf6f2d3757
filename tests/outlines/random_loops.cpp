#include "tests/outlines/random_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace outlines {
namespace {

using csg::solid::Loop;

/// Numbers that are the same with every standard library.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed * 2654435761u + 1) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
    double real() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  private:
    std::mt19937_64 engine_;
};

Loop walk(Dice& dice, int corners, int side) {
    Loop loop;
    while (static_cast<int>(loop.size()) < corners) {
        if (loop.size() > 1 && dice.below(8) == 0) {
            loop.push_back(loop[static_cast<std::size_t>(dice.below(static_cast<int>(loop.size())))]);
        } else {
            loop.emplace_back(dice.below(side), dice.below(side));
        }
    }
    return loop;
}

/// Unit squares of a grid: many meet in corners, some are there twice.
std::vector<Loop> squares(Dice& dice) {
    std::vector<Loop> loops;
    for (int i = 3 + dice.below(14); i > 0; --i) {
        const double x = dice.below(5), y = dice.below(5), s = 1 + dice.below(2);
        loops.push_back({{x, y}, {x + s, y}, {x + s, y + s}, {x, y + s}});
        if (dice.below(2) == 0) {
            std::reverse(loops.back().begin(), loops.back().end());
        }
    }
    return loops;
}

Loop star(Dice& dice, int corners, int step, double size) {
    Loop loop;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * 3.14159265358979323846 * i * step / corners;
        const double r = step == 1 ? size * (0.3 + 0.7 * dice.real()) : size;
        loop.emplace_back(4 + r * std::cos(angle), 4 + r * std::sin(angle));
    }
    return loop;
}

/// Rings in each other, with triangles that reach from one to the next.
std::vector<Loop> nested(Dice& dice) {
    std::vector<Loop> loops;
    const int rings = 2 + dice.below(3);
    for (int i = 0; i < rings; ++i) {
        const double lo = i, hi = 8 - i;
        loops.push_back({{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}});
    }
    for (int i = dice.below(4); i > 0; --i) {
        loops.push_back(walk(dice, 3, 9));
    }
    return loops;
}

std::vector<Loop> plain(Dice& dice) {
    std::vector<Loop> loops;
    switch (dice.below(6)) {
        case 0:
            for (int i = 1 + dice.below(4); i > 0; --i) {
                loops.push_back(walk(dice, 3 + dice.below(6), 7));
            }
            return loops;
        case 1:
            return {walk(dice, 4 + dice.below(12), 5)};
        case 2:
            return squares(dice);
        case 3:
            for (int i = 1 + dice.below(2); i > 0; --i) {
                loops.push_back(star(dice, 5 + dice.below(20), 1 + dice.below(3), 1 + dice.below(4)));
            }
            return loops;
        case 4:
            return nested(dice);
        default:
            for (int i = 1 + dice.below(3); i > 0; --i) {
                Loop& loop = loops.emplace_back();
                for (int k = 3 + dice.below(9); k > 0; --k) {
                    loop.emplace_back(8 * dice.real(), 8 * dice.real());
                }
            }
            return loops;
    }
}

}  // namespace

std::vector<Loop> random_loops(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Loop> loops = plain(dice);
    const int kind = dice.below(6);
    const double angle = kind == 1 || kind == 2 ? 6.3 * dice.real() : 0;
    const double noise = kind == 2 || kind == 3 ? std::pow(10.0, -16 + dice.below(14)) : 0;
    const double away = kind == 4 ? std::pow(10.0, dice.below(7)) : 0;
    const double scale = kind == 5 ? std::pow(10.0, dice.below(9) - 4) : 1;
    for (Loop& loop : loops) {
        for (glm::dvec2& p : loop) {
            const glm::dvec2 turned(std::cos(angle) * p.x - std::sin(angle) * p.y,
                                    std::sin(angle) * p.x + std::cos(angle) * p.y);
            p = scale * turned + glm::dvec2(away, -away / 3) + noise * glm::dvec2(dice.real() - 0.5, dice.real() - 0.5);
        }
    }
    return loops;
}

std::string as_scad(const std::vector<Loop>& loops) {
    std::string points, paths;
    int index = 0;
    for (const Loop& loop : loops) {
        std::string path;
        for (const glm::dvec2& p : loop) {
            points += fmt::format("{}[{:.17g},{:.17g}]", points.empty() ? "" : ",", p.x, p.y);
            path += fmt::format("{}{}", path.empty() ? "" : ",", index++);
        }
        paths += fmt::format("{}[{}]", paths.empty() ? "" : ",", path);
    }
    return fmt::format("polygon([{}],[{}]);", points, paths);
}

}  // namespace outlines
