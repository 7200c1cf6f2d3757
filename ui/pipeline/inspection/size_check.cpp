#include "ui/pipeline/inspection/size_check.h"

#include <fmt/format.h>

#include "base/camera.h"
#include "base/stop.h"
#include "goldfeather/lists_cpu/lists_cpu.h"
#include "ui/pipeline/comparison/layer_volume.h"
#include "ui/pipeline/comparison/solid_scene.h"
#include "ui/pipeline/picture/exact_bounds.h"

namespace ui {

namespace {

/// Along the axis where the least may lie between the rays.
LayerVolume volume_of(const Model& model, const std::stop_token& stop) {
    const SolidScene solid = solid_scene(model.scene, model.geometry);
    LayerVolume best;
    bool known = false;
    constexpr int kSide = 1024;
    for (const glm::dvec3& rotation : {glm::dvec3(0, 0, 0), glm::dvec3(90, 0, 0), glm::dvec3(90, 0, 90)}) {
        base::end_if_asked(stop);
        base::Camera camera;
        camera.projection = base::Projection::Orthographic;
        camera.rotation = rotation;
        base::view_all(camera, model.box.lo, model.box.hi, true);
        const base::View view(camera, {kSide, kSide}, solid.geometry.box.lo, solid.geometry.box.hi);
        const LayerVolume seen = layer_volume(goldfeather::peel_to_host(solid.scene, solid.geometry, view), view);
        if (!known || seen.uncertainty < best.uncertainty) {
            best = seen;
            known = true;
        }
    }
    return best;
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
        const LayerVolume volume = volume_of(model, stop);
        const auto tell = [&](const char* text, double limit) {
            Finding finding;
            finding.kind = FindingKind::Size;
            finding.text = text;
            finding.value = volume.volume;
            finding.error = volume.uncertainty;
            finding.limit = limit;
            finding.point = model.box.center();
            found.push_back(finding);
        };
        if (request.max_volume && volume.volume - volume.uncertainty > *request.max_volume) {
            tell("too large a volume", *request.max_volume);
        }
        if (request.min_volume && volume.volume + volume.uncertainty < *request.min_volume) {
            tell("too small a volume", *request.min_volume);
        }
    }
    return found;
}

}  // namespace ui
