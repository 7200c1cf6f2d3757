#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "ui/pipeline/drawn_style.h"
#include "ui/pipeline/motion/character.h"
#include "ui/pipeline/motion/techniques.h"

namespace ui {

namespace {

constexpr csg::Rgba kGhost{0.55F, 0.6F, 0.7F, 1};

/// Stretched along the way by its share of the highest speed, as much thinner across it.
glm::dmat4 squashed(const Motion& motion, const Course& course, double time, double most, double fastest) {
    const double h = 1e-3 * (motion.times.back() - motion.times.front());
    const double first = std::max(time - h, motion.times.front()), last = std::min(time + h, motion.times.back());
    const auto a = course.at(first), b = course.at(last), here = course.at(time);
    const glm::dvec4 middle(middle_of(course.body()), 1);
    if (!a || !b || !here || fastest <= 0) {
        return glm::dmat4(1.0);
    }
    const glm::dvec3 way(*b * middle - *a * middle);
    const double speed = glm::length(way) / (last - first);
    if (speed <= 0) {
        return glm::dmat4(1.0);
    }
    const glm::dvec3 ahead = glm::normalize(way), at(*here * middle);
    const double along = 1 + most * std::min(1.0, speed / fastest), aside = 1 / std::sqrt(along);
    glm::dmat3 m(aside);
    m += (along - aside) * glm::outerProduct(ahead, ahead);
    glm::dmat4 result(m);
    result[3] = glm::dvec4(at - m * at, 1);
    return result;
}

}  // namespace

std::optional<npr::PartStyle> style_of(const Depiction& d) {
    if (d.style.empty()) {
        return std::nullopt;
    }
    try {
        return read_drawn_style(d.style);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            fmt::format("expected a style: {}\n  {}\n  {:>{}}", error.what(), d.text, '^', d.style_at + 1));
    }
}

void draw_images(DepictionStage& stage, const DepictionTask& task, const Course& course, bool several) {
    const double from = task.from, to = task.to;
    const Depiction& d = task.what;
    const MovingBody& body = course.body();
    if (body.changes_shape) {
        throw std::runtime_error(fmt::format("{} changes its shape, of which there are no images", body.name));
    }
    const int count = several && from < to ? d.count : 1;
    const std::optional<npr::PartStyle> style = style_of(d);
    const double fastest = character_of(stage.source.motion, body).fastest;
    for (int i = 0; i < count; ++i) {
        const double time = count == 1 ? (several ? from : to) : from + (to - from) * i / (count - 1);
        const auto pose = course.at(time);
        // Where the model itself stands there is nothing to add.
        if (!pose || (several && std::abs(time - stage.source.now) <
                                     1e-9 * (stage.source.motion.times.back() - stage.source.motion.times.front()))) {
            continue;
        }
        csg::Rgba color = d.color ? *d.color : body.color.given() ? body.color : kGhost;
        const double span = std::max({std::abs(from - stage.source.now), std::abs(to - stage.source.now), 1e-300});
        const double away = std::abs(time - stage.source.now) / span;
        if (style) {
            // A part of its own in any case, by a color that is seen through by next to nothing; it fades as a whole.
            constexpr float kOwn = 0.996F, kStep = 1e-5F;
            color.a = kOwn - kStep * static_cast<float>(stage.styles.size());
            npr::PartStyle drawn = *style;
            drawn.opacity = several ? static_cast<float>(0.9 - 0.65 * away) : 1;
            stage.styles.push_back({color, std::move(drawn)});
        } else if (several) {
            color.a = static_cast<float>(0.5 - 0.35 * away);
        }
        const glm::dmat4 placed = *pose * body.to_world;
        const glm::dmat4 shown =
            d.squash > 0 ? squashed(stage.source.motion, course, time, d.squash, fastest) * placed : placed;
        stage.additions.push_back({{}, body.tree.get(), body.top, shown, color});
    }
}

}  // namespace ui
