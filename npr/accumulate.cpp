#include "npr/accumulate.h"

#include <algorithm>
#include <array>

#include "npr/guard_band.h"
#include "npr/style_pass.h"
#include "peel/shaders.h"

namespace npr {
namespace {

gl::ShaderLibrary shaders() {
    gl::ShaderLibrary library;
    library.add(peel::shader_files());
    library.add(npr::shader_files());
    return library;
}

}  // namespace

Accumulator::Accumulator(const gl::Functions& gl)
    : gl_(gl),
      resolve_(gl, shaders(), {"peel/fullscreen.vert", "npr/resolve.frag"}),
      add_(gl, shaders(), {"peel/fullscreen.vert", "npr/add.frag"}),
      empty_array_(gl),
      sample_target_(gl),
      sum_target_(gl),
      resolved_target_(gl) {}

void Accumulator::resize(glm::ivec2 size) {
    if (sum_ && sum_.size() == size) {
        return;
    }
    sample_ = gl::Texture::make_2d(gl_, GL_RGBA32F, size);
    sum_ = gl::Texture::make_2d(gl_, GL_RGBA32F, size);
    resolved_ = gl::Texture();
    sample_target_.attach({&sample_});
    sum_target_.attach({&sum_});
}

void Accumulator::draw(Style& style, const Picture& picture, const Subject& subject) {
    for (std::size_t sample = 0; sample < sample_offsets(picture.samples).size(); ++sample) {
        (void)draw_sample(style, picture, sample, subject);
    }
}

layers::TextureStack Accumulator::draw_sample(Style& style, const Picture& picture, std::size_t sample,
                                              const Subject& subject, const std::stop_token& stop) {
    const Picture wide = with_guard_band(picture);
    if (sample == 0) {
        resize(wide.size);
        guard_ = wide.guard;
        const std::array<float, 4> zero{};
        gl_.ClearNamedFramebufferfv(sum_target_.id(), GL_COLOR, 0, zero.data());
    }
    samples_ = static_cast<int>(sample) + 1;
    const base::View view = sample_view(wide, sample, subject.lo, subject.hi);
    layers::TextureStack layers = subject.peel(view);
    Frame frame{wide, view, layers, sample_target_, stop};
    frame.mesh = subject.mesh;
    frame.sample = static_cast<int>(sample);
    if (picture.transparency == Transparency::ViewDependent) {
        if (!shine_) {
            shine_.emplace(gl_);
        }
        frame.shine = &shine_->draw(frame);
    }
    if (subject.shadows && casts_shadows(picture)) {
        if (!shadows_) {
            shadows_.emplace(gl_);
        }
        shadows_->upload<ShadowBits>(subject.shadows(view), GL_DYNAMIC_DRAW);
        frame.shadows = &*shadows_;
    }
    style.draw(frame);
    sum_target_.bind();
    gl_.Viewport(0, 0, wide.size.x, wide.size.y);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, GL_ONE);
    sample_.bind(0);
    add_.use();
    empty_array_.bind();
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.Disable(GL_BLEND);
    return layers;
}

void Accumulator::resolve(GLuint target, glm::ivec2 corner) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target);
    gl_.Viewport(corner.x, corner.y, shown().x, shown().y);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_SCISSOR_TEST);
    sum_.bind(0);
    resolve_.set("samples", samples_);
    resolve_.set("corner", corner - guard_);
    resolve_.use();
    empty_array_.bind();
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

std::vector<glm::vec4> Accumulator::light() const {
    std::vector<glm::vec4> mean(static_cast<std::size_t>(sum_.size().x) * static_cast<std::size_t>(sum_.size().y));
    gl_.GetTextureImage(sum_.id(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(mean.size() * sizeof(glm::vec4)),
                        mean.data());
    std::vector<glm::vec4> inside;
    inside.reserve(static_cast<std::size_t>(shown().x) * static_cast<std::size_t>(shown().y));
    for (int y = guard_; y < sum_.size().y - guard_; ++y) {
        for (int x = guard_; x < sum_.size().x - guard_; ++x) {
            inside.push_back(mean[static_cast<std::size_t>(y) * static_cast<std::size_t>(sum_.size().x) +
                                  static_cast<std::size_t>(x)] /
                             static_cast<float>(samples_));
        }
    }
    return inside;
}

base::Image Accumulator::image() {
    if (!resolved_ || resolved_.size() != shown()) {
        resolved_ = gl::Texture::make_2d(gl_, GL_RGBA8, shown());
        resolved_target_.attach({&resolved_});
    }
    resolve(resolved_target_.id(), {0, 0});
    const glm::ivec2 size = shown();
    const auto row = static_cast<std::size_t>(size.x) * 4;
    const auto height = static_cast<std::size_t>(size.y);
    std::vector<std::uint8_t> pixels(row * height);
    gl_.GetTextureImage(resolved_.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()),
                        pixels.data());
    // OpenGL's rows go up, the image's down.
    base::Image image{size.x, size.y, std::vector<std::uint8_t>(pixels.size())};
    for (std::size_t y = 0; y < height; ++y) {
        std::copy_n(&pixels[y * row], row, &image.rgba[(height - 1 - y) * row]);
    }
    return image;
}

}  // namespace npr
