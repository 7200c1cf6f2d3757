// Sequenced convex subtraction: Stewart, Leach, John: An improved z-buffer CSG rendering algorithm (1998); A single
// z-buffer implementation of constructive solid geometry with convex objects (2000).
//
// For products whose leaves are all convex. A ray meets a convex leaf in one interval, so a product is first true where
// the last of its intersected leaves is entered, or further behind, where it comes out of subtracted leaves that cover
// that point: subtracting them one after the other moves the depth back from one's front to its back. A sequence of
// subtractions that holds every order of the leaves as a subsequence finds the way out of any overlap. Here the
// sequence is the leaves from front to back, again and again until a round moves no pixel: mostly there are two rounds.
// Leaves that are apart on the screen are subtracted together.
//
// The method finds where the ray first enters the result, and no more: one layer, with the eye outside of every leaf.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/program.h"
#include "gl/view_block.h"
#include "goldfeather/goldfeather/part_products.h"
#include "goldfeather/leaf_buffers.h"
#include "goldfeather/walk_stats.h"
#include "layers/texture_stack.h"

namespace goldfeather {

class Scs {
  public:
    /// Compiles its programs; throws gl::Error. `gl` must outlive the engine. `memory_budget`: bytes of per-pixel state
    /// before the picture is split into bands.
    explicit Scs(const gl::Functions& gl, std::size_t memory_budget = kDefaultMemoryBudget);

    /// Why the method cannot draw the products from this view; empty where it can.
    [[nodiscard]] static std::string obstacle(const base::View& view, const csg::solid::Geometry& geometry,
                                              std::span<const Product> products, int max_layers);

    /// Fills a stack with the first surfaces of the part; there must be no obstacle. `leaves` holds the scene's leaves,
    /// `tables` what the ids stand for. Throws base::Stopped where `stop` asked for it.
    [[nodiscard]] layers::TextureStack peel(const base::View& view, LeafBuffers& leaves, const PartProducts& part,
                                            WalkStats& stats, const std::stop_token& stop = {});

  private:
    struct Rectangle;
    struct Group;
    struct PlannedProduct;
    struct Band;
    [[nodiscard]] static std::vector<PlannedProduct> plan(const base::View& view, const PartProducts& part,
                                                          WalkStats& stats);
    void draw_product(const PlannedProduct& product, const Band& band, WalkStats& stats);
    void subtract(const PlannedProduct& product, const Band& band, WalkStats& stats);
    void draw_leaves(const gl::Program& program, std::span<const csg::LeafId> ids, const Band& band,
                     WalkStats& stats) const;
    void for_pixels(const gl::Program& program, const Rectangle& rectangle, const Band& band) const;

    const gl::Functions& gl_;
    std::size_t memory_budget_;
    gl::Program prepare_, begin_, intersect_, mark_, advance_, identify_, merge_, store_;
    gl::ViewBlock view_block_;
    gl::VertexArray leaf_array_;
    gl::Buffer pixels_;
    gl::Framebuffer target_;
    gl::Texture target_color_;
    gl::Query moved_;
};

}  // namespace goldfeather
