#include "ui/pipeline/picture/camera.h"

#include <cmath>

namespace ui {

namespace {

bool given(const csg::scad::ViewSettings& file) {
    return file.translation || file.rotation || file.distance || file.fov;
}

}  // namespace

bool needs_box(const CameraRequest& request, const csg::scad::ViewSettings& file) {
    return request.view_all || request.margin || request.autocenter || !(request.camera || given(file));
}

base::Camera choose_camera(const CameraRequest& request, const csg::scad::ViewSettings& file, const csg::Box& box) {
    base::Camera camera = request.camera.value_or(base::Camera{});
    bool view_all = request.view_all;
    bool autocenter = request.autocenter;
    if (!request.camera) {
        const bool by_file = given(file);
        view_all |= !by_file;
        autocenter |= !by_file;
        if (file.translation) {
            camera.target = {(*file.translation)[0], (*file.translation)[1], (*file.translation)[2]};
        }
        if (file.rotation) {
            camera.rotation = {(*file.rotation)[0], (*file.rotation)[1], (*file.rotation)[2]};
        }
        // Values that no camera can have are as if not given.
        if (file.distance && std::isfinite(*file.distance) && *file.distance > 0) {
            camera.distance = *file.distance;
        }
        if (file.fov && *file.fov > 0 && *file.fov < 180) {
            camera.fov = *file.fov;
        }
    }
    camera.projection = request.projection;
    if (request.margin) {
        base::view_tight(camera, box.lo, box.hi, request.aspect, *request.margin, autocenter);
    } else if (view_all) {
        base::view_all(camera, box.lo, box.hi, autocenter);
    } else if (autocenter && !box.empty()) {
        camera.target = box.center();
    }
    return camera;
}

csg::scad::View scad_view(const base::Camera& camera) {
    csg::scad::View view;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        view.translation[at] = camera.target[i];
        view.rotation[at] = camera.rotation[i] < 0 ? camera.rotation[i] + 360 : camera.rotation[i];
    }
    view.distance = camera.distance;
    view.fov = camera.fov;
    return view;
}

}  // namespace ui
