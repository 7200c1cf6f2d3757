// Plan views: several views of a model in one picture, at one scale (Nienhaus 2005, 5.5).
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "csg/tree/box.h"
#include "ui/pipeline/picture/picture_request.h"

namespace ui {

enum class PlanView { Top, Front, Side, Iso };

/// Where a view is in the picture, and what it is of.
struct PlanCell {
    PlanView view = PlanView::Front;
    glm::ivec2 corner{0}, size{0};  ///< Pixels from the picture's upper left corner; cells fill the picture.
    glm::dvec2 middle{0};           ///< Of the model, the same.
    base::Camera camera;            ///< Orthographic, of a picture of that size.
};

struct Plan {
    std::vector<PlanCell> cells;
    double pixels_per_unit = 1;
};

/// In third-angle projection (ISO 128-3): the top above the front, the right side at its right; the isometric view has
/// the corner between them. `box`: what is to be seen. `margin`: share of the picture that stays free about each view.
[[nodiscard]] Plan plan_of(const std::vector<PlanView>& views, glm::ivec2 size, const csg::Box& box,
                           double margin = 0.04);

/// All views of `request`'s picture, whose camera does not count, with lines from view to view at the ends of the box
/// and a bar of a round length. `render` draws one of them.
[[nodiscard]] base::Image draw_plan(const std::vector<PlanView>& views, const PictureRequest& request,
                                    const csg::Box& box,
                                    const std::function<base::Image(const PictureRequest&)>& render);

/// "top", "front", "side" or "iso", several with commas between, each once. Throws std::invalid_argument, naming what
/// is none.
[[nodiscard]] std::vector<PlanView> read_plan(std::string_view text);

}  // namespace ui
