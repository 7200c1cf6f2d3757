// What the program `openscad` makes of a file, for comparison.
#pragma once

#include <optional>
#include <string>

#include "base/camera.h"
#include "base/image.h"
#include "ui/pipeline/mesh/mesh.h"

namespace ui {

/// Runs `openscad` (2021.01 or newer), each time in a process of its own, which ends with this one. What it makes comes
/// back through memory: there are no files that could be left, however this process ends.
class OpenscadProcess {
  public:
    explicit OpenscadProcess(std::string input);

    /// Throw std::runtime_error where openscad is not installed or cannot.
    [[nodiscard]] csg::reference::Mesh mesh() const;
    [[nodiscard]] std::string tree() const;  ///< Text of the .csg file.

    /// Its rendered picture; none where it can make none, as without a display (Xvfb is started then).
    [[nodiscard]] std::optional<base::Image> picture(const base::Camera& camera, glm::ivec2 size) const;

  private:
    std::string input_;
};

}  // namespace ui
