// The last step of the engine `lists`: from the lists of pixels to layers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stop_token>

#include "gl/program.h"
#include "goldfeather/lists/blist_buffer.h"
#include "layers/texture_stack.h"

namespace goldfeather {

/// Lists are resolved in classes, so that neighboring invocations have about as much to do: at most 8 surfaces, at
/// most 32, and more.
inline constexpr std::array<std::uint32_t, 2> kShortLists{8, 32};
inline constexpr std::size_t kListClasses = 3;

/// As in goldfeather/lists/lists.glsl.
struct PixelList {
    std::uint32_t count = 0, next = 0;
};
struct ListStatus {
    std::uint32_t entries = 0, longest = 0, most_layers = 0, faults = 0;
    std::array<std::uint32_t, kListClasses> class_sizes{};
    std::uint32_t unfinished = 0, overlong = 0;
};

/// Room behind a list: of the shortest none, of the others for where the walk stands, of long ones as much again for
/// the leaves that hold the point. As in goldfeather/lists/lists_allocate.comp.
[[nodiscard]] inline std::uint32_t list_room(std::uint32_t count) {
    return count <= kShortLists[0] ? count : 2 + (count <= kShortLists[1] ? count : 2 * count);
}

/// Of an entry's triangle: the surface is seen from inside its leaf.
inline constexpr std::uint32_t kFromBehind = 0x80000000U;

/// The storage blocks of goldfeather/lists/lists.glsl.
struct ListBuffers {
    explicit ListBuffers(const gl::Functions& gl) : pixels(gl), entries(gl), jobs(gl), status(gl) {}
    void bind() const;
    gl::Buffer pixels;   ///< PixelList by pixel of the band.
    gl::Buffer entries;  ///< uvec2: bits of the depth, triangle | kFromBehind.
    gl::Buffer jobs;     ///< uvec2: pixel, first entry; class after class.
    gl::Buffer status;   ///< ListStatus.
};

/// What lists are resolved into.
struct ListTarget {
    const layers::TextureStack& stack;
    int first_row = 0;  ///< Of the band in the picture.
    glm::ivec2 band_size{0};
    std::uint32_t layer_limit = 0;  ///< Wanted; the stack may hold fewer, and what it cannot hold is only counted.
    bool count_inside = false;      ///< Some leaf is counted from behind.
    bool windings = false;          ///< Some leaf has a winding number.
    std::uint32_t pause_after = 0;  ///< Iterations of loops after which a list waits for another go; 0: as needed.
};

class ListResolver {
  public:
    /// Takes its programs from `library`, where there must be goldfeather's and gl's files. Throws gl::Error.
    ListResolver(const gl::Functions& gl, gl::ShaderLibrary library);

    /// Resolves `class_sizes[c]` jobs from job c · `class_stride` on, and gives the status after that. The buffers and
    /// the rows of the triangles (block 8) are bound. Throws gl::Error where a list was not filled to its end, or where
    /// an event takes more work than the driver's loops do; base::Stopped where `stop` asked for it.
    [[nodiscard]] ListStatus resolve(const ListBuffers& buffers, const BlistBuffer& blist, const ListTarget& target,
                                     const std::array<std::uint32_t, kListClasses>& class_sizes,
                                     std::uint32_t class_stride, const std::stop_token& stop = {});

    /// goldfeather's and gl's shader files.
    [[nodiscard]] static gl::ShaderLibrary shaders();

  private:
    using Programs = std::array<gl::Program, kListClasses>;
    [[nodiscard]] Programs make_programs(bool windings) const;
    [[nodiscard]] const Programs& programs(bool windings);
    [[nodiscard]] ListStatus status(const ListBuffers& buffers) const;
    [[nodiscard]] std::uint32_t loop_limit() const;

    const gl::Functions& gl_;
    gl::ShaderLibrary library_;
    Programs programs_;
    std::optional<Programs> counting_;  ///< Of windings: made when they are first needed.
    std::uint32_t most_work_;           ///< Loop iterations of one invocation that the driver is relied on to run.
};

}  // namespace goldfeather
