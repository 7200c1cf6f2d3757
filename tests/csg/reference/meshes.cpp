#include "tests/csg/reference/meshes.h"

#include "csg/scad/scad.h"
#include "goldfeather/lists_cpu/lists_cpu.h"

namespace meshes {

std::shared_ptr<const ui::Model> model_of(const std::string& program) {
    csg::scad::Request request;
    request.path = "test.scad";
    request.text = program;
    request.preview = false;
    const auto evaluation = csg::scad::evaluate(request, [](const auto&, const auto&) {});
    if (!evaluation.ok) {
        throw std::runtime_error("the program has errors");
    }
    return ui::ModelBuilder().build(evaluation.tree);
}

PictureErrors picture_errors(const csg::Scene& scene, const csg::solid::Geometry& geometry,
                             const csg::reference::Mesh& mesh, int size) {
    const ui::SolidScene solid = ui::solid_scene(scene, geometry);
    const csg::Box box = solid.geometry.box;
    PictureErrors errors;
    constexpr glm::dvec3 turns[6] = {{55, 0, 25}, {0, 0, 0}, {90, 0, 0}, {71, 13, 140}, {152, 0, 77}, {33, 40, 251}};
    for (int i = 0; i < 6; ++i) {
        base::Camera camera;
        camera.rotation = turns[i];
        camera.projection = i % 2 == 0 ? base::Projection::Perspective : base::Projection::Orthographic;
        base::view_all(camera, box.lo, box.hi, true);
        const base::View view(camera, {size, size}, box.lo, box.hi);
        const goldfeather::ListsModel lists(solid.scene, solid.geometry);
        layers::HostStack layers;
        goldfeather::ListsStats stats;
        goldfeather::peel_lists(lists, view, 0, 1, layers, stats);
        const ui::Comparison comparison =
            ui::compare_layers(layers, solid.geometry, mesh, ui::mesh_layers(mesh, view), view, box.diagonal());
        errors.all.add(comparison.all);
        errors.outside.add(comparison.outside);
    }
    return errors;
}

}  // namespace meshes
