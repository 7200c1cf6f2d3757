// What is measured: models of the gallery, and families that grow.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/scad/scad.h"
#include "ui/pipeline/model.h"

namespace bench {

/// A model made ready for every engine.
struct Subject {
    std::string name;
    double size = 0;  ///< What grows in its family; 0 for models of the gallery.
    std::shared_ptr<const ui::Model> model;
    base::Camera camera;
};

/// The files of the gallery in a folder, in the order of its manifest.json.
[[nodiscard]] std::vector<std::filesystem::path> gallery(const std::filesystem::path& folder);

/// Messages go to standard error. Throws std::runtime_error where the file does not evaluate.
[[nodiscard]] csg::scad::Evaluation evaluate(const std::string& path);

/// Throws as `evaluate`. `rule`: what its parts are.
[[nodiscard]] Subject from_file(const std::string& path, const csg::PartRule& rule = {});

/// A model by its tree.
[[nodiscard]] Subject from_tree(std::string name, double size, csg::Tree tree, const base::Camera& camera);

}  // namespace bench
