#include "ui/pipeline/motion/depiction.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "csg/tree/additions.h"
#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/character.h"
#include "ui/pipeline/motion/course.h"
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
        : motion_(source.motion),
          all_(all),
          stop_(stop),
          stage_{source, size_of(source.motion), glm::dvec3(0), {}, {}, {}, {}} {}

    void add(const Depiction& d) {
        try {
            draw_all(d);
        } catch (const std::runtime_error& problem) {
            throw std::runtime_error(fmt::format("{}: {}", d.text, problem.what()));
        }
    }

    /// Of each body that it names.
    void draw_all(const Depiction& d) {
        if (d.technique == Technique::Camera) {
            draw_camera(stage_, task(d));
            return;
        }
        const std::vector<const MovingBody*> all = bodies(d);
        stage_.onward = all.size() > 1 ? onward(all, task(d)) : glm::dvec3(0);
        for (const MovingBody* body : all) {
            try {
                d.technique == Technique::Auto ? choose(d, *body) : draw(d, d.technique, *body);
            } catch (const std::runtime_error&) {
                if (!d.rule) {
                    throw;  // A rule is for many, of which some do something else.
                }
            }
        }
    }

    Depicted finish() {
        return {csg::with_additions(stage_.source.model, stage_.additions), std::move(stage_.bubbles),
                std::move(stage_.frames), std::move(stage_.styles)};
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
            throw std::runtime_error(motion_.bodies.empty()
                                         ? "nothing moves while $t runs"
                                         : fmt::format("nothing that moves is called {}.{}", d.part,
                                                       suggestion(d.part, names, " csgscope motion lists what does.")));
        }
        return found;
    }

    /// The rule for all is for those that no other names.
    [[nodiscard]] bool has_own_rule(const Depiction& d, const MovingBody& body) const {
        return d.rule && d.part == "*" && std::any_of(all_.begin(), all_.end(), [&](const Depiction& other) {
                   return other.rule && other.part != "*" && names_body(other.part, body.name);
               });
    }

    /// The mean velocity of their middles, by the sizes of their boxes.
    [[nodiscard]] glm::dvec3 onward(const std::vector<const MovingBody*>& all, const DepictionTask& task) const {
        glm::dvec3 sum(0.0);
        double weight = 0;
        for (const MovingBody* body : all) {
            const Course course(motion_, *body);
            const auto first = course.at(task.from), last = course.at(task.to);
            if (first && last && task.from < task.to) {
                const glm::dvec4 middle(middle_of(*body), 1);
                sum += body->box.diagonal() * glm::dvec3(*last * middle - *first * middle) / (task.to - task.from);
                weight += body->box.diagonal();
            }
        }
        return weight > 0 ? sum / weight : sum;
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

Depicted depict_what_can(const DepictionSource& source, const std::vector<Depiction>& depictions,
                         std::vector<std::string>& problems, const std::stop_token& stop) {
    Depicter depicter(source, depictions, stop);
    problems.clear();
    for (const Depiction& d : depictions) {
        std::string& problem = problems.emplace_back();
        try {
            depicter.draw_all(d);
        } catch (const std::runtime_error& error) {
            problem = error.what();
        }
    }
    return depicter.finish();
}

std::vector<npr::PartStyle> styles_of_glyphs(const csg::Scene& scene, const std::vector<GlyphStyle>& glyphs) {
    std::vector<npr::PartStyle> styles;
    for (const GlyphStyle& glyph : glyphs) {
        for (const csg::Part& part : scene.parts) {
            if (part.color == glyph.color) {
                npr::PartStyle& style = styles.emplace_back(glyph.drawn);
                style.of.name = style.of.text = part.name;
                style.of.exact = true;
            }
        }
    }
    return styles;
}

}  // namespace ui
