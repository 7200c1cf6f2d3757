#include "ui/command_line/compare_views.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

void set(base::Image& image, int x, int y, const glm::dvec3& color) {
    const std::size_t at = 4 * (static_cast<std::size_t>(image.height - 1 - y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(x));
    for (int c = 0; c < 3; ++c) {
        image.rgba[at + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[c], 0.0, 1.0)));
    }
}

/// The same plain light for both sides, so that what differs is the geometry.
glm::dvec3 shade(const glm::dvec3& normal, const base::View& view) {
    const double light = std::abs((glm::dmat3(view.eye_from_world()) * normal).z);
    return glm::dvec3(0.95, 0.8, 0.35) * (0.3 + 0.7 * light);
}

/// Gray where all agrees; blue in the band, red outside it, the darker the more layers differ.
glm::dvec3 heat(const Comparison& comparison, std::size_t pixel) {
    if (comparison.wrong[pixel] == 0) {
        return glm::dvec3(0.85);
    }
    const double much = 1 - std::exp2(-static_cast<double>(comparison.wrong_layers[pixel]));
    return glm::mix(glm::dvec3(0.85), comparison.wrong[pixel] == 1 ? glm::dvec3(0.0, 0.2, 0.8) : glm::dvec3(0.8, 0, 0),
                    0.3 + 0.7 * much);
}

}  // namespace

base::Camera spread_camera(int view, int views, const csg::Box& box) {
    base::Camera camera;
    if (view > 0) {
        const double z = 1 - 2 * (view + 0.5) / views;
        camera.rotation = {std::acos(z) * 57.29577951308232, 0, std::fmod(view * 137.50776405003785, 360.0)};
    }
    camera.projection = view % 2 == 0 ? base::Projection::Perspective : base::Projection::Orthographic;
    base::view_all(camera, box.lo, box.hi, true);
    return camera;
}

base::Image blank_image(glm::ivec2 size) {
    base::Image image{size.x, size.y, {}};
    image.rgba.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4, 255);
    return image;
}

ComparedView compared_view(const SolidScene& solid, const csg::reference::Mesh& mesh, const base::View& view,
                           const layers::HostStack& stack, const MeshLayers& truth, const Comparison& comparison) {
    ComparedView result{{},
                        blank_image(view.size()),
                        blank_image(view.size()),
                        blank_image(view.size()),
                        to_json(comparison.all),
                        to_json(comparison.outside)};
    for (int y = 0; y < view.size().y; ++y) {
        for (int x = 0; x < view.size().x; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(view.size().x) + static_cast<std::size_t>(x);
            const bool drawn = stack.layers > 0 && stack.at(0, x, y).depth > 0;
            if (drawn) {
                set(result.drawn, x, y, shade(solid.geometry.planes.planes()[stack.at(0, x, y).plane].normal, view));
            }
            if (!truth.of[i].empty()) {
                set(result.expected, x, y, shade(normal_of(mesh, truth.of[i][0].triangle), view));
            }
            if (drawn || !truth.of[i].empty()) {
                set(result.difference, x, y, heat(comparison, i));
            }
        }
    }
    return result;
}

}  // namespace ui
