#include "tests/bench/transparency_scenes.h"

#include <cmath>

#include "tests/npr/scene.h"

namespace bench {
namespace {

using csg::Operation;
using scene::box;
using scene::colored;
using scene::Model;

csg::Rgba color(int i, float alpha) {
    static constexpr std::array<std::array<float, 3>, 5> kColors{
        {{0.9F, 0.3F, 0.2F}, {0.2F, 0.5F, 0.9F}, {0.3F, 0.8F, 0.4F}, {0.95F, 0.8F, 0.2F}, {0.7F, 0.3F, 0.8F}}};
    const auto& c = kColors[static_cast<std::size_t>(i) % kColors.size()];
    return {c[0], c[1], c[2], alpha};
}

Model ball(double radius) {
    csg::Fineness fine;
    fine.fn = 40;
    return scene::leaf(csg::Sphere{radius, fine});
}

ClearScene made(std::string name, int depth, std::vector<Model> models, std::optional<base::Camera> camera = {}) {
    const csg::Tree tree = random_tree::make_tree(scene::combine(Operation::Union, std::move(models)));
    ClearScene result{std::move(name),
                      depth,
                      ui::ModelBuilder().build(std::make_shared<const csg::Tree>(tree)),
                      std::make_shared<const comparison::Subject>(tree, false),
                      {}};
    result.camera = camera ? *camera : scene::camera(result.truth->geometry.box);
    return result;
}

csg::Fineness rounded(int facets) {
    csg::Fineness fine;
    fine.fn = facets;
    return fine;
}

}  // namespace

ClearScene slabs(int depth) {
    std::vector<Model> models;
    for (int i = 0; i < depth / 2; ++i) {
        models.push_back(colored(color(i, 0.25F), box({-200, -200, -2.0 * i}, {400, 400, 1})));
    }
    base::Camera camera;
    camera.rotation = {20, 0, 10};
    camera.distance = 100;
    return made("slabs", depth, std::move(models), camera);
}

ClearScene crossing() {
    std::vector<Model> models;
    for (int i = 0; i < 6; ++i) {
        const double angle = 30.0 * i * std::acos(-1.0) / 180;
        const glm::dmat4 turned(glm::dvec4(std::cos(angle), std::sin(angle), 0.2, 0),
                                glm::dvec4(-std::sin(angle), std::cos(angle), 0.1, 0), glm::dvec4(0, -0.2, 1, 0),
                                glm::dvec4(0, 0, 0, 1));
        models.push_back(colored(color(i, 0.4F), scene::matrix(turned, box({-20, -3, -8}, {40, 6, 16}))));
    }
    return made("crossing", 0, std::move(models));
}

ClearScene nested() {
    std::vector<Model> models;
    for (int i = 0; i < 6; ++i) {
        models.push_back(colored(color(i, 0.3F), ball(5.0 * (i + 1))));
    }
    models.push_back(box({-2, -2, -2}, {4, 4, 4}));
    return made("nested", 0, std::move(models));
}

ClearScene inside() {
    std::vector<Model> models{box({-60, 70, -60}, {120, 4, 120})};
    for (int i = 0; i < 5; ++i) {
        models.push_back(colored(color(i, 0.3F), ball(10.0 * (i + 1))));
    }
    models.push_back(colored(color(7, 0.4F), box({-6, 12, -30}, {12, 30, 60})));
    base::Camera camera;
    camera.target = {0, 5, 0};
    camera.rotation = {90, 0, 0};
    camera.distance = 5;
    camera.fov = 70;
    return made("inside", 0, std::move(models), camera);
}

ClearScene crank() {
    std::vector<Model> models;
    for (int i = 0; i < 10; ++i) {
        const bool pin = i % 2 == 1;
        models.push_back(
            colored({0.6F, 0.6F, 0.65F, 1},
                    scene::at(glm::dvec3(pin ? 6 : 0, 0, 8.0 * i - 40),
                              scene::leaf(csg::Cylinder{7.9, pin ? 3.0 : 8.0, pin ? 3.0 : 8.0, false, rounded(626)}))));
    }
    models.push_back(
        colored({0.5F, 0.8F, 0.9F, 0.4F},
                scene::at(glm::dvec3(0, 0, -45), scene::leaf(csg::Cylinder{90, 14, 14, false, rounded(49)}))));
    return made("crank", 0, std::move(models));
}

std::optional<ClearScene> of_glass(const std::filesystem::path& file, std::size_t most, bool by_color) {
    csg::PartRule rule;
    rule.kind = by_color ? csg::PartRule::Kind::Color : csg::PartRule::Kind::Model;
    const Subject subject = from_file(file.string(), rule);
    if (subject.model->statistics.triangles > most || subject.model->empty()) {
        return std::nullopt;
    }
    const auto to_glass = [by_color](csg::Scene& scene) {
        int i = 0;
        for (csg::Part& part : scene.parts) {
            if (part.kind == csg::PartKind::Solid) {
                part.kind = csg::PartKind::Translucent;
                part.color = part.color.r >= 0 && by_color ? csg::Rgba{part.color.r, part.color.g, part.color.b, 0.4F}
                                                           : color(i, 0.4F);
                ++i;
            }
        }
    };
    auto model = std::make_shared<ui::Model>(*subject.model);
    auto truth = std::make_shared<comparison::Subject>(*model->tree, false, rule);
    to_glass(model->scene);
    to_glass(truth->scene);
    model->generation += std::uint64_t{1} << 40U;
    return ClearScene{subject.name, 0, model, truth, subject.camera};
}

}  // namespace bench
