#include "tests/bench/subject.h"

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "csg/scad/scad.h"
#include "ui/pipeline/camera.h"

namespace bench {

Subject from_tree(std::string name, double size, const csg::Tree& tree, const gl::Camera& camera) {
    Subject s;
    s.name = std::move(name);
    s.size = size;
    s.scene = csg::make_scene(tree);
    s.camera = camera;
    csg::solid::SolidCache cache;
    s.geometry = csg::solid::place(tree, s.scene, cache);
    std::vector<csg::Box> boxes;
    for (const auto& leaf : s.geometry.leaves) {
        boxes.push_back(leaf.box);
        s.triangles += leaf.triangles.size();
    }
    for (const csg::Part& part : s.scene.parts) {
        goldfeather::NormalizationStats stats;
        auto normalized = goldfeather::normalize(s.scene, part, boxes, {}, stats);
        auto* sum = std::get_if<goldfeather::SumOfProducts>(&normalized);
        s.products.push_back(sum != nullptr ? std::move(sum->products) : std::vector<goldfeather::Product>{});
        s.product_count += s.products.back().size();
        s.over_budget |= std::holds_alternative<goldfeather::OverBudget>(normalized);
    }
    return s;
}

Subject from_file(const std::string& path) {
    csg::scad::Request request;
    request.path = path;
    const csg::scad::Evaluation evaluation =
        csg::scad::evaluate(request, [](const csg::scad::Message& message, const csg::scad::SourceSet& sources) {
            std::cerr << csg::scad::render(message, sources);
        });
    if (!evaluation.ok) {
        throw std::runtime_error(path + " does not evaluate");
    }
    Subject s = from_tree(std::filesystem::path(path).stem().string(), 0, *evaluation.tree, {});
    s.camera = ui::choose_camera({}, evaluation.view, s.geometry.box);
    return s;
}

}  // namespace bench
