// The edge map: where the surfaces of each layer end or bend (Nienhaus 2005, chapter 4; 5.6 for results of CSG).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "npr/edges/edge_parameters.h"
#include "npr/edges/line_code.h"
#include "npr/frame_program.h"

namespace npr {

/// R32UI: a texel for each of the tiles for which marks of a picture's edges are summed up (npr/edges/edge_point.glsl).
[[nodiscard]] gl::Texture make_edge_tiles(const gl::Functions& gl, glm::ivec2 size);

/// Groups of 64 that hold so many invocations.
[[nodiscard]] constexpr GLuint groups(std::uint32_t invocations) {
    return (invocations + 63) / 64;
}

/// One point of an edge, in main memory.
struct HostEdge {
    glm::vec2 at{0};      ///< In pixels from the lower left corner of the picture; pixel centers at halves.
    glm::vec2 across{0};  ///< Unit vector across the edge, either way.
    int layer = 0;        ///< The last of layers::kLayersApart is that of all deeper ones, too.
    bool profile = false;
    LineFacts facts = shader::LineCode().no_facts();  ///< Where they were asked for.
};

/// Finds the edges of all layers, once per frame, from which lines of any width are drawn (npr/edges/lines.glsl).
///
/// As in chapter 4, edges are discontinuities between neighboring pixels of a layer: profile edges where the surface
/// ends, inner edges where it bends. Thresholds on depth, which hide edges of touching parallel faces and draw false
/// ones on slanted faces, are not needed: the stack of layers knows each surface's plane, so that a surface is found
/// again in the neighbor whatever its layer is there, and two planes that meet between two pixels meet in a known
/// point. Edges are those of the result (5.6): inner edges are creases between two fronts or two backs; a profile edge
/// is where front meets back, and belongs to the front's layer.
///
/// The map holds, per layer and per link between two pixels' samples, that point, the direction across the edge, and
/// the kind: 32 bits, by which lines are smooth at one sample per pixel. What else is known of a line is found in one
/// more pass over the candidates where it is asked for, and costs nothing otherwise.
class EdgeMap {
  public:
    /// Throws gl::Error. `gl` must outlive the map.
    explicit EdgeMap(const gl::Functions& gl);

    /// Finds the edges of the frame's layers, and binds the map to texture units 2 to 4, and 8, for
    /// npr/edges/lines.glsl.
    void draw(const Frame& frame, const EdgeSettings& settings);

    /// The same textures, and the list of links whose ends see different planes (edges are only on these), as storage
    /// block 2.
    void bind() const;
    /// Waits for the GPU and copies the edge points of the last frame drawn, in order of layers and pixels.
    [[nodiscard]] std::vector<HostEdge> read_back() const;
    /// How many links are listed.
    [[nodiscard]] std::uint32_t links() const { return link_count_; }

  private:
    void resize(glm::ivec2 size, int layers);
    std::uint32_t list_links(const Frame& frame);
    /// Returns how many candidates there are; those for which there is room are listed.
    std::uint32_t list_candidates(const Frame& frame, std::uint32_t links);
    void find_facts(const Frame& frame, const EdgeSettings& settings, std::uint32_t candidates);

    const gl::Functions& gl_;
    FrameProgram find_links_;
    FrameProgram find_candidates_;
    FrameProgram find_edges_;
    std::optional<FrameProgram> find_facts_;  ///< Made when first asked for.
    gl::Buffer links_;                        ///< Their count, and the links whose ends see different planes.
    gl::Buffer candidates_;  ///< Their count, room for so many, and surfaces that may have edges on a link.
    std::uint32_t room_ = 1U << 16;
    std::uint32_t link_count_ = 0;
    glm::vec2 jitter_{0};
    gl::Texture marks_;   ///< R32UI: which layers have an edge on the pixel's link to the right, and up.
    gl::Texture tiles_;   ///< R32UI: the same for small tiles.
    gl::Texture points_;  ///< R32UI array: edge points (npr/edges/edge_point.glsl), two slices per layer.
    gl::Texture facts_;   ///< R32UI array: npr/edges/line_facts.glsl, two slices per slice of points; where asked for.
    bool has_facts_ = false;
};

}  // namespace npr
