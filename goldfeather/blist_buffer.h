// Expressions in linear form on the GPU.
#pragma once

#include <span>
#include <vector>

#include "gl/program.h"
#include "goldfeather/blist.h"

namespace goldfeather {

/// The rows of a Blist as goldfeather/blist.glsl reads them.
class BlistBuffer {
  public:
    BlistBuffer(const gl::Functions& gl, const Blist& blist);

    /// Which leaves (by LeafId) a ray may begin inside of. Uploads only what has changed.
    void count_from_behind(std::span<const char> leaves);
    /// Binds storage block 6 and sets the uniforms of a program that includes goldfeather/blist.glsl and
    /// goldfeather/resolve_lists.glsl.
    void bind(const gl::Program& program) const;

  private:
    gl::Buffer rows_;
    std::vector<Blist::Leaf> leaves_;
    std::vector<glm::uvec4> others_;  ///< Rows of groups and of parts.
    std::uint32_t first_group_, first_start_, parts_;
};

}  // namespace goldfeather
