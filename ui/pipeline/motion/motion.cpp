#include "ui/pipeline/motion/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <stdexcept>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/solid/placed.h"
#include "ui/pipeline/mesh/exact_operations.h"
#include "ui/pipeline/motion/bodies.h"
#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/rigid_motion.h"
#include "ui/pipeline/motion/tracks.h"

namespace ui {

namespace {

/// Where an interval is cut: not in the middle, so that what repeats itself within it is not taken for still.
constexpr double kCut = 0.41421356;
constexpr int kFirstIntervals = 16;
/// Of the time: events are no longer narrowed down.
constexpr double kShortest = 0x1p-20;
/// Of the time: steps of the differences that derivatives are made of.
constexpr double kStep = 0x1p-10;

/// Runs the program, and says how far what it shows is apart.
class Sampler {
  public:
    Sampler(const TreeAtTime& tree_at, const std::stop_token& stop) : tree_at_(tree_at), stop_(stop) {}

    TrackSample at(double time) {
        base::end_if_asked(stop_);
        auto tree = tree_at_(time);
        if (tree == nullptr) {
            throw std::runtime_error(fmt::format("there is no model at $t = {:.17g}", time));
        }
        const std::size_t runs = tracks.runs().size();
        TrackSample sample = tracks.add(time, std::move(tree));
        if (tracks.runs().size() > runs) {
            place(tracks.runs().back());
        }
        return sample;
    }

    /// The largest way of a corner of a track's box between where two placements put it.
    [[nodiscard]] double distance(std::uint32_t track, const glm::dmat4& a, const glm::dmat4& b) const {
        return farthest_apart(local_boxes_[track], a, b);
    }

    Tracks tracks;
    std::vector<TrackShape> shapes;  ///< By track.

  private:
    void place(const Tracks::Run& run) {
        const csg::solid::Geometry geometry = csg::solid::place(*run.tree, run.scene, solids_, 1, stop_);
        for (std::size_t t = shapes.size(); t < tracks.all().size(); ++t) {
            const csg::LeafId leaf = tracks.all()[t].leaf;
            shapes.push_back({geometry.leaves[leaf].box, extremes_of(geometry.leaves[leaf].points)});
            csg::Box local;
            if (geometry.leaves[leaf].solid != nullptr) {
                for (const glm::dvec3& p : geometry.leaves[leaf].solid->points) {
                    local = csg::enclose(local, p);
                }
            }
            local_boxes_.push_back(local);
        }
    }

    static std::vector<glm::dvec3> extremes_of(const std::vector<glm::dvec3>& points) {
        std::vector<glm::dvec3> result;
        for (const glm::dvec3& d : extreme_directions()) {
            const auto far = std::max_element(
                points.begin(), points.end(),
                [&](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, d) < glm::dot(b, d); });
            if (far != points.end()) {
                result.push_back(*far);
            }
        }
        return result;
    }

    const TreeAtTime& tree_at_;
    const std::stop_token& stop_;
    csg::solid::SolidCache solids_{exact_operations()};
    std::vector<csg::Box> local_boxes_;  ///< By track: in its own coordinates.
};

std::uint32_t placement_of(const TrackSample& sample, std::size_t track) {
    return track < sample.placements.size() ? sample.placements[track] : kAbsent;
}

class Search {
  public:
    Search(const TreeAtTime& tree_at, const MotionRequest& request, const std::stop_token& stop)
        : sampler_(tree_at, stop), request_(request) {}

    Motion run() {
        const double length = request_.to - request_.from;
        for (int i = 0; i <= kFirstIntervals; ++i) {
            // Unevenly, so that whole turns between them are not taken for rest.
            const double aside = i % kFirstIntervals == 0 ? 0 : 0.3 * (std::fmod(i * 0.6180339887, 1.0) - 0.5);
            samples_.push_back(sampler_.at(
                i == kFirstIntervals ? request_.to : request_.from + length * (i + aside) / kFirstIntervals));
        }
        tolerance_ = request_.error ? *request_.error : 1e-4 * std::max(diagonal(), 1e-300);
        refine();
        std::sort(samples_.begin(), samples_.end(),
                  [](const TrackSample& a, const TrackSample& b) { return a.time < b.time; });
        Bodies found = bodies_of(sampler_.tracks, samples_, sampler_.shapes);
        Motion motion{sampler_.tracks.runs().front().tree, {}, std::move(found.bodies), {}, {}, error_, complete_};
        motion.leaves = sampler_.tracks.all().size();
        motion.still = found.still;
        for (const TrackSample& sample : samples_) {
            motion.times.push_back(sample.time);
        }
        find_events(motion);
        if (request_.derivatives) {
            add_derivatives(motion, found.tracks);
        }
        return motion;
    }

  private:
    struct Interval {
        std::size_t from, to;  ///< Into samples_.
    };

    [[nodiscard]] double diagonal() const {
        csg::Box all;
        for (const TrackShape& shape : sampler_.shapes) {
            all = csg::enclose(all, shape.box);
        }
        return all.empty() ? 0 : all.diagonal();
    }

    void refine() {
        std::deque<Interval> open;
        for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
            open.push_back({i, i + 1});
        }
        while (!open.empty()) {
            const Interval interval = open.front();
            open.pop_front();
            const double a = samples_[interval.from].time, b = samples_[interval.to].time;
            if (samples_.size() >= request_.most_samples) {
                complete_ = false;
                return;
            }
            const std::size_t middle = samples_.size();
            samples_.push_back(sampler_.at(a + (b - a) * kCut));
            const double error = error_of(interval, middle);
            const bool again = error > tolerance_ && b - a > kShortest * (request_.to - request_.from);
            if (again) {
                open.push_back({interval.from, middle});
                open.push_back({middle, interval.to});
            } else if (error <= tolerance_) {
                error_ = std::max(error_, error);
            }
        }
    }

    /// How far what is between the ends is from where the screws between them have it; infinite where what is there
    /// differs.
    [[nodiscard]] double error_of(const Interval& interval, std::size_t middle) const {
        const TrackSample &a = samples_[interval.from], &b = samples_[interval.to], &m = samples_[middle];
        const double share = (m.time - a.time) / (b.time - a.time);
        double most = 0;
        for (std::uint32_t t = 0; t < sampler_.tracks.all().size(); ++t) {
            const std::uint32_t pa = placement_of(a, t), pb = placement_of(b, t), pm = placement_of(m, t);
            if (pa == pb && pa == pm) {
                continue;
            }
            if (pa == kAbsent || pb == kAbsent || pm == kAbsent) {
                return INFINITY;
            }
            const auto& all = sampler_.tracks;
            most = std::max(
                most, sampler_.distance(t, all.placement(pm), between(all.placement(pa), all.placement(pb), share)));
        }
        return most;
    }

    /// What is left between neighbors as near as they come.
    void find_events(Motion& motion) const {
        for (MovingBody& body : motion.bodies) {
            for (std::size_t i = 0; i + 1 < motion.times.size(); ++i) {
                const auto &a = body.poses[i], &b = body.poses[i + 1];
                MotionEvent event{MotionEvent::Kind::Jumps, motion.times[i], motion.times[i + 1], 0};
                if (a.has_value() != b.has_value()) {
                    event.kind = a ? MotionEvent::Kind::Vanishes : MotionEvent::Kind::Appears;
                    body.events.push_back(event);
                } else if (a &&
                           motion.times[i + 1] - motion.times[i] <= 2 * kShortest * (request_.to - request_.from)) {
                    event.distance = farthest_apart(body.box, a->motion, b->motion);
                    if (event.distance > tolerance_) {
                        body.events.push_back(event);
                    }
                }
            }
        }
    }

    [[nodiscard]] bool is_smooth(const MovingBody& body, double from, double to) const {
        return std::none_of(body.events.begin(), body.events.end(),
                            [&](const MotionEvent& event) { return event.before >= from && event.after <= to; });
    }

    /// Differences of five runs each, in the middle or, at either end of the time, to one side: off by the fourth power
    /// of the step, accelerations at the ends by its third.
    void add_derivatives(Motion& motion, const std::vector<std::uint32_t>& track_of) {
        const double h = kStep * (request_.to - request_.from);
        for (std::size_t i = 0; i < motion.times.size(); ++i) {
            const double t = motion.times[i];
            const bool last = t + 2 * h > request_.to, side = last || t - 2 * h < request_.from;
            const double step = last ? -h : h, begin = side ? t : t - 2 * h;
            std::vector<TrackSample> runs;
            runs.reserve(5);
            for (int k = 0; k < 5; ++k) {
                runs.push_back(sampler_.at(begin + k * step));
            }
            for (std::size_t b = 0; b < motion.bodies.size(); ++b) {
                MovingBody& body = motion.bodies[b];
                if (body.poses[i] &&
                    is_smooth(body, std::min(begin, begin + 4 * step), std::max(begin, begin + 4 * step))) {
                    derive(TrackMotion(sampler_.tracks, track_of[b], samples_), runs, side, step, body.box,
                           *body.poses[i]);
                }
            }
        }
    }

    static void derive(const TrackMotion& motion, const std::vector<TrackSample>& runs, bool side, double step,
                       const csg::Box& box, Pose& pose) {
        constexpr std::array<double, 5> kMiddle{1, -8, 0, 8, -1}, kMiddle2{-1, 16, -30, 16, -1};
        constexpr std::array<double, 5> kSide{-25, 48, -36, 16, -3}, kSide2{35, -104, 114, -56, 11};
        glm::dmat4 first(0.0), second(0.0);
        for (std::size_t k = 0; k < 5; ++k) {
            const auto at = motion.in(runs[k]);
            if (!at) {
                return;
            }
            first += (side ? kSide : kMiddle)[k] * *at;
            second += (side ? kSide2 : kMiddle2)[k] * *at;
        }
        const glm::dvec4 center(box.empty() ? glm::dvec3(0.0) : 0.5 * (box.lo + box.hi), 1);
        first /= 12 * step;
        pose.velocity = glm::dvec3(first * center);
        pose.acceleration = glm::dvec3(second * center) / (12 * step * step);
        pose.turning = turning_of(first, pose.motion);
    }

    /// The derivative of a turn, times its inverse, is skew: its entries are the axis times the rate.
    static std::optional<glm::dvec3> turning_of(const glm::dmat4& change, const glm::dmat4& motion) {
        if (!screw_of(motion)) {
            return {};
        }
        const glm::dmat3 skew = glm::dmat3(change) * glm::transpose(glm::dmat3(motion));
        return 0.5 * glm::dvec3(skew[1][2] - skew[2][1], skew[2][0] - skew[0][2], skew[0][1] - skew[1][0]);
    }

    Sampler sampler_;
    const MotionRequest& request_;
    std::vector<TrackSample> samples_;
    double tolerance_ = 0, error_ = 0;
    bool complete_ = true;
};

}  // namespace

Motion find_motion(const TreeAtTime& tree_at, const MotionRequest& request, const std::stop_token& stop) {
    return Search(tree_at, request, stop).run();
}

}  // namespace ui
