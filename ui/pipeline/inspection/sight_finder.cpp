#include "ui/pipeline/inspection/sight_finder.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "ui/pipeline/inspection/solid_probe.h"

namespace ui {

struct SightFinder::State {
    explicit State(std::shared_ptr<const Model> of)
        : model(std::move(of)), probe(model->scene, model->geometry), links(model->scene), ray(probe, links) {}

    bool seen(const glm::dvec3& point, const glm::dvec3& from) {
        probe.sides(point, from, sides);
        return ray.at(sides.front).parts().empty() &&
               !ray.enter(point, from, sides.front, std::numeric_limits<double>::infinity());
    }

    std::shared_ptr<const Model> model;
    SolidProbe probe;
    ExpressionLinks links;
    PartRay ray;
    SolidProbe::Sides sides;
};

SightFinder::SightFinder(std::shared_ptr<const Model> model) : state_(std::make_unique<State>(std::move(model))) {}
SightFinder::~SightFinder() = default;

glm::dvec3 SightFinder::from(const glm::dvec3& point, const glm::dvec3& wish) {
    const auto seen = [&](const glm::dvec3& from) { return state_->seen(point, from); };
    if (seen(wish)) {
        return wish;
    }
    // Along the axes, and between two and three of them; not just so, that faces across an axis are not seen edge-on.
    std::vector<glm::dvec3> others;
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (i != 13) {
            others.push_back(glm::normalize(step + glm::dvec3(0.11, -0.17, 0.13)));
        }
    }
    std::stable_sort(others.begin(), others.end(),
                     [&](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, wish) > glm::dot(b, wish); });
    const auto found = std::find_if(others.begin(), others.end(), seen);
    return found != others.end() ? *found : wish;
}

}  // namespace ui
