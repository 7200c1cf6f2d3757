#include "ui/pipeline/picture/picture_request.h"

#include <algorithm>

namespace ui {

bool is_flat_picture(const Model& model, const npr::Picture& picture) {
    return model.flat && picture.style->name == "shaded";
}

npr::Picture flat_picture(npr::Picture picture, bool lines) {
    picture.draw_as(*npr::find_style("edges"));
    npr::Parameters& parameters = picture.parameters;
    parameters.set("width", lines ? 2 : 0.25F);  // Those that are none are thin and of the faces' color.
    parameters.set("edge-color", lines ? picture.scheme.edge_2d : picture.scheme.face_2d);
    parameters.set("light", 0.0F);
    parameters.set("inner", 0.0F);
    parameters.set("smooth", false);
    picture.scheme.face = picture.scheme.face_2d;
    return picture;
}

int layers_to_peel(const npr::Picture& picture, const Model& model) {
    const bool seen_through = translucent(model.scene) || !picture.media.empty();
    if (picture.layers != npr::kLayersOfStyle) {
        return picture.layers;
    }
    return picture.part_styles.empty() && picture.reveal.empty() ? picture.style->layers(seen_through)
                                                                 : layers::kAllLayers;
}

bool translucent(const csg::Scene& scene) {
    return std::any_of(scene.parts.begin(), scene.parts.end(),
                       [](const csg::Part& part) { return part.kind != csg::PartKind::Solid; });
}

}  // namespace ui
