#include "ui/pipeline/inspection/check.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include "base/parallel.h"
#include "ui/pipeline/inspection/clearance.h"
#include "ui/pipeline/inspection/face_check.h"
#include "ui/pipeline/inspection/face_samples.h"
#include "ui/pipeline/inspection/idle_operands.h"
#include "ui/pipeline/inspection/size_check.h"
#include "ui/pipeline/part_names.h"

namespace ui {

namespace {

constexpr double kSamples = 200'000;  ///< About so many, where nothing is said.
constexpr std::uint32_t kTrianglesAtOnce = 32;

/// Triangles of a leaf.
struct Share {
    csg::LeafId leaf;
    std::uint32_t begin, end;
};

bool is_checked(const csg::Part& part) {
    return part.kind == csg::PartKind::Solid || part.kind == csg::PartKind::Translucent;
}

class Checker {
  public:
    Checker(const Model& model, const CheckRequest& request, const std::stop_token& stop)
        : model_(model), request_(request), stop_(stop), probe_(model.scene, model.geometry), links_(model.scene) {
        const double room = 1e-9 * (1 + model.box.diagonal());
        box_ = {model.box.lo - room, model.box.hi + room};
        result_.spacing = request.spacing > 0 ? request.spacing : own_spacing();
        result_.reach = kSampleReach * result_.spacing;
    }

    CheckResult run() {
        const bool faces = request_.min_wall || request_.min_gap || request_.min_feature || request_.interference ||
                           request_.no_effect || request_.coincident || request_.max_overhang;
        Effects effects(model_.scene);
        if (faces) {
            look_at_faces(effects);
        }
        for (const Clearance& clearance : request_.clearances) {
            look_at(clearance);
        }
        if (request_.no_effect) {
            add(idle_operands(model_, probe_, links_, std::move(effects), box_, stop_));
        }
        add(size_findings(model_, request_, stop_));
        const auto order = [](const Finding& a, const Finding& b) {
            const bool most = a.kind == FindingKind::Interference || a.kind == FindingKind::Overhang;
            if (a.kind != b.kind || a.value == b.value) {
                return a.kind < b.kind;
            }
            return most ? a.value > b.value : a.value < b.value;
        };
        std::stable_sort(result_.findings.begin(), result_.findings.end(), order);
        return std::move(result_);
    }

  private:
    /// Calls visit(leaf, triangle, corners) for the triangles of what counts.
    template <typename Visit>
    void for_triangles(const Share& share, const Visit& visit) const {
        const csg::solid::PlacedLeaf& placed = model_.geometry.leaves[share.leaf];
        for (std::uint32_t i = share.begin; i < share.end; ++i) {
            const glm::uvec3& t = placed.triangles[i];
            visit(i, placed.points[t.x], placed.points[t.y], placed.points[t.z]);
        }
    }

    [[nodiscard]] std::vector<Share> shares() const {
        std::vector<Share> all;
        for (csg::LeafId leaf = 0; leaf < model_.scene.leaves.size(); ++leaf) {
            if (!is_checked(model_.scene.parts[model_.scene.leaves[leaf].part])) {
                continue;
            }
            const auto count = static_cast<std::uint32_t>(model_.geometry.leaves[leaf].triangles.size());
            for (std::uint32_t i = 0; i < count; i += kTrianglesAtOnce) {
                all.push_back({leaf, i, std::min(count, i + kTrianglesAtOnce)});
            }
        }
        return all;
    }

    /// So that there are about kSamples, in two digits.
    [[nodiscard]] double own_spacing() const {
        double area = 0;
        std::vector<glm::dvec3> corners;
        for (const Share& share : shares()) {
            for_triangles(share, [&](std::uint32_t, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
                clip(a, b, c, box_, corners);
                for (std::size_t i = 0; i < corners.size(); i += 3) {
                    area += 0.5 * glm::length(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]));
                }
            });
        }
        const double spacing = std::sqrt(area / kSamples);
        if (!(spacing > 0)) {
            return 1;
        }
        const double unit = std::pow(10.0, std::floor(std::log10(spacing)) - 1);
        return std::ceil(spacing / unit) * unit;
    }

    void look_at_faces(Effects& effects) {
        const std::vector<Share> all = shares();
        std::mutex mutex;
        FoundFaces found;
        const auto make = [&] {
            struct Worker {
                Checker& of;
                std::mutex& mutex;
                const std::vector<Share>& all;
                FoundFaces& found;
                Effects& effects;
                FaceCheck check;
                std::size_t samples = 0;
                std::vector<glm::dvec3> corners{}, points{};

                Worker(Checker& c, std::mutex& m, const std::vector<Share>& s, FoundFaces& f, Effects& e)
                    : of(c),
                      mutex(m),
                      all(s),
                      found(f),
                      effects(e),
                      check(c.probe_, c.links_, c.request_, c.result_.reach, c.model_.box.lo.z) {}
                Worker(Worker&&) = delete;
                ~Worker() {
                    const std::lock_guard lock(mutex);
                    for (const auto& [key, finding] : check.found()) {
                        keep_worst(found, key, finding);
                    }
                    effects.add(check.effects());
                    of.result_.samples += samples;
                }
                void operator()(int index) {
                    const Share& share = all[static_cast<std::size_t>(index)];
                    of.for_triangles(share, [&](std::uint32_t triangle, const auto& a, const auto& b, const auto& c) {
                        clip(a, b, c, of.box_, corners);
                        points.clear();
                        for (std::size_t i = 0; i < corners.size(); i += 3) {
                            sample_triangle(corners[i], corners[i + 1], corners[i + 2], of.result_.spacing,
                                            share.leaf * 7919 + triangle, points);
                        }
                        for (const glm::dvec3& point : points) {
                            check.look(share.leaf, triangle, point);
                        }
                        samples += points.size();
                    });
                }
            };
            return Worker(*this, mutex, all, found, effects);
        };
        base::for_each_index(static_cast<int>(all.size()), make, 0, stop_);
        result_.findings = worst_of(found, request_);
    }

    void look_at(const Clearance& clearance) {
        const auto a = parts_named(model_.scene, "--clearance", clearance.a),
                   b = parts_named(model_.scene, "--clearance", clearance.b);
        const auto found = distance_between(probe_, links_, a, b, clearance.least, result_.spacing / 8, stop_);
        if (!found) {
            return;
        }
        const csg::LeafInstance &leaf = model_.scene.leaves[found->leaf],
                                &other = model_.scene.leaves[found->other_leaf];
        Finding finding;
        finding.kind = FindingKind::Clearance;
        finding.value = found->distance;
        finding.error = found->error;
        finding.limit = clearance.least;
        finding.point = found->from;
        if (found->distance > 0) {
            finding.direction = (found->to - found->from) / found->distance;
        }
        finding.part = leaf.part;
        finding.other_part = other.part;
        finding.leaf = found->leaf;
        finding.other_leaf = found->other_leaf;
        finding.occurrence = leaf.occurrence;
        finding.other_occurrence = other.occurrence;
        result_.findings.push_back(finding);
    }

    void add(std::vector<Finding> findings) {
        std::move(findings.begin(), findings.end(), std::back_inserter(result_.findings));
    }

    const Model& model_;
    const CheckRequest& request_;
    const std::stop_token& stop_;
    SolidProbe probe_;
    ExpressionLinks links_;
    csg::Box box_;  ///< Of the model, with a little room.
    CheckResult result_;
};

}  // namespace

const std::array<FindingKindInfo, 9>& finding_kinds() {
    static constexpr std::array<FindingKindInfo, 9> kKinds{{
        {FindingKind::Wall, "min-wall", "thin wall"},
        {FindingKind::Gap, "min-gap", "narrow gap"},
        {FindingKind::Feature, "min-feature", "small feature"},
        {FindingKind::Interference, "interference", "parts run into each other"},
        {FindingKind::Clearance, "clearance", "parts too near to each other"},
        {FindingKind::NoEffect, "no-effect", "no effect"},
        {FindingKind::Coincident, "coincident", "coincident faces"},
        {FindingKind::Overhang, "max-overhang", "overhang"},
        {FindingKind::Size, "size", "size"},
    }};
    return kKinds;
}

CheckResult check(const Model& model, const CheckRequest& request, const std::stop_token& stop) {
    return Checker(model, request, stop).run();
}

}  // namespace ui
