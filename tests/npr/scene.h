// Models to draw, and pictures of them.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "npr/accumulate.h"
#include "tests/goldfeather/comparison.h"
#include "tests/random/build_model.h"

namespace scene {

using random_tree::at;
using random_tree::box;
using random_tree::combine;
using random_tree::leaf;
using random_tree::matrix;
using random_tree::Model;

/// A rounded block with three bores, as in Kirsch and Döllner's figures.
[[nodiscard]] Model widget();
/// A staircase of three boxes whose faces meet flush.
[[nodiscard]] Model flush_blocks();

[[nodiscard]] Model colored(const csg::Rgba& color, Model model);

/// OpenSCAD's default direction of view, all of the box in the picture.
[[nodiscard]] base::Camera camera(const csg::Box& box);

/// All layers of the subject from a view, ready to be drawn by styles.
[[nodiscard]] layers::TextureStack peel(const gl::Functions& gl, const comparison::Subject& subject,
                                        goldfeather::PreparedScene& prepared, const base::View& view,
                                        int max_layers = goldfeather::kAllLayers);

/// Holds what pictures need in one context.
class Studio {
  public:
    explicit Studio(const gl::Functions& gl)
        : gl_(gl),
          engine_(goldfeather::make_engine(*goldfeather::find_engine("goldfeather"), {&gl})),
          accumulator_(gl) {}

    struct Request {
        std::string_view style = "shaded";
        std::map<std::string, std::string> settings{};
        glm::ivec2 size{64, 64};
        int samples = 1;
        std::string_view scheme = "Cornfield";
        bool transparent_background = false;
        /// Null: all of the model from OpenSCAD's default direction.
        const base::Camera* camera = nullptr;
    };
    [[nodiscard]] base::Image draw(const Model& model, const Request& request);
    /// The same with a style kept by the caller, who makes it of `request.style`.
    [[nodiscard]] base::Image draw_with(npr::Style& style, const Model& model, const Request& request);
    [[nodiscard]] npr::Accumulator& accumulator() { return accumulator_; }

  private:
    const gl::Functions& gl_;
    std::unique_ptr<goldfeather::Engine> engine_;
    npr::Accumulator accumulator_;
};

}  // namespace scene
