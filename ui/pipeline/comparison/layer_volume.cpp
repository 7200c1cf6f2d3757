#include "ui/pipeline/comparison/layer_volume.h"

#include <cmath>
#include <vector>

namespace ui {

namespace {

/// How long the ray of a pixel runs inside.
double length_inside(const layers::HostStack& stack, const base::View& view, int x, int y) {
    double length = 0, entered = 0;
    bool inside = false;
    for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0; ++layer) {
        const layers::Surface& s = stack.at(layer, x, y);
        if (s.leaving && inside) {
            length += view.distance(s.depth) - entered;
        } else if (!s.leaving) {
            entered = view.distance(s.depth);
        }
        inside = !s.leaving;
    }
    return length;
}

}  // namespace

LayerVolume layer_volume(const layers::HostStack& stack, const base::View& view) {
    const double side = 2 * view.half_height() / view.size().y;
    LayerVolume result;
    std::vector<double> below(static_cast<std::size_t>(stack.size.x), 0);
    for (int y = 0; y < stack.size.y; ++y) {
        double left = 0;
        for (int x = 0; x < stack.size.x; ++x) {
            double& before = below[static_cast<std::size_t>(x)];
            const double length = length_inside(stack, view, x, y);
            result.volume += length * side * side;
            result.uncertainty += 0.5 * (std::abs(length - left) + std::abs(length - before)) * side * side;
            left = before = length;
        }
    }
    return result;
}

}  // namespace ui
