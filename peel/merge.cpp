#include "peel/merge.h"

#include <algorithm>

#include "peel/shaders.h"

namespace peel {
namespace {

gl::ShaderLibrary shaders() {
    gl::ShaderLibrary library;
    library.add(layers::shader_files());
    library.add(peel::shader_files());
    return library;
}

}  // namespace

Merge::Merge(const gl::Functions& gl) : gl_(gl), empty_array_(gl), target_(gl) {}

layers::TextureStack Merge::operator()(const layers::TextureStack& front, const layers::TextureStack& back,
                                       int max_layers) {
    if (!program_) {
        program_.emplace(gl_, shaders(),
                         std::initializer_list<std::string_view>{"peel/fullscreen.vert", "peel/merge.frag"});
    }
    layers::TextureStack merged;
    merged.size = front.size;
    merged.table = front.table;
    const bool all = max_layers == 0;
    const int both = front.layers + back.layers;
    merged.layers = all ? both : std::min(both, max_layers);
    merged.complete = front.complete && back.complete && (all || both <= max_layers);
    merged.depth = gl::Texture::make_2d_array(gl_, GL_R32F, merged.size, merged.layers);
    merged.surface = gl::Texture::make_2d_array(gl_, GL_RG32UI, merged.size, merged.layers);

    if (!target_color_ || target_color_.size() != merged.size) {
        target_color_ = gl::Texture::make_2d(gl_, GL_R8, merged.size);
        target_.attach({&target_color_});
    }
    target_.bind();
    gl_.Viewport(0, 0, merged.size.x, merged.size.y);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    front.depth.bind(0);
    front.surface.bind(1);
    back.depth.bind(2);
    back.surface.bind(3);
    gl_.BindImageTexture(0, merged.depth.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
    gl_.BindImageTexture(1, merged.surface.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RG32UI);
    program_->set("front_layers", front.layers);
    program_->set("back_layers", back.layers);
    program_->set("layers", merged.layers);
    program_->use();
    empty_array_.bind();
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    return merged;
}

}  // namespace peel
