#include "ui/pipeline/comparison/solid_of_tree.h"

#include <memory>
#include <utility>

#include "csg/reference/boolean.h"
#include "ui/pipeline/model.h"

namespace ui {

MeasuredSolid solid_of(csg::Tree tree, const std::stop_token& stop) {
    ModelBuilder builder;
    builder.show(csg::Showing::Result);
    const auto model = builder.build(std::make_shared<const csg::Tree>(std::move(tree)), stop);
    need_whole(*model);
    if (model->flat) {
        throw ModelError("outlines in the plane are compared by their files: csgscope FILE.scad -o FILE.svg");
    }
    if (model->empty()) {
        return {};
    }
    const auto found = csg::reference::make_mesh(model->scene, model->geometry, {.method = {}, .stop = stop});
    return found.mesh.empty() ? MeasuredSolid{} : MeasuredSolid{found.facts.volume, found.facts.box};
}

}  // namespace ui
