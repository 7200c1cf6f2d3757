// View-dependent transparency by pixel and by vertex: how much the two differ, and by how much each depends on the
// mesh. Prints the table of docs/transparency/view-dependent.md:  csgscope_shine [SIDE]
#include <fmt/format.h>

#include <cmath>

#include "tests/npr/scene.h"
#include "ui/pipeline/picture/renderer.h"

namespace {

using scene::Model;

csg::Rgba glass() {
    return {0, 0, 0, 0.5F};
}

/// The opacity of a body before white, by pixel; below 0 where it is not.
std::vector<double> opacity(const Model& body, const char* found_for, int side) {
    const csg::Tree tree = random_tree::make_tree(scene::colored(glass(), body));
    const auto model = ui::ModelBuilder().build(std::make_shared<const csg::Tree>(tree));
    npr::Picture p = npr::default_picture();
    p.scheme.background = p.scheme.background_stop = glm::vec3(1);
    p.camera = scene::camera(model->geometry.box);
    p.size = {side, side};
    p.samples = 1;
    p.see_through_as(*npr::find_transparency("view-dependent"));
    for (const auto& [name, value] : {std::pair("gooch", "off"), {"silhouettes", "0"}, {"background", "1"}}) {
        p.transparency_parameters.read(name, value);
    }
    p.transparency_parameters.read("opacity", found_for);
    ui::Renderer renderer({}, ui::Painter::Cpu);
    p.transparent_background = true;
    (void)renderer.render(*model, ui::PictureRequest(p));
    std::vector<double> result;
    for (const glm::vec4& pixel : renderer.light()) {
        result.push_back(pixel.a > 0 ? static_cast<double>(pixel.a) : -1);
    }
    return result;
}

struct Difference {
    double rms = 0, most = 0;
};

/// Where both are seen.
Difference between(const std::vector<double>& a, const std::vector<double>& b) {
    Difference d;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] >= 0 && b[i] >= 0) {
            const double away = std::abs(a[i] - b[i]);
            d.rms += away * away;
            d.most = std::max(d.most, away);
            ++count;
        }
    }
    d.rms = std::sqrt(d.rms / static_cast<double>(std::max<std::size_t>(count, 1)));
    return d;
}

double least(const std::vector<double>& opacities) {
    double result = 1;
    for (const double opacity : opacities) {
        result = opacity >= 0 ? std::min(result, opacity) : result;
    }
    return result;
}

Model ball(int facets) {
    csg::Fineness fine;
    fine.fn = facets;
    return scene::leaf(csg::Sphere{10, fine});
}

}  // namespace

int main(int argc, char** argv) {
    const int side = argc > 1 ? std::stoi(argv[1]) : 256;
    constexpr int kFinest = 200;
    const std::vector<double> pixels = opacity(ball(kFinest), "pixels", side),
                              vertices = opacity(ball(kFinest), "vertices", side);
    fmt::print("| ball of `$fn` | by pixel: RMS | most | by vertex: RMS | most |\n| --- | --- | --- | --- | --- |\n");
    for (const int facets : {8, 16, 32, 64, 128}) {
        const Difference by_pixel = between(opacity(ball(facets), "pixels", side), pixels),
                         by_vertex = between(opacity(ball(facets), "vertices", side), vertices);
        fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", facets, by_pixel.rms, by_pixel.most, by_vertex.rms,
                   by_vertex.most);
    }
    fmt::print(
        "\n| body | between the two: RMS | most | least opacity by pixel | by vertex |\n"
        "| --- | --- | --- | --- | --- |\n");
    csg::Fineness round;
    round.fn = 64;
    const std::vector<std::pair<const char*, Model>> bodies{
        {"ball", ball(64)},
        {"cylinder", scene::leaf(csg::Cylinder{20, 10, 10, true, round})},
        {"plate", scene::box({-20, -20, -1}, {40, 40, 2})},
        {"cube", scene::box({-10, -10, -10}, {20, 20, 20})},
        {"bored cube",
         scene::combine(csg::Operation::Difference, {scene::box({-10, -10, -10}, {20, 20, 20}),
                                                     scene::leaf(csg::Cylinder{30, 5, 5, true, round})})}};
    for (const auto& [name, body] : bodies) {
        const std::vector<double> a = opacity(body, "pixels", side), b = opacity(body, "vertices", side);
        const Difference d = between(a, b);
        fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", name, d.rms, d.most, least(a), least(b));
    }
    return 0;
}
