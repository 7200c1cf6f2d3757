// What the program `openscad` makes of a file, for comparison.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/camera.h"
#include "base/image.h"
#include "ui/pipeline/mesh/mesh.h"

namespace ui {

/// Runs `openscad`, each time in a process of its own; its files are in a folder that is gone at the end.
class OpenscadProcess {
  public:
    explicit OpenscadProcess(std::string input);
    OpenscadProcess(const OpenscadProcess&) = delete;
    OpenscadProcess& operator=(const OpenscadProcess&) = delete;
    ~OpenscadProcess();

    /// Throw std::runtime_error where openscad is not installed or cannot.
    [[nodiscard]] csg::reference::Mesh mesh() const;
    [[nodiscard]] std::string tree() const;  ///< Text of the .csg file.

    /// Its rendered picture; none where it can make none, as without a display (xvfb-run is asked for one).
    [[nodiscard]] std::optional<base::Image> picture(const base::Camera& camera, int size) const;

  private:
    std::string input_;
    std::filesystem::path folder_;
};

}  // namespace ui
