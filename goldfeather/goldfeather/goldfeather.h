// Goldfeather's algorithm with visibility transfer, on OpenGL 4.5.
//
// Goldfeather 1989: a surface of a literal is visible where the parity of every other literal of its product agrees.
// Wiegand 1996; Kirsch and Döllner 2004, 2005: visibility is carried to the merge in a texture.
//
// As built here, the candidate layers of all products of a part are peeled together, front to back, a "walk" of every
// pixel along its ray. The parity of all leaves is kept in one bit each (of leaves whose
// shells may overlap, the winding number in a word) and toggled from event to event instead of
// being counted again for every candidate; leaves that do not touch on the screen share a bit (screen_plan.h). After
// each event the sum of products is evaluated by tiles, and where its value changes the pixel stores the next layer as
// discrete ids (leaf, orientation, plane). So layer k+1 continues where layer k ended, faces that coincide are one
// event by construction (their depths are bit-equal), and all layers cost one walk. A geometry pass toggles an event
// and finds the next one at the same time. docs/ENGINES.md tells why this replaced one pass per literal and layer.
#pragma once

#include <memory>
#include <optional>

#include "gl/context.h"
#include "gl/program.h"
#include "gl/view_block.h"
#include "goldfeather/draw_commands.h"
#include "goldfeather/goldfeather/part_products.h"
#include "goldfeather/goldfeather/screen_plan.h"
#include "goldfeather/leaf_buffers.h"
#include "goldfeather/walk_stats.h"
#include "layers/texture_stack.h"

namespace goldfeather {

class Goldfeather {
  public:
    /// Compiles its programs; throws gl::Error. `gl` must outlive the engine. `memory_budget`: bytes of per-pixel
    /// state before the picture is split into bands. `minimal_fraction`: a walk ends where fewer than that share of
    /// the pixels have anything ahead, and what is there is left out (Nienhaus 2005, 5.2).
    explicit Goldfeather(const gl::Functions& gl, std::size_t memory_budget = kDefaultMemoryBudget,
                         double minimal_fraction = 0);
    ~Goldfeather();

    /// Fills a stack with the first `max_layers` surfaces of the part (kAllLayers: all of them).
    /// `leaves` holds the scene's leaves.
    /// Throws base::Stopped where `stop` asked for it.
    [[nodiscard]] layers::TextureStack walk(const base::View& view, LeafBuffers& leaves, const PartProducts& part,
                                            int max_layers, WalkStats& stats, const std::stop_token& stop = {});

  private:
    struct Band;
    /// The passes. Those that count winding numbers are made when a scene first needs them, so that no other pays.
    struct Programs {
        gl::Program geometry, resolve;
    };
    [[nodiscard]] Programs make_programs(bool counters) const;
    [[nodiscard]] const Programs& programs(bool counters);
    /// Gives the most layers that a pixel of the band has.
    int draw_band(const Band& band, layers::TextureStack& stack, int max_layers, WalkStats& stats,
                  const std::stop_token& stop);
    [[nodiscard]] int most_layers(std::size_t pixel_count) const;
    void upload(const ScreenPlan& plan, const LeafBuffers& leaves, std::span<const char> open);

    const gl::Functions& gl_;
    std::size_t memory_budget_;
    double minimal_fraction_;
    gl::Program prepare_;
    Programs programs_;
    std::optional<Programs> counting_;
    gl::ViewBlock view_block_;
    gl::VertexArray leaf_array_, tile_array_;
    gl::Buffer draw_ids_, tiles_;
    DrawCommands leaf_draws_, tile_draws_;
    gl::Buffer products_, entries_, tile_products_, tile_leaves_;
    gl::Buffer pixels_, inside_bits_, toggled_bits_;
    gl::Texture next_depth_;
    gl::Framebuffer geometry_target_, resolve_target_;
    gl::Texture resolve_color_;
    gl::Query candidates_, filled_;
};

}  // namespace goldfeather
