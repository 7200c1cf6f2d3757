// Per-pixel lists on OpenGL 4.5: every surface of every leaf along each ray, and the expressions walked once.
// The A-buffer (Carpenter 1984) and the per-pixel lists of Barta and Kovács (2011), turned to CSG; expressions in the
// linear form of Hable and Rossignac's Blister (2005).
//
// The leaves are drawn twice. The first pass counts the surfaces of each pixel; each pixel then takes its place in one
// buffer by one atomic addition; the second pass fills the lists. A compute shader takes the surfaces of a list nearest
// first, switches leaves, evaluates the expressions over the leaves that hold the point (blist.h), and stores a layer
// where a value changes. All layers of all parts come from that one walk, and there is no normalization.
//
// Memory is counted before it is allocated. What would pass the budget is split: the picture into bands of rows, a band
// into rectangles. Nothing is ever dropped: that every list holds what was counted is checked pixel by pixel.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "gl/view_block.h"
#include "goldfeather/draw_commands.h"
#include "goldfeather/leaf_buffers.h"
#include "goldfeather/lists/list_resolver.h"
#include "goldfeather/walk_stats.h"

namespace goldfeather {

/// A scene on the GPU, ready for the lists; it must outlive this.
struct ListsScene {
    /// `order`: of parts (part_order.h).
    ListsScene(const gl::Functions& gl, const csg::Scene& s, std::vector<csg::PartId> order)
        : scene(s), blist(gl, Blist(s, std::move(order))) {}
    const csg::Scene& scene;
    BlistBuffer blist;
};

class Lists {
  public:
    /// Compiles its programs, and tests the resolving ones on lists with known layers (list_self_test.h); throws
    /// gl::Error, also where they compute wrong. `gl` must outlive the engine. `memory_budget`: bytes of lists and of
    /// per-pixel state at once.
    explicit Lists(const gl::Functions& gl, std::size_t memory_budget = kDefaultMemoryBudget);

    /// Fills a stack with the first `max_layers` surfaces of the whole scene (kAllLayers: all of them). `leaves` holds
    /// the leaves of `geometry`. Throws gl::Error where a single pixel has more
    /// surfaces than OpenGL can hold, or where two passes over the same triangles disagree; base::Stopped where `stop`
    /// asked for it.
    [[nodiscard]] layers::TextureStack peel(const base::View& view, const csg::solid::Geometry& geometry,
                                            LeafBuffers& leaves, ListsScene& scene, int max_layers, WalkStats& stats,
                                            const std::stop_token& stop = {});

  private:
    /// Pixels of a band, from its lower left corner.
    struct Rectangle {
        glm::ivec2 first{0}, size{0};
        [[nodiscard]] std::size_t pixels() const {
            return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
        }
    };
    struct Job;
    void upload_draws(const Job& job);
    void draw(const Job& job, const gl::Program& program) const;
    void peel_band(Job& job);
    [[nodiscard]] std::vector<Rectangle> split(const Job& job, std::uint64_t surfaces) const;
    void peel_rectangle(Job& job, const Rectangle& rectangle);
    [[nodiscard]] ListStatus status() const;

    const gl::Functions& gl_;
    std::size_t memory_budget_, most_bytes_;  ///< … of one buffer.
    gl::Program prepare_, count_, allocate_, fill_;
    ListResolver resolver_;
    ListBuffers buffers_;
    gl::ViewBlock view_block_;
    gl::VertexArray leaf_array_;
    DrawCommands draws_;
    gl::Framebuffer target_;
    gl::Texture target_color_;
    gl::Query surfaces_;
    bool windings_tested_ = false;
    int layers_before_ = 4;  ///< Of the picture before: how many this one is likely to have.
};

}  // namespace goldfeather
