// Expressions in linear form on the GPU.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gl/program.h"
#include "goldfeather/blist.h"

namespace goldfeather {

/// The rows of a Blist as goldfeather/lists/blist.glsl reads them.
class BlistBuffer {
  public:
    BlistBuffer(const gl::Functions& gl, const Blist& blist);

    /// Of a leaf.
    enum Flag : std::uint32_t {
        kBehind = 1,  ///< A ray may begin inside of it: that is counted from behind.
        kWound = 2,   ///< Its inside is where its winding number is not zero, not where the parity says so.
    };
    /// Flags by LeafId. Uploads only what has changed.
    void set_flags(std::span<const std::uint32_t> flags);
    /// Binds storage block 6 and sets the uniforms of a program that includes goldfeather/lists/blist.glsl and
    /// goldfeather/lists/resolve_lists.glsl.
    void bind(const gl::Program& program) const;

  private:
    void upload();

    gl::Buffer rows_;
    std::vector<Blist::Leaf> leaves_;
    std::vector<glm::uvec4> others_;  ///< Rows of groups and of parts.
    std::uint32_t first_group_, first_start_, parts_;
};

}  // namespace goldfeather
