#include "npr/edges/overshoot.h"

namespace npr {

Overshoot::Overshoot(const gl::Functions& gl) : gl_(gl), program_(gl, {"npr/edges/overshoot.comp"}) {}

void Overshoot::draw(const Frame& frame, const EdgeMap& edges, float length) {
    const glm::ivec2 size = frame.layers.size;
    if (!points_ || points_.size() != size) {
        points_ = gl::Texture::make_2d_array(gl_, GL_R32UI, size, 2);
        tiles_ = make_edge_tiles(gl_, size);
    }
    const std::uint32_t zero = 0;
    gl_.ClearTexImage(points_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    gl_.ClearTexImage(tiles_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    if (length > 0 && edges.links() > 0) {
        program_.program().set("overshoot", length);
        edges.bind();
        gl_.BindImageTexture(0, points_.id(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_R32UI);
        gl_.BindImageTexture(1, tiles_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
        program_.use(frame);
        gl_.DispatchCompute(groups(edges.links()), 1, 1);
        gl_.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    points_.bind(5);
    tiles_.bind(6);
}

}  // namespace npr
