// Leaves whose shells overlap, lie in each other, are turned, or cross themselves: inside is a winding number.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/stability/family.h"

namespace stability {

namespace {

using Id = Maker::Id;
using Ring = std::vector<glm::dvec3>;
const glm::dvec3 kEye(13, -17, 15);

/// One mesh of many shells.
class Shells {
  public:
    /// Walls from ring to ring, and a fan in the first and in the last, whatever the rings are. They are
    /// counter-clockwise seen from where the last one is; `turned`: the shell is inside out.
    void loft(const std::vector<Ring>& rings, bool turned = false) {
        const auto n = static_cast<std::uint32_t>(rings.front().size());
        std::uint32_t at = static_cast<std::uint32_t>(points_.size());
        for (const Ring& ring : rings) {
            points_.insert(points_.end(), ring.begin(), ring.end());
        }
        const std::uint32_t last = at + n * static_cast<std::uint32_t>(rings.size() - 1);
        for (std::uint32_t i = 2; i < n; ++i) {
            add({at, at + i, at + i - 1}, turned);
            add({last, last + i - 1, last + i}, turned);
        }
        for (; at < last; at += n) {
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t j = (i + 1) % n;
                add({at + i, at + j, at + n + j}, turned);
                add({at + i, at + n + j, at + n + i}, turned);
            }
        }
    }
    void box(const glm::dvec3& lo, const glm::dvec3& size, bool turned = false) {
        const auto ring = [&](double z) {
            return Ring{lo + glm::dvec3(0, 0, z), lo + glm::dvec3(size.x, 0, z), lo + glm::dvec3(size.x, size.y, z),
                        lo + glm::dvec3(0, size.y, z)};
        };
        loft({ring(0), ring(size.z)}, turned);
    }
    void ball(const glm::dvec3& center, double radius, bool turned = false) {
        std::vector<Ring> rings;
        for (int k = 0; k < kSides / 2; ++k) {
            const double polar = std::numbers::pi * (k + 0.5) / (kSides / 2);
            rings.push_back(circle(center - glm::dvec3(0, 0, radius * std::cos(polar)), radius * std::sin(polar),
                                   {1, 0, 0}, {0, 1, 0}));
        }
        loft(rings, turned);
    }
    /// Counter-clockwise where u × v faces the eye.
    static Ring circle(const glm::dvec3& center, double radius, const glm::dvec3& u, const glm::dvec3& v) {
        Ring ring;
        for (int i = 0; i < kSides; ++i) {
            const double angle = 2 * std::numbers::pi * i / kSides;
            ring.push_back(center + radius * (std::cos(angle) * u + std::sin(angle) * v));
        }
        return ring;
    }
    [[nodiscard]] Id mesh(Maker& m) const { return m.mesh(points_, faces_); }

  private:
    static constexpr int kSides = 16;

    /// A polyhedron's faces are clockwise seen from outside.
    void add(std::vector<std::uint32_t> face, bool turned) {
        if (!turned) {
            std::reverse(face.begin(), face.end());
        }
        faces_.push_back(std::move(face));
    }

    std::vector<glm::dvec3> points_;
    std::vector<std::vector<std::uint32_t>> faces_;
};

/// Less the quarter that is nearest to the eye.
Case cut_open(Maker& m, Id body) {
    return m.seen(m.subtract({body, m.box({0, -10, 0}, {10, 10, 10})}), kEye, {0, 0, 0});
}

Case nested(double n, bool alternate) {
    Maker m;
    Shells shells;
    for (int i = 0; i < static_cast<int>(n); ++i) {
        shells.ball({0, 0, 0}, 5 * (1 - i / n), alternate && i % 2 == 1);
    }
    return cut_open(m, shells.mesh(m));
}

/// A wire on a helix of four turns.
Case spring(double pitch) {
    constexpr int kSteps = 96;
    constexpr double kWire = 0.6, kTurns = 4;
    Maker m;
    Shells shells;
    std::vector<Ring> rings;
    for (int k = 0; k <= kSteps; ++k) {
        const double angle = 2 * std::numbers::pi * kTurns * k / kSteps;
        const glm::dvec3 outwards(std::cos(angle), std::sin(angle), 0), up(0, 0, 1);
        const double height = 2 * kWire * pitch * (kTurns * k / kSteps - kTurns / 2);
        rings.push_back(Shells::circle(4.0 * outwards + height * up, kWire, up, outwards));
    }
    shells.loft(rings);
    return cut_open(m, shells.mesh(m));
}

/// A prism over a star of 2n + 1 points, whose outline goes around its middle n times.
Case star(double n) {
    Maker m;
    Shells shells;
    const int points = 2 * static_cast<int>(n) + 1;
    Ring below, above;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * n * i / points;
        below.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), -1);
        above.emplace_back(below.back().x, below.back().y, 2);
    }
    shells.loft({below, above});
    return cut_open(m, shells.mesh(m));
}

}  // namespace

void add_windings(std::vector<Family>& all) {
    all.push_back({"shells in shells",
                   "n balls in each other, one mesh, cut open: solid throughout.",
                   "balls",
                   {1, 2, 3, 5, 9, 17},
                   [](double n) { return nested(n, false); }});
    all.push_back({"cavities as shells",
                   "The same with every second ball inside out: a hollow in it.",
                   "balls",
                   {1, 2, 3, 4, 8, 15},
                   [](double n) { return nested(n, true); }});
    all.push_back({"shells many times",
                   "A box n times and n - 1 times inside out, and n times another that overlaps it.",
                   "times",
                   {1, 2, 3, 5, 9},
                   [](double n) {
                       Maker m;
                       Shells shells;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           shells.box({-4, -4, -4}, {5, 6, 7});
                           shells.box({-2, -2, -2}, {6, 5, 4});
                           if (i > 0) {
                               shells.box({-4, -4, -4}, {5, 6, 7}, true);
                           }
                       }
                       return cut_open(m, shells.mesh(m));
                   }});
    all.push_back({"turned shells",
                   "n boxes in a row that overlap, every second inside out: nothing where two overlap.",
                   "boxes",
                   {2, 3, 4, 6, 9},
                   [](double n) {
                       Maker m;
                       Shells shells;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           shells.box({-5 + 10 * i / n, -4 + 0.3 * i, -3}, {14 / n, 7, 6}, i % 2 == 1);
                       }
                       return cut_open(m, shells.mesh(m));
                   }});
    all.push_back({"springs",
                   "A wire on a helix, one mesh, cut open: below 1 its turns overlap.",
                   "pitch over thickness",
                   {1.5, 1.1, 1, 0.9, 0.5, 0.2, 0.05},
                   spring});
    all.push_back({"stars",
                   "A prism over a star whose outline crosses itself.",
                   "times around the middle",
                   {1, 2, 3, 5, 10, 20},
                   star});
    all.push_back({"four faces at an edge",
                   "A board of n × n dice in one mesh, every second one there.",
                   "dice a side",
                   {1, 2, 3, 5, 8, 12},
                   [](double n) {
                       Maker m;
                       Shells shells;
                       const int side = static_cast<int>(n);
                       for (int i = 0; i < side * side * side; ++i) {
                           const glm::ivec3 at(i % side, i / side % side, i / side / side);
                           if ((at.x + at.y + at.z) % 2 == 0) {
                               shells.box(glm::dvec3(at) * (8.0 / side) - 4.0, glm::dvec3(8.0 / side));
                           }
                       }
                       return m.seen(m.subtract({shells.mesh(m), m.sphere({4, -4, 4}, 5)}), kEye, {0, 0, 0});
                   }});
}

}  // namespace stability
