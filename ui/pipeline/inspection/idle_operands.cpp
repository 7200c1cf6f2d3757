#include "ui/pipeline/inspection/idle_operands.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/stop.h"
#include "ui/pipeline/inspection/face_samples.h"

namespace ui {

namespace {

using csg::Expression;
using csg::ExpressionKind;

class IdleOperands {
  public:
    IdleOperands(const Model& model, const SolidProbe& probe, const ExpressionLinks& links, Effects effects,
                 const csg::Box& box, const std::stop_token& stop)
        : scene_(model.scene),
          model_(model),
          probe_(probe),
          links_(links),
          effects_(std::move(effects)),
          box_(box),
          stop_(stop),
          ray_(probe, links) {
        std::vector<csg::Box> leaves;
        for (const auto& leaf : model.geometry.leaves) {
            leaves.push_back(leaf.box);
        }
        boxes_.resize(scene_.expressions.size());
        for (const csg::Part& part : scene_.parts) {
            const auto boxes = csg::expression_boxes(scene_, part, leaves);
            std::copy(boxes.begin(), boxes.end(), boxes_.begin() + part.first_expression);
        }
    }

    std::vector<Finding> find() {
        look_closely();
        std::vector<Finding> found;
        std::vector<char> told(scene_.expressions.size(), 0);
        for (csg::PartId id = 0; id < scene_.parts.size(); ++id) {
            const csg::Part& part = scene_.parts[id];
            if (part.kind != csg::PartKind::Solid && part.kind != csg::PartKind::Translucent) {
                continue;
            }
            for (std::uint32_t i = part.root + 1; i-- > part.first_expression;) {
                const std::uint32_t parent = links_.parent[i];
                told[i] = parent != ExpressionLinks::kNone ? told[parent] : '\0';
                const std::string text = told[i] == 0 ? fault(i, id) : "";
                if (!text.empty()) {
                    told[i] = 1;
                    found.push_back(finding(i, id, text));
                }
            }
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const Finding& a, const Finding& b) { return a.occurrence < b.occurrence; });
        return found;
    }

  private:
    [[nodiscard]] bool is_idle(std::uint32_t i) const {
        const bool root = links_.parent[i] == ExpressionLinks::kNone;
        return root ? holding_parts() > 1 && effects_.holds[i] != 0 && effects_.alone[links_.part[i]] == 0
                    : effects_.idle(links_, i);
    }

    [[nodiscard]] std::size_t holding_parts() const {
        return static_cast<std::size_t>(std::count_if(scene_.parts.begin(), scene_.parts.end(), [&](const auto& part) {
            return effects_.holds[part.root] != 0;
        }));
    }

    /// What is wrong with it; empty: nothing.
    [[nodiscard]] std::string fault(std::uint32_t i, csg::PartId id) const {
        if (effects_.emptied(links_, i)) {
            return scene_.expressions[i].kind == ExpressionKind::Intersection ? "nothing is left of the intersection"
                                                                              : "nothing is left of the difference";
        }
        if (!is_idle(i)) {
            return "";
        }
        const std::uint32_t parent = links_.parent[i];
        if (parent == ExpressionLinks::kNone) {
            return fmt::format("the part {} is wholly inside others", scene_.parts[id].name);
        }
        if (has_twin(i)) {
            return is_first_twin(i) ? "" : "the same solid is there twice";
        }
        if (boxes_[i].empty() || glm::any(glm::equal(boxes_[i].size(), glm::dvec3(0)))) {
            return "a solid without volume";
        }
        if (scene_.expressions[parent].kind == ExpressionKind::Intersection) {
            return "takes nothing away from the intersection";
        }
        return is_subtracted(links_, i) ? "subtracts nothing" : "is wholly inside others, and adds nothing";
    }

    [[nodiscard]] const csg::Node* node(std::uint32_t i) const {
        const csg::OccurrenceId occurrence = occurrence_of(i);
        return occurrence == csg::kNoOccurrence ? nullptr
                                                : &model_.tree->node(scene_.occurrences[outermost(occurrence, i)].node);
    }

    /// The child of the operation that the expression is an operand of: transformations are above the expression's own.
    [[nodiscard]] csg::OccurrenceId outermost(csg::OccurrenceId occurrence, std::uint32_t i) const {
        const std::uint32_t parent = links_.parent[i];
        const csg::OccurrenceId end =
            parent == ExpressionLinks::kNone ? csg::kNoOccurrence : scene_.expressions[parent].occurrence;
        csg::OccurrenceId at = occurrence;
        while (scene_.occurrences[at].parent != csg::kNoOccurrence && scene_.occurrences[at].parent != end) {
            at = scene_.occurrences[at].parent;
        }
        return scene_.occurrences[at].parent == end ? at : occurrence;
    }

    [[nodiscard]] csg::OccurrenceId occurrence_of(std::uint32_t i) const {
        const Expression& e = scene_.expressions[i];
        return e.kind == ExpressionKind::Leaf ? scene_.leaves[e.leaf].occurrence : e.occurrence;
    }

    template <typename Visit>
    void for_twins(std::uint32_t i, const Visit& visit) const {
        const csg::Node* const own = node(i);
        for (const std::uint32_t other : scene_.children(scene_.expressions[links_.parent[i]])) {
            const csg::Node* const theirs = other == i ? nullptr : node(other);
            if (own != nullptr && theirs != nullptr && own->hash == theirs->hash && boxes_[other] == boxes_[i]) {
                visit(other);
            }
        }
    }

    [[nodiscard]] bool has_twin(std::uint32_t i) const {
        bool twin = false;
        for_twins(i, [&](std::uint32_t) { twin = true; });
        return twin;
    }

    [[nodiscard]] bool is_first_twin(std::uint32_t i) const {
        bool first = true;
        for_twins(i, [&](std::uint32_t other) { first = first && i < other; });
        return first;
    }

    [[nodiscard]] Finding finding(std::uint32_t i, csg::PartId part, const std::string& text) const {
        Finding finding;
        finding.kind = FindingKind::NoEffect;
        finding.text = text;
        finding.part = part;
        finding.occurrence = occurrence_of(i);
        if (scene_.expressions[i].kind == ExpressionKind::Leaf) {
            finding.leaf = scene_.expressions[i].leaf;
        }
        finding.point = boxes_[i].empty() ? box_.center() : boxes_[i].center();
        return finding;
    }

    /// Samples, closer to each other, where what seems to do nothing could do something.
    void look_closely() {
        std::vector<std::uint32_t> doubtful;
        for (std::uint32_t i = 0; i < scene_.expressions.size(); ++i) {
            if (is_idle(i) || effects_.emptied(links_, i)) {
                doubtful.push_back(i);
            }
        }
        constexpr double kMost = 500'000, kEach = 10'000, kLeast = 500;
        const double samples = std::clamp(kMost / static_cast<double>(doubtful.size() + 1), kLeast, kEach);
        for (const std::uint32_t i : doubtful) {
            base::end_if_asked(stop_);
            if (is_idle(i) || effects_.emptied(links_, i)) {
                look_at(i, samples);
            }
        }
    }

    /// Where it could do something.
    [[nodiscard]] csg::Box region(std::uint32_t i) const {
        const std::uint32_t parent = links_.parent[i];
        csg::Box box = boxes_[i];
        if (parent != ExpressionLinks::kNone) {
            const Expression& above = scene_.expressions[parent];
            const auto children = scene_.children(above);
            if (above.kind == ExpressionKind::Difference) {
                box = csg::intersect(box, boxes_[children[0]]);
            } else if (above.kind == ExpressionKind::Intersection) {
                box = boxes_[children[children[0] == i ? 1 : 0]];  // Of what it should take something away from.
            }
        }
        return csg::intersect(box, box_);
    }

    void look_at(std::uint32_t i, double samples) {
        const csg::Box box = region(i);
        if (box.empty()) {
            return;
        }
        std::vector<glm::dvec3> corners, points;
        double area = 0;
        const auto for_triangles = [&](const auto& visit) {
            for (csg::LeafId leaf = 0; leaf < scene_.leaves.size(); ++leaf) {
                const csg::solid::PlacedLeaf& placed = model_.geometry.leaves[leaf];
                if (!overlap(placed.box, box)) {
                    continue;
                }
                for (std::uint32_t k = 0; k < placed.triangles.size(); ++k) {
                    const glm::uvec3& t = placed.triangles[k];
                    clip(placed.points[t.x], placed.points[t.y], placed.points[t.z], box, corners);
                    for (std::size_t c = 0; c < corners.size(); c += 3) {
                        visit(leaf, k, corners[c], corners[c + 1], corners[c + 2]);
                    }
                }
            }
        };
        for_triangles([&](csg::LeafId, std::uint32_t, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
            area += 0.5 * glm::length(glm::cross(b - a, c - a));
        });
        const double spacing = std::max(std::sqrt(area / samples), probe_.event());
        SolidProbe::Sides sides;
        for_triangles(
            [&](csg::LeafId leaf, std::uint32_t k, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
                points.clear();
                sample_triangle(a, b, c, spacing, leaf * 104729 + k, points);
                for (const glm::dvec3& point : points) {
                    probe_.sides_of(leaf, k, point, sides);
                    effects_.look(ray_.at(sides.front));
                    effects_.look(ray_.at(sides.behind));
                }
            });
    }

    const csg::Scene& scene_;
    const Model& model_;
    const SolidProbe& probe_;
    const ExpressionLinks& links_;
    Effects effects_;
    csg::Box box_;
    const std::stop_token& stop_;
    PartRay ray_;
    std::vector<csg::Box> boxes_;  ///< By expression.
};

}  // namespace

std::vector<Finding> idle_operands(const Model& model, const SolidProbe& probe, const ExpressionLinks& links,
                                   Effects effects, const csg::Box& box, const std::stop_token& stop) {
    return IdleOperands(model, probe, links, std::move(effects), box, stop).find();
}

}  // namespace ui
