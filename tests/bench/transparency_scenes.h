// Scenes whose parts are seen through, for tests/bench/transparency_main.cpp.
#pragma once

#include <filesystem>
#include <optional>

#include "tests/bench/subject.h"
#include "tests/goldfeather/comparison.h"
#include "ui/pipeline/picture/picture_request.h"

namespace bench {

/// A model for the program, and the same for rays.
struct ClearScene {
    std::string name;
    int depth = 0;  ///< Surfaces behind each pixel, of those that grow; else 0.
    std::shared_ptr<const ui::Model> model;
    std::shared_ptr<const comparison::Subject> truth;
    base::Camera camera;
};

/// Slabs behind each other that fill the picture: `depth` surfaces.
[[nodiscard]] ClearScene slabs(int depth);
/// Boxes at a slant that pass through each other; balls in balls; the eye in the innermost of them.
[[nodiscard]] ClearScene crossing();
[[nodiscard]] ClearScene nested();
[[nodiscard]] ClearScene inside();
/// As crank in a cylinder: 25,192 triangles, 192 of which are seen through.
[[nodiscard]] ClearScene crank();
/// A program's model, of glass; none where it has more triangles than `most`. `by_color`: its colors are parts, each of
/// its own glass.
[[nodiscard]] std::optional<ClearScene> of_glass(const std::filesystem::path& file, std::size_t most,
                                                 bool by_color = false);

}  // namespace bench
