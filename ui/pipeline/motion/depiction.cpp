#include "ui/pipeline/motion/depiction.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "csg/tree/additions.h"
#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/character.h"
#include "ui/pipeline/motion/techniques.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

using Technique = Depiction::Technique;

constexpr double kRadius = 0.004;  ///< Of the size of what moves: that of arrows.

double size_of(const Motion& motion) {
    csg::Box all;
    for (const MovingBody& body : motion.bodies) {
        for (const auto& pose : body.poses) {
            if (pose && !body.box.empty()) {
                for (const glm::dvec3& corner : corners_of(body.box)) {
                    all = csg::enclose(all, glm::dvec3(pose->motion * glm::dvec4(corner, 1)));
                }
            }
        }
    }
    return std::max(all.diagonal(), 1e-300);
}

class Depicter {
  public:
    Depicter(const DepictionSource& source, const std::vector<Depiction>& all, const std::stop_token& stop)
        : motion_(source.motion), all_(all), stop_(stop), stage_{source, size_of(source.motion), {}, {}, {}} {}

    void add(const Depiction& d) {
        try {
            if (d.technique == Technique::Camera) {
                draw_camera(stage_, task(d));
                return;
            }
            for (const MovingBody* body : bodies(d)) {
                try {
                    d.technique == Technique::Auto ? choose(d, *body) : draw(d, d.technique, *body);
                } catch (const std::runtime_error&) {
                    if (!d.rule) {
                        throw;  // A rule is for many, of which some do something else.
                    }
                }
            }
        } catch (const std::runtime_error& problem) {
            throw std::runtime_error(fmt::format("{}: {}", d.text, problem.what()));
        }
    }

    Depicted finish() {
        return {csg::with_additions(stage_.source.model, stage_.additions), std::move(stage_.bubbles),
                std::move(stage_.frames)};
    }

  private:
    [[nodiscard]] std::vector<const MovingBody*> bodies(const Depiction& d) const {
        std::vector<const MovingBody*> found;
        std::vector<std::string> names;
        for (const MovingBody& body : motion_.bodies) {
            if (names_body(d.part, body.name) && !has_own_rule(d, body)) {
                found.push_back(&body);
            }
            names.push_back(body.name);
        }
        if (found.empty() && !d.rule) {
            throw std::runtime_error(
                motion_.bodies.empty() ? "nothing moves while $t runs"
                                       : fmt::format("nothing that moves is called {}{}", d.part,
                                                     suggestion(d.part, names, "; csgscope motion lists what does.")));
        }
        return found;
    }

    /// The rule for all is for those that no other names.
    [[nodiscard]] bool has_own_rule(const Depiction& d, const MovingBody& body) const {
        return d.rule && d.part == "*" && std::any_of(all_.begin(), all_.end(), [&](const Depiction& other) {
                   return other.rule && other.part != "*" && names_body(other.part, body.name);
               });
    }

    void choose(const Depiction& d, const MovingBody& body) {
        switch (character_of(motion_, body).kind) {
            case Character::Kind::Turns:
                draw(d, Technique::Rotation, body);
                break;
            case Character::Kind::Screws:
                draw(d, Technique::Rotation, body);
                draw(d, Technique::Path, body);
                break;
            case Character::Kind::Slides:
            case Character::Kind::Travels:
            case Character::Kind::Moves:
                draw(d, Technique::Ghost, body);
                draw(d, Technique::Path, body);
                break;
            case Character::Kind::Stays:
            case Character::Kind::Deforms:
                break;
        }
    }

    [[nodiscard]] DepictionTask task(const Depiction& d) const {
        const auto [from, to] = d.times.value_or(std::pair(motion_.times.front(), motion_.times.back()));
        return {d, from, to, d.width ? 0.5 * *d.width : kRadius * stage_.size};
    }

    void draw(const Depiction& d, Technique technique, const MovingBody& body) {
        const DepictionTask task = this->task(d);
        const Course course(motion_, body);
        switch (technique) {
            case Technique::Path:
                draw_path(stage_, task, course);
                break;
            case Technique::Motion:
                draw_trails(stage_, task, course);
                break;
            case Technique::Still:
            case Technique::Ghost:
                draw_images(stage_, task, course, technique == Technique::Ghost);
                break;
            case Technique::Rotation:
                draw_rotation(stage_, task, body);
                break;
            case Technique::Collision:
                draw_collisions(stage_, task, body, stop_);
                break;
            case Technique::Frame:
                draw_frame(stage_, task, course);
                break;
            case Technique::Speak:
                draw_speech(stage_, task, course);
                break;
            case Technique::Camera:
            case Technique::Auto:
                break;
        }
    }

    const Motion& motion_;
    const std::vector<Depiction>& all_;
    const std::stop_token& stop_;
    DepictionStage stage_;
};

}  // namespace

void DepictionStage::add(csg::Polyhedron mesh, const csg::Rgba& color) {
    if (!mesh.faces.empty()) {
        additions.push_back(
            {std::make_shared<const csg::Polyhedron>(std::move(mesh)), nullptr, csg::kNoNode, glm::dmat4(1.0), color});
    }
}

Depicted depict(const DepictionSource& source, const std::vector<Depiction>& depictions, const std::stop_token& stop) {
    Depicter depicter(source, depictions, stop);
    for (const Depiction& d : depictions) {
        depicter.add(d);
    }
    return depicter.finish();
}

}  // namespace ui
