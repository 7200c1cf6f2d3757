#include "ui/pipeline/motion/body_at.h"

#include <algorithm>
#include <cmath>

#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/motion/course.h"

namespace ui {

const MovingBody* body_at(const Motion& motion, const Model& model, csg::OccurrenceId occurrence,
                          const glm::dvec3& point, double time) {
    const std::vector<CallStep> steps = steps_to(model, occurrence);
    const auto leads_to = [&](const csg::SourceLocation& call) {
        return std::any_of(steps.begin(), steps.end(), [&](const CallStep& step) {
            const csg::SourceLocation& where = step.node.where;
            return where.known() && where.line == call.line && where.column == call.column &&
                   model.tree->files()[where.file] == motion.tree->files()[call.file];
        });
    };
    const MovingBody* nearest = nullptr;
    double least = INFINITY;
    for (const MovingBody& body : motion.bodies) {
        if (steps.empty() || (body.where.known() && !leads_to(body.where))) {
            continue;
        }
        const auto pose = Course(motion, body).at(time);
        if (!pose) {
            continue;
        }
        const glm::dvec3 p(glm::inverse(*pose) * glm::dvec4(point, 1));
        const double away = glm::distance(p, glm::clamp(p, body.box.lo, body.box.hi));
        if (away < least) {
            least = away;
            nearest = &body;
        }
    }
    return nearest;
}

}  // namespace ui
