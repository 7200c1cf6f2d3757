#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/techniques.h"

namespace ui {

/// About all places where it is at the task's times, or at the one time.
void draw_frame(DepictionStage& stage, const DepictionTask& task, const Course& course) {
    const MovingBody& body = course.body();
    std::vector<double> times{task.from, task.to};
    if (!task.what.times) {
        times = {stage.source.now};  // Where it is seen.
    } else {
        for (const double t : stage.source.motion.times) {
            if (t > task.from && t < task.to) {
                times.push_back(t);
            }
        }
    }
    FrameRequest frame{{}, task.what.say, task.what.width, task.what.color};
    for (const double time : times) {
        if (const auto pose = course.at(time)) {
            for (const glm::dvec3& point : body.extremes) {
                frame.points.emplace_back(*pose * glm::dvec4(point, 1));
            }
        }
    }
    if (frame.points.empty()) {
        throw std::runtime_error(fmt::format("{} is not there at $t = {:g}", body.name, times.front()));
    }
    stage.frames.push_back(std::move(frame));
}

/// From the topmost of its points.
void draw_speech(DepictionStage& stage, const DepictionTask& task, const Course& course) {
    const MovingBody& body = course.body();
    const double time = task.what.times ? task.to : stage.source.now;
    const auto pose = course.at(time);
    if (!pose || body.extremes.empty()) {
        throw std::runtime_error(fmt::format("{} is not there at $t = {:g}", body.name, time));
    }
    glm::dvec3 top(0.0);
    for (std::size_t i = 0; i < body.extremes.size(); ++i) {
        const glm::dvec3 point(*pose * glm::dvec4(body.extremes[i], 1));
        top = i == 0 || point.z > top.z ? point : top;
    }
    stage.bubbles.push_back({top, task.what.say, task.what.color});
}

}  // namespace ui
