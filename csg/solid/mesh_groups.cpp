#include <algorithm>
#include <array>
#include <cmath>

#include "csg/solid/mesh_faces.h"

namespace csg::solid {
namespace {

/// As for outlines (outline_curves.cpp): of angles that follow each other on a curve.
constexpr float kMostAngleRatio = 2.3F;
/// Facets of a curve have few edges, but for what was cut out of them.
constexpr std::size_t kMostEdges = 48;
/// Degrees below which a surface may be uneven.
constexpr float kUneven = 25;
/// The cosine of the angle by which a line of edges turns from one to the next, at most.
constexpr double kOnward = 0.5;

double most_ratio_of_widths(float degrees) {
    return degrees < 12 ? 6 : degrees < kUneven ? 3 : 1.7;
}

constexpr char kPerhaps = 2;

class Estimate {
  public:
    explicit Estimate(Solid& solid)
        : solid_(solid), faces_(solid), smooth_(faces_.edges().size()), row_(faces_.edges().size()) {}

    void run() {
        const auto& edges = faces_.edges();
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            const float angle = std::abs(edges[i].degrees);
            if (angle < static_cast<float>(kLeastCrease)) {
                smooth_[i] = 1;
            } else if (angle <= static_cast<float>(kMostBend)) {
                look_for_row(i);
            }
        }
        extend_rows();
        judge_uneven();
        take_back_lonely();
        number();
    }

  private:
    /// An edge of a row with the one before or after it.
    struct Next {
        std::uint32_t edge = 0;
        double width = 0;  ///< Of the face between.
    };

    [[nodiscard]] glm::dvec3 way(const MeshEdge& edge) const {
        return solid_.points[edge.to] - solid_.points[edge.from];
    }

    /// The distance of the middle of `other` from the line of `edge`.
    [[nodiscard]] double width(const MeshEdge& edge, const MeshEdge& other) const {
        const glm::dvec3 along = way(edge);
        const glm::dvec3 to = (solid_.points[other.from] + solid_.points[other.to]) * 0.5 - solid_.points[edge.from];
        return glm::length(glm::cross(along, to)) / glm::length(along);
    }

    /// `most_ratio`: of the larger to the smaller.
    [[nodiscard]] static bool alike(float a, float b, float most_ratio) {
        const float least = std::min(std::abs(a), std::abs(b)), most = std::max(std::abs(a), std::abs(b));
        return a * b > 0 && most <= static_cast<float>(kMostBend) && most <= most_ratio * least;
    }

    /// Does the middle of `other` lie beside `edge`, not beyond its ends?
    [[nodiscard]] bool opposite(const MeshEdge& edge, const MeshEdge& other) const {
        const glm::dvec3 along = way(edge);
        const glm::dvec3 to = (solid_.points[other.from] + solid_.points[other.to]) * 0.5 - solid_.points[edge.from];
        const double at = glm::dot(to, along) / glm::dot(along, along);
        return at > -1e-3 && at < 1 + 1e-3;
    }

    /// Across a face from one of its edges to those that bend alike; where it is half a bent quadrilateral, across
    /// that.
    void add_next(std::uint32_t from, std::uint32_t face, float most_ratio, std::vector<Next>& found) const {
        const auto around = faces_.around(face);
        if (around.size() > kMostEdges) {
            return;
        }
        add_alike(from, from, around, most_ratio, found);
        for (const std::uint32_t i : around) {
            const MeshEdge& middle = faces_.edges()[i];
            if (around.size() != 3 || i == from || std::abs(middle.degrees) >= kUneven) {
                continue;
            }
            const auto beyond = faces_.around(faces_.side(middle, faces_.side(middle, 0) == face ? 1 : 0));
            if (beyond.size() == 3) {
                add_alike(from, i, beyond, most_ratio, found);
            }
        }
    }

    /// `around`: a face whose edge `across` leads from the edge `from`, or is that.
    void add_alike(std::uint32_t from, std::uint32_t across, std::span<const std::uint32_t> around, float most_ratio,
                   std::vector<Next>& found) const {
        const MeshEdge& edge = faces_.edges()[from];
        for (const std::uint32_t i : around) {
            const MeshEdge& other = faces_.edges()[i];
            if (i == from || i == across || !alike(edge.degrees, other.degrees, most_ratio) ||
                ((around.size() > 3 || across != from) && !opposite(edge, other))) {
                continue;
            }
            // Edges in one line are no row.
            if (const double wide = width(edge, other); wide > 1e-6 * glm::length(way(edge))) {
                found.push_back({i, wide});
            }
        }
    }

    void look_for_row(std::uint32_t i) {
        const MeshEdge& edge = faces_.edges()[i];
        for (std::vector<Next>* side : {&before_, &after_}) {
            side->clear();
        }
        add_next(i, faces_.side(edge, 0), kMostAngleRatio, before_);
        add_next(i, faces_.side(edge, 1), kMostAngleRatio, after_);
        for (const Next& a : before_) {
            for (const Next& b : after_) {
                const float most = std::max({std::abs(edge.degrees), std::abs(faces_.edges()[a.edge].degrees),
                                             std::abs(faces_.edges()[b.edge].degrees)});
                if (std::max(a.width, b.width) <= most_ratio_of_widths(most) * std::min(a.width, b.width)) {
                    const auto wide = static_cast<float>(std::max(a.width, b.width));
                    for (const std::uint32_t k : {i, a.edge, b.edge}) {
                        smooth_[k] = 1;
                        row_[k] = std::max(row_[k], wide);
                    }
                    return;
                }
            }
        }
        if (std::abs(edge.degrees) < kUneven && uneven(edge, 0) && uneven(edge, 1)) {
            smooth_[i] = kPerhaps;
        }
    }

    /// A row goes on where it bends less, by whatever ratio, with facets not much wider than its own.
    void extend_rows() {
        constexpr double kWider = 2;
        const auto& edges = faces_.edges();
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            const float angle = std::abs(edges[i].degrees);
            if (smooth_[i] == 1 || angle >= kUneven) {
                continue;
            }
            before_.clear();
            add_next(i, faces_.side(edges[i], 0), 1e3F, before_);
            add_next(i, faces_.side(edges[i], 1), 1e3F, before_);
            const bool in_row = std::any_of(before_.begin(), before_.end(), [&](const Next& next) {
                return row_[next.edge] > 0 && std::abs(edges[next.edge].degrees) > angle &&
                       next.width <= kWider * static_cast<double>(row_[next.edge]);
            });
            if (in_row) {
                smooth_[i] = 1;
            }
        }
    }

    /// Uneven surfaces have many faces; a few are a body with shallow edges.
    void judge_uneven() {
        constexpr std::uint32_t kMany = 24;
        Sets parts(faces_.count());
        const auto& edges = faces_.edges();
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            if (smooth_[i] != 0) {
                parts.unite(faces_.side(edges[i], 0), faces_.side(edges[i], 1));
            }
        }
        std::vector<std::uint32_t> count(faces_.count());
        for (std::uint32_t face = 0; face < faces_.count(); ++face) {
            ++count[parts.find(face)];
        }
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            if (smooth_[i] == kPerhaps) {
                smooth_[i] = count[parts.find(faces_.side(edges[i], 0))] >= kMany ? 1 : 0;
            }
        }
    }

    /// Is a face of a few edges and bends elsewhere about as much, either way?
    [[nodiscard]] bool uneven(const MeshEdge& edge, int side) const {
        const auto around = faces_.around(faces_.side(edge, side));
        const double length = glm::length(way(edge));
        return around.size() <= 4 && std::any_of(around.begin(), around.end(), [&](std::uint32_t i) {
                   const MeshEdge& other = faces_.edges()[i];
                   const float bend = std::abs(other.degrees);
                   const double ratio = glm::length(way(other)) / length;
                   return &other != &edge && bend > 0.5F * std::abs(edge.degrees) && bend < kUneven && ratio > 0.1 &&
                          ratio < 10;
               });
    }

    /// Sharp edges below kUneven that do not go on as sharp ones at both ends are no line.
    void take_back_lonely() {
        const auto& edges = faces_.edges();
        std::vector<std::uint32_t> first(solid_.points.size() + 1);
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            if (smooth_[i] == 0) {
                ++first[edges[i].from + 1];
                ++first[edges[i].to + 1];
            }
        }
        for (std::size_t p = 1; p < first.size(); ++p) {
            first[p] += first[p - 1];
        }
        std::vector<std::uint32_t> at(first.back()), next(first.begin(), first.end() - 1);
        std::vector<std::uint32_t> doubtful;
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            if (smooth_[i] == 0) {
                at[next[edges[i].from]++] = i;
                at[next[edges[i].to]++] = i;
                if (std::abs(edges[i].degrees) < kUneven) {
                    doubtful.push_back(i);
                }
            }
        }
        const auto goes_on = [&](std::uint32_t i, std::uint32_t point, const glm::dvec3& onward) {
            for (std::uint32_t k = first[point]; k < first[point + 1]; ++k) {
                const MeshEdge& other = edges[at[k]];
                if (at[k] == i || smooth_[at[k]] != 0) {
                    continue;
                }
                const glm::dvec3 on = other.from == point ? way(other) : -way(other);
                if (std::abs(other.degrees) >= kUneven ||
                    glm::dot(on, onward) >= kOnward * glm::length(on) * glm::length(onward)) {
                    return true;
                }
            }
            return false;
        };
        while (!doubtful.empty()) {
            const std::uint32_t i = doubtful.back();
            doubtful.pop_back();
            const MeshEdge& edge = edges[i];
            if (smooth_[i] != 0 ||
                (!cuts_corner(edge) && goes_on(i, edge.to, way(edge)) && goes_on(i, edge.from, -way(edge)))) {
                continue;
            }
            smooth_[i] = 1;
            for (const std::uint32_t point : {edge.from, edge.to}) {
                for (std::uint32_t k = first[point]; k < first[point + 1]; ++k) {
                    if (smooth_[at[k]] == 0 && std::abs(edges[at[k]].degrees) < kUneven) {
                        doubtful.push_back(at[k]);
                    }
                }
            }
        }
    }

    /// Is a triangle in a corner all that the edge cuts off?
    [[nodiscard]] bool cuts_corner(const MeshEdge& edge) const {
        const auto in_corner = [&](int side) {
            const auto around = faces_.around(faces_.side(edge, side));
            return around.size() == 3 && std::all_of(around.begin(), around.end(), [&](std::uint32_t i) {
                       const MeshEdge& other = faces_.edges()[i];
                       return &other == &edge || (smooth_[i] == 0 && std::abs(other.degrees) >= kUneven);
                   });
        };
        return in_corner(0) || in_corner(1);
    }

    void number() {
        Sets surfaces(faces_.count());
        const auto& edges = faces_.edges();
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            if (smooth_[i] != 0) {
                surfaces.unite(faces_.side(edges[i], 0), faces_.side(edges[i], 1));
            }
        }
        std::uint32_t count = 0;
        const std::vector<std::uint32_t> surface = surfaces.numbers(count);
        std::vector<FacetGroup> groups;
        groups.reserve(surface.size());
        for (const std::uint32_t s : surface) {
            groups.emplace_back(s);
        }
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            if (smooth_[i] != 0) {
                groups[faces_.side(edges[i], 0)].bends(std::abs(edges[i].degrees));
                groups[faces_.side(edges[i], 1)].bends(std::abs(edges[i].degrees));
            }
        }
        solid_.groups.clear();
        solid_.groups.reserve(solid_.triangles.size());
        for (std::uint32_t t = 0; t < solid_.triangles.size(); ++t) {
            solid_.groups.push_back(groups[faces_.face_of(t)]);
        }
        solid_.groups_estimated = true;
    }

    Solid& solid_;
    MeshFaces faces_;
    std::vector<char> smooth_;          ///< By edge.
    std::vector<float> row_;            ///< By edge: how wide facets of the row are that it is of; 0: of none.
    std::vector<Next> before_, after_;  ///< Kept for their memory.
};

}  // namespace

void estimate_groups(Solid& solid) {
    Estimate(solid).run();
}

}  // namespace csg::solid
