#include "tests/npr/scene.h"

#include "goldfeather/smooth_facets.h"
#include "goldfeather/surface_table.h"
#include "layers/upload.h"

#include <glm/gtc/matrix_transform.hpp>

namespace scene {

using csg::Operation;

Model widget() {
    csg::Fineness fine;
    fine.fn = 48;
    const Model bore = leaf(csg::Cylinder{16, 4, 4, true, fine});
    const glm::dmat4 one(1.0);
    const double turn = glm::radians(90.0);
    return combine(
        Operation::Difference,
        {combine(Operation::Intersection, {leaf(csg::Cube{glm::dvec3(15), true}), leaf(csg::Sphere{10, fine})}), bore,
         matrix(glm::rotate(one, turn, {1, 0, 0}), bore), matrix(glm::rotate(one, turn, {0, 1, 0}), bore)});
}

Model flush_blocks() {
    return combine(Operation::Union, {box({0, 0, 0}, {4, 4, 4}), box({4, 0, 0}, {4, 4, 4}), box({0, 4, 0}, {8, 4, 2})});
}

Model colored(const csg::Rgba& color, Model model) {
    return {Operation::Color, {}, csg::Cube{}, glm::dmat4(1.0), color, {std::move(model)}};
}

base::Camera camera(const csg::Box& box) {
    base::Camera c;
    base::view_all(c, box.lo, box.hi, true);
    return c;
}

layers::TextureStack peel(const gl::Functions& gl, const comparison::Subject& subject,
                          goldfeather::PreparedScene& prepared, const base::View& view, int max_layers) {
    goldfeather::WalkStats ignored;
    layers::Upload upload(gl);
    layers::TextureStack stack = upload.textures(prepared.draw(view, max_layers, ignored));
    const auto table = goldfeather::surface_table(subject.scene, subject.geometry);
    table->smooth = goldfeather::smooth_facets(subject.geometry);
    stack.table = std::make_shared<layers::SurfaceBuffers>(gl, *table);
    return stack;
}

base::Image Studio::draw(const Model& model, const Request& request) {
    const auto style = npr::find_style(request.style)->make(gl_);
    return draw_with(*style, model, request);
}

base::Image Studio::draw_with(npr::Style& style, const Model& model, const Request& request) {
    const comparison::Subject subject(random_tree::make_tree(model));
    const auto prepared = engine_->prepare(subject.input());
    npr::Picture picture;
    picture.draw_as(*npr::find_style(request.style));
    for (const auto& [name, value] : request.settings) {
        picture.parameters.read(name, value);
    }
    picture.scheme = *npr::find_color_scheme(request.scheme);
    picture.camera = request.camera ? *request.camera : camera(subject.geometry.box);
    picture.size = request.size;
    picture.samples = request.samples;
    picture.transparent_background = request.transparent_background;
    const int needed = picture.style->layers(true);
    accumulator_.draw(style, picture, {subject.geometry.box.lo, subject.geometry.box.hi, [&](const base::View& view) {
                                           return peel(gl_, subject, *prepared, view, needed);
                                       }});
    return accumulator_.image();
}

}  // namespace scene
