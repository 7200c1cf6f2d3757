#include "ui/pipeline/motion/bodies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace ui {

namespace {

/// Of the model's size: motions that differ by less are one.
constexpr double kAlike = 1e-9;

/// What a track does: the way in all samples, and whether it stays what it is.
struct PoseList {
    std::vector<std::optional<glm::dmat4>> motions;  ///< By sample.
    bool changes_shape = false;

    [[nodiscard]] bool still() const {
        return !changes_shape && std::all_of(motions.begin(), motions.end(),
                                             [&](const auto& m) { return m.has_value() && *m == *motions.front(); });
    }
};

bool alike(const PoseList& a, const PoseList& b, double size) {
    if (a.changes_shape != b.changes_shape) {
        return false;
    }
    for (std::size_t i = 0; i < a.motions.size(); ++i) {
        if (a.motions[i].has_value() != b.motions[i].has_value()) {
            return false;
        }
        for (int k = 0; k < 4 && a.motions[i]; ++k) {
            const glm::dvec4 apart = glm::abs((*a.motions[i])[k] - (*b.motions[i])[k]);
            if (std::max({apart.x, apart.y, apart.z}) > kAlike * (k < 3 ? 1 : size)) {
                return false;
            }
        }
    }
    return true;
}

class Grouping {
  public:
    Grouping(const Tracks& tracks, std::span<const TrackSample> samples, std::span<const TrackShape> shapes)
        : tracks_(tracks), samples_(samples), shapes_(shapes) {
        csg::Box all;
        for (const TrackShape& shape : shapes) {
            all = csg::enclose(all, shape.box);
        }
        size_ = std::max({1e-300, glm::length(all.size()), glm::length(all.empty() ? glm::dvec3(0.0) : all.lo)});
    }

    Bodies run() {
        Bodies result;
        std::vector<int> course_of;
        for (std::uint32_t t = 0; t < tracks_.all().size(); ++t) {
            course_of.push_back(course(t));
            result.still += course_of.back() == kStill ? 1 : 0;
        }
        for (std::size_t run = 0; run < tracks_.runs().size(); ++run) {
            find_bodies(run, course_of, result);
        }
        return result;
    }

  private:
    static constexpr int kStill = -1, kNothing = -2, kMixed = -3;

    /// Its number, the same for tracks that move alike.
    int course(std::uint32_t track) {
        PoseList c;
        const TrackMotion motion(tracks_, track, samples_);
        std::optional<std::uint64_t> shape;
        for (const TrackSample& sample : samples_) {
            c.motions.push_back(motion.in(sample));
            if (c.motions.back()) {
                c.changes_shape = c.changes_shape || (shape && *shape != sample.shapes[track]);
                shape = sample.shapes[track];
            }
        }
        if (c.still()) {
            return kStill;
        }
        const auto found = std::find_if(courses_.begin(), courses_.end(),
                                        [&](const PoseList& other) { return alike(c, other, size_); });
        const auto number = static_cast<int>(found - courses_.begin());
        if (found == courses_.end()) {
            courses_.push_back(std::move(c));
        }
        return number;
    }

    void find_bodies(std::size_t run, const std::vector<int>& course_of, Bodies& result) {
        const auto& [tree, scene, track_of] = tracks_.runs()[run];
        std::vector<int> below(scene.occurrences.size(), kNothing);
        std::vector<std::uint32_t> track_at(scene.occurrences.size(), kAbsent);  // One that is there first here.
        std::vector<csg::Box> box(scene.occurrences.size());
        for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
            const csg::OccurrenceId o = scene.leaves[leaf].occurrence;
            const std::uint32_t track = track_of[leaf];
            if (o == csg::kNoOccurrence) {
                continue;
            }
            below[o] = course_of[track];
            if (tracks_.all()[track].first_run == run) {
                track_at[o] = track;
                box[o] = csg::enclose(box[o], shapes_[track].box);
            }
        }
        for (std::size_t o = scene.occurrences.size(); o-- > 1;) {
            const csg::OccurrenceId parent = scene.occurrences[o].parent;
            if (parent == csg::kNoOccurrence || below[o] == kNothing) {
                continue;
            }
            below[parent] = below[parent] == kNothing || below[parent] == below[o] ? below[o] : kMixed;
            track_at[parent] = std::min(track_at[parent], track_at[o]);
            box[parent] = csg::enclose(box[parent], box[o]);
        }
        for (csg::OccurrenceId o = 0; o < scene.occurrences.size(); ++o) {
            const csg::OccurrenceId parent = scene.occurrences[o].parent;
            const bool top = parent == csg::kNoOccurrence || below[parent] == kMixed;
            if (below[o] >= 0 && top && track_at[o] != kAbsent) {
                add_body(run, o, courses_[static_cast<std::size_t>(below[o])], track_at[o], box[o], result);
            }
        }
    }

    void add_body(std::size_t run, csg::OccurrenceId top, const PoseList& course, std::uint32_t track,
                  const csg::Box& box, Bodies& result) {
        MovingBody body;
        body.box = box;
        body.changes_shape = course.changes_shape;
        name(run, top, body);
        describe(run, top, track, body);
        const glm::dvec3 center = box.empty() ? glm::dvec3(0.0) : 0.5 * (box.lo + box.hi);
        for (const auto& motion : course.motions) {
            auto& pose = body.poses.emplace_back();
            if (motion) {
                pose = Pose{*motion, glm::dvec3(*motion * glm::dvec4(center, 1)), {}, {}, {}};
            }
        }
        result.bodies.push_back(std::move(body));
        result.tracks.push_back(track);
    }

    void describe(std::size_t run, csg::OccurrenceId top, std::uint32_t track, MovingBody& body) const {
        const auto& [tree, scene, track_of] = tracks_.runs()[run];
        body.tree = tree;
        body.top = scene.occurrences[top].node;
        for (csg::OccurrenceId o = scene.occurrences[top].parent; o != csg::kNoOccurrence;
             o = scene.occurrences[o].parent) {
            if (tree->node(scene.occurrences[o].node).operation == csg::Operation::Transform) {
                body.to_world = tree->matrix(scene.occurrences[o].node) * body.to_world;
            }
        }
        body.color = scene.leaves[tracks_.all()[track].leaf].color;
        const std::vector<glm::dvec3>& directions = extreme_directions();
        std::vector<double> reach(directions.size(), -INFINITY);
        body.extremes.resize(directions.size());
        for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
            if (!is_below(scene, leaf, top)) {
                continue;
            }
            body.leaves.push_back(leaf);
            const std::vector<glm::dvec3>& extremes = shapes_[track_of[leaf]].extremes;
            if (extremes.empty() || tracks_.all()[track_of[leaf]].first_run != run) {
                continue;
            }
            for (std::size_t i = 0; i < directions.size(); ++i) {
                if (const double far = glm::dot(extremes[i], directions[i]); far > reach[i]) {
                    reach[i] = far;
                    body.extremes[i] = extremes[i];
                }
            }
        }
        if (reach.front() == -INFINITY) {
            body.extremes.clear();
        }
    }

    static bool is_below(const csg::Scene& scene, csg::LeafId leaf, csg::OccurrenceId top) {
        csg::OccurrenceId o = scene.leaves[leaf].occurrence;
        while (o != csg::kNoOccurrence && o > top) {  // Parents stand before their children.
            o = scene.occurrences[o].parent;
        }
        return o == top;
    }

    /// After the first module of the user's on the way down to where it branches; else after the last call there.
    void name(std::size_t run, csg::OccurrenceId top, MovingBody& body) {
        const csg::Tree& tree = *tracks_.runs()[run].tree;
        csg::NodeId node = tracks_.runs()[run].scene.occurrences[top].node;
        body.where = tree.node(node).where;
        std::string name = "model";
        for (;;) {
            const csg::Statement* call = tree.statement(node);
            name = call != nullptr ? call->name : name;
            if ((call != nullptr && call->user_module) || tree.children(node).empty()) {
                break;
            }
            node = tree.children(node).front();
        }
        const int count = ++names_[name];
        body.name = count == 1 ? name : name + " " + std::to_string(count);
    }

    const Tracks& tracks_;
    std::span<const TrackSample> samples_;
    std::span<const TrackShape> shapes_;
    double size_;
    std::vector<PoseList> courses_;
    std::map<std::string, int> names_;
};

}  // namespace

TrackMotion::TrackMotion(const Tracks& tracks, std::uint32_t track, std::span<const TrackSample> samples)
    : tracks_(tracks), track_(track) {
    for (const TrackSample& sample : samples) {
        if (track < sample.placements.size() && sample.placements[track] != kAbsent) {
            first_ = sample.placements[track];
            break;
        }
    }
    if (first_ != kAbsent && glm::determinant(glm::dmat3(tracks.placement(first_))) != 0) {
        inverse_ = glm::inverse(tracks.placement(first_));
    }
}

std::optional<glm::dmat4> TrackMotion::in(const TrackSample& sample) const {
    if (track_ >= sample.placements.size() || sample.placements[track_] == kAbsent) {
        return {};
    }
    const std::uint32_t placement = sample.placements[track_];
    if (placement == first_) {
        return glm::dmat4(1.0);
    }
    return tracks_.placement(placement) * inverse_;
}

const std::vector<glm::dvec3>& extreme_directions() {
    static const std::vector<glm::dvec3> directions = [] {
        std::vector<glm::dvec3> all;
        constexpr int kCount = 64;  // On a spiral over the sphere, evenly.
        for (int i = 0; i < kCount; ++i) {
            const double z = 1 - (2 * i + 1.0) / kCount, r = std::sqrt(1 - z * z), angle = i * 2.399963229728653;
            all.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        }
        return all;
    }();
    return directions;
}

Bodies bodies_of(const Tracks& tracks, std::span<const TrackSample> samples, std::span<const TrackShape> shapes) {
    return Grouping(tracks, samples, shapes).run();
}

}  // namespace ui
