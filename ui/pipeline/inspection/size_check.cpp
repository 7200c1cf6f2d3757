#include "ui/pipeline/inspection/size_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ui/pipeline/inspection/layer_measures.h"
#include "ui/pipeline/picture/exact_bounds.h"

namespace ui {

namespace {

constexpr double kFirstPrecision = 0.02, kLastPrecision = 1e-4;

/// As exact as it takes to tell on which side of the limits it is, or as can be.
BoundedValue volume_of(const Model& model, const CheckRequest& request, const std::stop_token& stop) {
    BoundedValue volume = measure_by_layers(model, kFirstPrecision, stop).all.volume;
    for (const auto& limit : {request.min_volume, request.max_volume}) {
        const double apart = limit ? std::abs(volume.value - *limit) : volume.error;
        if (apart < volume.error) {
            volume = measure_by_layers(model, std::max(kLastPrecision, 0.5 * apart / volume.value), stop).all.volume;
        }
    }
    return volume;
}

}  // namespace

std::vector<Finding> size_findings(const Model& model, const CheckRequest& request, const std::stop_token& stop) {
    std::vector<Finding> found;
    if (request.max_size) {
        const csg::Box box = exact_bounds(model, stop);
        for (int axis = 0; axis < 3; ++axis) {
            const double size = box.size()[axis], most = (*request.max_size)[axis];
            if (!box.empty() && size > most * (1 + 1e-12)) {
                Finding finding;
                finding.kind = FindingKind::Size;
                finding.text = fmt::format("too large along {}", "xyz"[axis]);
                finding.value = size;
                finding.error = 0x1p-20 * box.diagonal();
                finding.limit = most;
                finding.point = box.center();
                finding.point[axis] = box.lo[axis];
                glm::dvec3 direction(0.0);
                direction[axis] = 1;
                finding.direction = direction;
                found.push_back(finding);
            }
        }
    }
    if (request.min_volume || request.max_volume) {
        const BoundedValue volume = volume_of(model, request, stop);
        const auto tell = [&](const char* text, double limit) {
            Finding finding;
            finding.kind = FindingKind::Size;
            finding.text = text;
            finding.value = volume.value;
            finding.error = volume.error;
            finding.limit = limit;
            finding.point = model.box.center();
            found.push_back(finding);
        };
        if (request.max_volume && volume.value - volume.error > *request.max_volume) {
            tell("too large a volume", *request.max_volume);
        }
        if (request.min_volume && volume.value + volume.error < *request.min_volume) {
            tell("too small a volume", *request.min_volume);
        }
    }
    return found;
}

}  // namespace ui
