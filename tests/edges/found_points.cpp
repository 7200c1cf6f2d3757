#include <algorithm>
#include <cmath>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/surface_table.h"
#include "npr/edges/line_code.h"
#include "npr/painter/cpu_edges.h"
#include "npr/picture.h"
#include "tests/edges/edge_points.h"

namespace edges {
namespace {

/// Points by their pixels.
class Near {
  public:
    Near(const std::vector<Point>& points, glm::ivec2 size)
        : size_(size), by_pixel_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
        for (const Point& p : points) {
            const glm::ivec2 pixel = glm::clamp(glm::ivec2(p.at), glm::ivec2(0), size - 1);
            by_pixel_[index(pixel)].push_back(p.at);
        }
    }

    [[nodiscard]] bool any(const Point& p) const {
        const glm::ivec2 middle(glm::floor(p.at));
        for (int y = std::max(middle.y - 1, 0); y <= std::min(middle.y + 1, size_.y - 1); ++y) {
            for (int x = std::max(middle.x - 1, 0); x <= std::min(middle.x + 1, size_.x - 1); ++x) {
                const auto& here = by_pixel_[index({x, y})];
                if (std::any_of(here.begin(), here.end(),
                                [&](const glm::dvec2& q) { return glm::distance(q, p.at) <= 1; })) {
                    return true;
                }
            }
        }
        return false;
    }

  private:
    [[nodiscard]] std::size_t index(glm::ivec2 p) const {
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(p.x);
    }

    glm::ivec2 size_;
    std::vector<std::vector<glm::dvec2>> by_pixel_;
};

std::size_t count_near(const std::vector<Point>& points, const std::vector<Point>& others, glm::ivec2 size) {
    const Near near(others, size);
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&](const Point& p) { return near.any(p); }));
}

double share(std::size_t part, std::size_t all) {
    return all == 0 ? 1 : static_cast<double>(part) / static_cast<double>(all);
}

}  // namespace

double Score::precision() const {
    return share(right, drawn);
}
double Score::recall() const {
    return share(found, points);
}
double Score::f() const {
    const double p = precision(), r = recall();
    return p + r > 0 ? 2 * p * r / (p + r) : 0;
}
void Score::add(const Score& other) {
    drawn += other.drawn;
    right += other.right;
    points += other.points;
    found += other.found;
}

Score score(const std::vector<Point>& truth, const std::vector<Point>& found, glm::ivec2 size) {
    return {found.size(), count_near(found, truth, size), truth.size(), count_near(truth, found, size)};
}

layers::HostStack layers_of(const ui::Model& model, const base::View& view) {
    layers::HostStack stack = goldfeather::peel_to_host(model.scene, model.geometry, view);
    stack.table = goldfeather::surface_table(model.scene, model.geometry);
    return stack;
}

std::vector<Point> found_points(const layers::HostStack& stack, const base::View& view) {
    npr::Picture picture;
    picture.size = view.size();
    npr::EdgeSettings settings;
    settings.facts = true;
    std::vector<glm::vec4> unused;
    std::vector<Point> points;
    npr::shader::LineCode code;
    for (const auto& tile : npr::find_edges({picture, view, stack, unused}, settings)) {
        for (const npr::CpuEdge& e : tile) {
            const auto facts = code.unpack_facts(e.facts);
            const Kind kind = e.profile                         ? Kind::Silhouette
                              : facts.kind == code.kColorBorder ? Kind::Border
                                                                : Kind::Crease;
            const glm::dvec2 at = glm::dvec2(e.at) + 0.5 + view.jitter(), size(view.size());
            if (at.x >= 1 && at.y >= 1 && at.x <= size.x - 1 && at.y <= size.y - 1) {
                points.push_back({at, kind, facts.surfaces > 0});
            }
        }
    }
    return points;
}

}  // namespace edges
