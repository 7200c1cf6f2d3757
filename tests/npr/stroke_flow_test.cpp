// How strokes move with the surface when the model is turned (Nienhaus 2005, 6.7).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "npr/styles/cpu_sketch_noise.h"
#include "tests/npr/easel.h"

namespace {

/// A frame of a turntable with its noise.
struct Turned {
    Turned(const comparison::Subject& subject, const char* anchor, double degrees) {
        picture.draw_as(*npr::find_style("sketch"));
        picture.parameters.read("anchor", anchor);
        picture.camera = scene::camera(subject.geometry.box);
        picture.camera.rotation.z += degrees;
        picture.size = {128, 128};
        picture.samples = 1;
        view.emplace(subject.view(picture.camera, picture.size));
        stack = goldfeather::peel_to_host(subject.scene, subject.geometry, *view, 1);
        stack.table = goldfeather::surface_table(subject.scene, subject.geometry);
        noise.draw({picture, *view, stack, unused}, npr::settings_of<npr::SketchSettings>(picture));
    }

    [[nodiscard]] glm::dvec2 offset_at(const glm::dvec2& at) const {
        const glm::dvec2 low = glm::floor(at - 0.5), part = at - 0.5 - low;
        const auto of = [&](int x, int y) {
            const glm::ivec2 p = glm::clamp(glm::ivec2(low) + glm::ivec2(x, y), 0, 127);
            return glm::dvec2(noise.strokes(static_cast<std::size_t>(128 * p.y + p.x)));
        };
        return glm::mix(glm::mix(of(0, 0), of(1, 0), part.x), glm::mix(of(0, 1), of(1, 1), part.x), part.y);
    }

    npr::Picture picture;
    std::optional<base::View> view;
    layers::HostStack stack;
    std::vector<glm::vec4> unused;
    npr::CpuSketchNoise noise;
};

/// Over a turntable of 1 degree steps: how much the offset of a stroke changes from picture to picture at a point of
/// the surface, as a share of what it would if strokes stood still in the picture. 0: they are drawn on the model.
struct Slip {
    double all = 0, most = 0;  ///< Of all points; of the nine tenths of them that change least.
};
Slip slip(const comparison::Subject& subject, const char* anchor) {
    std::vector<glm::dvec2> points;  // What changes, and what would if strokes stood still.
    for (int step = 0; step < 360; step += 30) {
        const Turned now(subject, anchor, step), next(subject, anchor, step + 1);
        for (int y = 0; y < 128; y += 2) {
            for (int x = 0; x < 128; x += 2) {
                const layers::Surface s = now.stack.at(0, x, y);
                if (s.depth <= 0) {
                    continue;
                }
                const base::View::Ray ray = now.view->ray(x, y);
                const glm::dvec3 point = ray.origin + now.view->distance(s.depth) * ray.direction;
                const glm::dvec4 clip = next.view->clip_from_world() * glm::dvec4(point, 1);
                const glm::dvec2 from(x + 0.5, y + 0.5), to = (glm::dvec2(clip) / clip.w + 1.0) * 64.0;
                points.emplace_back(glm::distance(next.offset_at(to), now.offset_at(from)),
                                    glm::distance(now.offset_at(to), now.offset_at(from)));
            }
        }
    }
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    const auto share = [&](std::size_t count) {
        const glm::dvec2 sum =
            std::accumulate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count), glm::dvec2(0));
        return sum.x / sum.y;
    };
    return {share(points.size()), share(points.size() * 9 / 10)};
}

TEST(StrokeFlow, NoiseOfTheModelMovesWithItsSurface) {
    for (const auto& [name, model] : {std::pair("widget", scene::widget()), {"blocks", scene::flush_blocks()}}) {
        const comparison::Subject subject(random_tree::make_tree(model));
        const Slip picture = slip(subject, "picture"), on_model = slip(subject, "model");
        RecordProperty(fmt::format("{}_slip_of_model_noise", name), fmt::format("{:.3f}", on_model.all));
        fmt::print(
            "{}: slip {:.2f} with noise of the picture, {:.2f} with noise of the model, {:.2f} for most points\n", name,
            picture.all, on_model.all, on_model.most);
        EXPECT_NEAR(picture.all, 1, 0.01) << name << ": the picture's noise stands still";
        EXPECT_LT(on_model.all, 0.5) << name << ": near edges in depth it passes from one surface to the other";
        EXPECT_LT(on_model.most, 0.18) << name;
    }
}

}  // namespace
