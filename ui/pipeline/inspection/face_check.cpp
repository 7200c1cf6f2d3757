#include "ui/pipeline/inspection/face_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include <fmt/format.h>

#include "ui/pipeline/infinity.h"

namespace ui {

namespace {

double cosine_of(double degrees) {
    return std::cos(glm::radians(degrees));
}

/// Larger is worse.
double badness(const Finding& finding) {
    const bool most = finding.kind == FindingKind::Interference || finding.kind == FindingKind::Overhang;
    return finding.value ? (most ? *finding.value : -*finding.value) : 0;
}

bool holds(const std::vector<csg::PartId>& parts, csg::PartId part) {
    return std::binary_search(parts.begin(), parts.end(), part);
}

}  // namespace

void keep_worst(FoundFaces& found, const FindingKey& key, const Finding& finding) {
    const auto [at, added] = found.try_emplace(key, finding);
    if (added) {
        return;
    }
    const std::size_t samples = at->second.samples + finding.samples;
    const auto order = [](const Finding& f) { return std::tuple(-badness(f), f.point.x, f.point.y, f.point.z); };
    if (order(finding) < order(at->second)) {
        at->second = finding;
    }
    at->second.samples = samples;
}

std::vector<Finding> worst_of(const FoundFaces& found, const CheckRequest& request) {
    std::vector<Finding> result;
    std::map<std::uint64_t, Finding> by_parts;
    for (const auto& [key, finding] : found) {
        if (finding.kind != FindingKind::Interference) {
            result.push_back(finding);
            continue;
        }
        const auto [at, added] = by_parts.try_emplace(key.a, finding);
        const std::size_t samples = added ? finding.samples : at->second.samples + finding.samples;
        if (*finding.value < *at->second.value) {
            at->second = finding;
        }
        at->second.samples = samples;
    }
    for (const auto& [parts, finding] : by_parts) {
        if (*finding.value > *request.interference) {
            result.push_back(finding);
        }
    }
    return result;
}

FaceCheck::FaceCheck(const SolidProbe& probe, const ExpressionLinks& links, const CheckRequest& request, double reach,
                     double lowest)
    : probe_(probe),
      request_(request),
      reach_(reach),
      lowest_(lowest),
      effects_(probe.scene()),
      ray_(probe, links),
      other_(probe, links) {}

std::uint64_t FaceCheck::surface(csg::LeafId leaf, std::uint32_t triangle) const {
    const csg::solid::PlacedLeaf& placed = probe_.geometry().leaves[leaf];
    const auto groups = csg::solid::groups_of(placed);
    constexpr std::uint64_t kPlane = std::uint64_t{1} << 31U;  // No group has it.
    const std::uint64_t number =
        groups.empty() ? kPlane | placed.planes[triangle].index : std::uint64_t{groups[triangle].surface()};
    return std::uint64_t{leaf} << 32U | number;
}

Finding FaceCheck::at(FindingKind kind, const Place& place) const {
    const csg::LeafInstance& leaf = probe_.scene().leaves[place.leaf];
    Finding finding;
    finding.kind = kind;
    finding.point = place.point;
    finding.part = leaf.part;
    finding.leaf = place.leaf;
    finding.occurrence = leaf.occurrence;
    finding.samples = 1;
    return finding;
}

void FaceCheck::opposite(Finding& finding, const PartRay::Hit& hit) const {
    finding.other_leaf = hit.leaf;
    finding.other_part = hit.part;
    finding.other_occurrence = probe_.scene().leaves[hit.leaf].occurrence;
}

void FaceCheck::add(const Finding& finding, std::uint64_t a, std::uint64_t b) {
    keep_worst(found_, {finding.kind, std::min(a, b), std::max(a, b)}, finding);
}

/// Between two planes at an angle, what is measured changes by its tangent from place to place.
double FaceCheck::error_of(double cosine) const {
    const double c = std::min(cosine, 1.0);
    return c > 1 - 1e-12 ? probe_.event() : reach_ * std::sqrt(1 - c * c) / c + probe_.event();
}

void FaceCheck::look(csg::LeafId leaf, std::uint32_t triangle, const glm::dvec3& point) {
    const glm::dvec3 normal = probe_.normal(leaf, triangle);
    const csg::PartId part = probe_.scene().leaves[leaf].part;
    probe_.sides_of(leaf, triangle, point, sides_);
    const PointValues& front = ray_.at(sides_.front);
    const PointValues& behind = other_.at(sides_.behind);
    if (request_.no_effect) {
        effects_.look(front);
        effects_.look(behind);
    }
    const bool in_front = front.in_part(part), in_behind = behind.in_part(part);
    const bool free_before = front.parts().empty(), free_behind = behind.parts().empty();
    if (request_.coincident && sides_.met.size() > 1) {
        look_at_contacts(leaf, triangle, point, normal, in_front, in_behind);
    }
    if (in_front == in_behind) {
        return;
    }
    const Place place{leaf,
                      triangle,
                      point,
                      in_behind ? normal : -normal,
                      in_behind ? &sides_.behind : &sides_.front,
                      in_behind ? &sides_.front : &sides_.behind};
    const bool free = in_behind ? free_before : free_behind;
    if (request_.min_wall) {
        look_at_wall(place);
    }
    if (request_.min_gap && free) {
        look_at_gap(place);
    }
    if (request_.min_feature) {
        look_at_feature(place, true);
        if (free) {
            look_at_feature(place, false);
        }
    }
    if (request_.interference) {
        look_at_interference(place);
    }
    if (request_.max_overhang) {
        look_at_overhang(place);
    }
}

void FaceCheck::look_at_wall(const Place& place) {
    Finding finding = at(FindingKind::Wall, place);
    const auto hit = ray_.leave(*finding.part, place.point, -place.outwards, *place.inside, *request_.min_wall);
    if (!hit || hit->cosine < cosine_of(kOppositeDegrees)) {
        return;
    }
    finding.value = hit->distance;
    finding.limit = request_.min_wall;
    finding.error = error_of(hit->cosine);
    finding.direction = -place.outwards;
    opposite(finding, *hit);
    add(finding, surface(place.leaf, place.triangle), surface(hit->leaf, hit->triangle));
}

void FaceCheck::look_at_gap(const Place& place) {
    const auto hit = ray_.enter(place.point, place.outwards, *place.outside, *request_.min_gap);
    if (!hit || hit->cosine < cosine_of(kOppositeDegrees)) {
        return;
    }
    Finding finding = at(FindingKind::Gap, place);
    finding.value = hit->distance;
    finding.limit = request_.min_gap;
    finding.error = error_of(hit->cosine);
    finding.direction = place.outwards;
    opposite(finding, *hit);
    add(finding, surface(place.leaf, place.triangle), surface(hit->leaf, hit->triangle));
}

void FaceCheck::look_at_feature(const Place& place, bool solid) {
    const csg::PartId part = probe_.scene().leaves[place.leaf].part;
    const double most = *request_.min_feature, opposed = cosine_of(kOppositeSidesDegrees);
    const glm::dvec3 into = solid ? -place.outwards : place.outwards;
    const auto go = [&](const glm::dvec3& from, const glm::dvec3& to, const Covers& covers, double length) {
        return solid ? ray_.leave(part, from, to, covers, length) : ray_.enter(from, to, covers, length);
    };
    const auto across = go(place.point, into, solid ? *place.inside : *place.outside, most);
    if (!across || across->cosine < opposed) {
        return;
    }
    const glm::dvec3 middle = place.point + 0.5 * across->distance * into;
    const glm::dvec3 aside =
        glm::normalize(glm::cross(into, std::abs(into.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
    const glm::dvec3 other = glm::cross(into, aside);
    probe_.sides(middle, aside, middle_);
    constexpr int kDirections = 8;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = std::numbers::pi * i / kDirections;
        const glm::dvec3 to = std::cos(angle) * aside + std::sin(angle) * other;
        const auto one = go(middle, to, middle_.front, most);
        if (!one || one->cosine < opposed) {
            continue;
        }
        const auto back = go(middle, -to, middle_.front, most - one->distance);
        if (!back || back->cosine < opposed) {
            continue;
        }
        const double width = one->distance + back->distance;
        Finding finding = at(FindingKind::Feature, place);
        finding.text = fmt::format("{}, {:.4g} by {:.4g} across", solid ? "pin" : "hole", across->distance, width);
        finding.value = std::min(across->distance, width);
        finding.limit = most;
        finding.error = error_of(across->cosine);
        finding.direction = into;
        opposite(finding, *across);
        add(finding, std::uint64_t{place.leaf} << 32U, std::uint64_t{across->leaf} << 32U);
        return;
    }
}

void FaceCheck::look_at_interference(const Place& place) {
    const std::vector<csg::PartId> parts = ray_.at(*place.inside).parts();
    const csg::PartId part = probe_.scene().leaves[place.leaf].part;
    for (const csg::PartId other : parts) {
        if (other == part) {
            continue;
        }
        const auto out = ray_.leave(part, place.point, -place.outwards, *place.inside, kInfinity);
        const auto beyond = ray_.leave(other, place.point, -place.outwards, *place.inside, kInfinity);
        if (!out || !beyond) {
            continue;
        }
        const auto& hit = out->distance < beyond->distance ? out : beyond;
        if (hit->distance <= 8 * probe_.event()) {
            continue;
        }
        Finding finding = at(FindingKind::Interference, place);
        finding.value = hit->distance;
        finding.limit = request_.interference;
        finding.error = error_of(std::max(hit->cosine, 0.1));
        finding.direction = -place.outwards;
        opposite(finding, *hit);
        finding.other_part = other;
        const std::uint64_t low = std::min(part, other), high = std::max(part, other);
        keep_worst(found_, {finding.kind, low << 32U | high, surface(place.leaf, place.triangle)}, finding);
    }
}

void FaceCheck::look_at_overhang(const Place& place) {
    const double degrees = glm::degrees(std::asin(std::clamp(-place.outwards.z, -1.0, 1.0)));
    if (degrees <= *request_.max_overhang + 1e-9) {
        return;
    }
    if (place.point.z - lowest_ <= 8 * probe_.event()) {
        return;  // On the bed.
    }
    Finding finding = at(FindingKind::Overhang, place);
    finding.value = degrees;
    finding.limit = request_.max_overhang;
    add(finding, surface(place.leaf, place.triangle), 0);
}

void FaceCheck::look_at_contacts(csg::LeafId leaf, std::uint32_t triangle, const glm::dvec3& point,
                                 const glm::dvec3& normal, bool in_front, bool behind) {
    const csg::Scene& scene = probe_.scene();
    const csg::PartId part = scene.leaves[leaf].part;
    for (const Crossing& met : sides_.met) {
        const csg::PartId met_part = scene.leaves[met.leaf].part;
        if (met.leaf == leaf) {
            continue;
        }
        const bool faces = met.step > 0;  // The other begins where this one ends.
        Finding finding = at(FindingKind::Coincident, {leaf, triangle, point, normal, nullptr, nullptr});
        finding.other_leaf = met.leaf;
        finding.other_part = met_part;
        finding.other_occurrence = scene.leaves[met.leaf].occurrence;
        if (faces && met_part == part && in_front && behind) {
            less_.clear();
            std::set_intersection(sides_.front.begin(), sides_.front.end(), sides_.behind.begin(), sides_.behind.end(),
                                  std::back_inserter(less_),
                                  [](const Cover& a, const Cover& b) { return a.leaf < b.leaf; });
            if (ray_.at(less_).in_part(part)) {
                continue;  // Something else joins them.
            }
            finding.text = "two solids of one part touch in a face, and do not overlap";
        } else if (faces && met_part != part && behind && !in_front) {
            if (!holds(ray_.at(sides_.front).parts(), met_part) || holds(other_.at(sides_.behind).parts(), met_part)) {
                continue;
            }
            finding.text = "two parts touch in a face";
        } else if (!faces && met_part == part && !in_front && !behind) {
            less_ = sides_.behind;
            std::erase_if(less_, [&](const Cover& cover) { return cover.leaf == met.leaf; });
            if (!ray_.at(less_).in_part(part)) {
                continue;
            }
            finding.text = "what is subtracted ends just in the face of what it is subtracted from";
        } else {
            continue;
        }
        add(finding, std::uint64_t{leaf} << 32U, std::uint64_t{met.leaf} << 32U);
    }
}

}  // namespace ui
