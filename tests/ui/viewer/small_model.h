// Models and revisions for tests, without the language.
#pragma once

#include <memory>

#include "csg/tree/tree.h"
#include "ui/viewer/revision.h"

namespace ui {

/// A cube with a corner at the origin.
inline std::shared_ptr<const Model> cube_model() {
    csg::TreeBuilder builder;
    const csg::NodeId cube = builder.leaf(csg::Cube{glm::dvec3(10)}, {builder.file("cube.scad"), 1, 1});
    return ModelBuilder().build(std::make_shared<csg::Tree>(builder.finish(cube)));
}

inline std::shared_ptr<const Model> empty_model() {
    return ModelBuilder().build(std::make_shared<csg::Tree>(csg::TreeBuilder().finish(csg::kNoNode)));
}

inline Revision good_revision(std::shared_ptr<const Model> model = cube_model()) {
    Revision revision;
    revision.model = std::move(model);
    revision.messages.add(LineKind::Echo, "ECHO: good");
    return revision;
}

inline Revision failed_revision() {
    Revision revision;
    revision.messages.add(LineKind::Error, "model.scad:3:5: it is wrong");
    return revision;
}

}  // namespace ui
