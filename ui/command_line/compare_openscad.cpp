#include "ui/command_line/compare_openscad.h"

#include <algorithm>
#include <cmath>

#include "ui/pipeline/mesh/mesh.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {

namespace {

/// What OpenSCAD's file of the mesh is wrong by: it has six digits, so that each point moves by up to half a unit of
/// the last place in each coordinate, and the volume by at most the area times that way.
double rounding_of_openscad(const csg::reference::MeshFacts& facts) {
    const glm::dvec3 largest = glm::max(glm::abs(facts.box.lo), glm::abs(facts.box.hi));
    double way2 = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (largest[axis] > 0) {
            const double half = 0.5 * std::pow(10.0, std::floor(std::log10(largest[axis])) - 5);
            way2 += half * half;
        }
    }
    return facts.area * std::sqrt(way2);
}

/// Which pixels are not background (the color of the first pixel, a corner).
std::size_t pixels_that_differ_in_coverage(const base::Image& a, const base::Image& b) {
    const auto covered = [](const base::Image& image, std::size_t i) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            most = std::max(most, std::abs(int{image.rgba[4 * i + c]} - int{image.rgba[c]}));
        }
        return most > 8;
    };
    std::size_t differ = 0;
    for (std::size_t i = 0; i < a.rgba.size() / 4; ++i) {
        differ += covered(a, i) != covered(b, i) ? 1 : 0;
    }
    return differ;
}

std::string without_last_lines(std::string text) {
    text.erase(text.find_last_not_of('\n') + 1);
    return text;
}

}  // namespace

Json compare_with_openscad(const OpenscadProcess& openscad, const std::string& tree, const Model& model,
                           const csg::reference::MeshFacts& theirs, const base::Camera& camera, glm::ivec2 size) {
    const csg::reference::MeshFacts ours = make_mesh(model).facts;
    const double off = std::abs(ours.volume - theirs.volume);
    Json json = {{"tree_agrees", without_last_lines(tree) == without_last_lines(openscad.tree())},
                 {"volume",
                  {{"openscad", theirs.volume},
                   {"csgscope", ours.volume},
                   {"relative_difference", off / ours.volume},
                   {"agrees", off <= rounding_of_openscad(ours) + 1e-6 * ours.volume}}},
                 {"picture", nullptr}};
    if (const auto picture = openscad.picture(camera, size)) {
        PictureRequest request;
        request.camera = camera;
        request.size = {picture->width, picture->height};
        request.samples = 1;
        const base::Image drawn = Renderer().render(model, request);
        json["picture"]["coverage_error"] = static_cast<double>(pixels_that_differ_in_coverage(drawn, *picture)) /
                                            static_cast<double>(drawn.rgba.size() / 4);
    }
    return json;
}

}  // namespace ui
