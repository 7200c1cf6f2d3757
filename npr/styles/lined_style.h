// Styles on OpenGL whose frame is an edge map and one pass over the picture.
#pragma once

#include "npr/edges/edge_map.h"
#include "npr/style.h"
#include "npr/style_pass.h"

namespace npr {

class LinedStyle : public Style {
  public:
    using Edges = EdgeSettings (*)(const Parameters& parameters);
    /// Sets the uniforms of the style's own.
    using SetUniforms = void (*)(const Parameters& parameters, const gl::Program& program);

    /// `fragment`: as StylePass takes it. Throws gl::Error.
    LinedStyle(const gl::Functions& gl, std::string_view fragment, Edges edges, SetUniforms set_uniforms)
        : edge_map_(gl), pass_(gl, fragment), edges_(edges), set_uniforms_(set_uniforms) {}

    void draw(const Frame& frame) override {
        edge_map_.draw(frame, edges_(frame.parameters));
        set_uniforms_(frame.parameters, pass_.program());
        pass_.draw(frame);
    }

  private:
    EdgeMap edge_map_;
    StylePass pass_;
    Edges edges_;
    SetUniforms set_uniforms_;
};

}  // namespace npr
