#include "tests/bench/subject.h"

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "ui/pipeline/picture/camera.h"

namespace bench {

std::vector<std::filesystem::path> gallery(const std::filesystem::path& folder) {
    std::ifstream file(folder / "manifest.json");
    const auto manifest = nlohmann::json::parse(file);
    std::vector<std::filesystem::path> files;
    for (const auto& model : manifest.at("models")) {
        files.push_back(folder / model.at("file").get<std::string>());
    }
    return files;
}

csg::scad::Evaluation evaluate(const std::string& path) {
    csg::scad::Request request;
    request.path = path;
    csg::scad::Evaluation evaluation =
        csg::scad::evaluate(request, [](const csg::scad::Message& message, const csg::scad::SourceSet& sources) {
            std::cerr << csg::scad::render(message, sources);
        });
    if (!evaluation.ok) {
        throw std::runtime_error(path + " does not evaluate");
    }
    return evaluation;
}

Subject from_file(const std::string& path, const csg::PartRule& rule) {
    const csg::scad::Evaluation evaluation = evaluate(path);
    ui::ModelBuilder builder;
    builder.divide(rule);
    Subject s{std::filesystem::path(path).stem().string(), 0, builder.build(evaluation.tree), {}};
    s.camera = ui::choose_camera({}, evaluation.view, s.model->geometry.box);
    return s;
}

Subject from_tree(std::string name, double size, csg::Tree tree, const base::Camera& camera) {
    return {std::move(name), size, ui::ModelBuilder().build(std::make_shared<const csg::Tree>(std::move(tree))),
            camera};
}

}  // namespace bench
