// From the triangles that reach a tile to the layers of its pixels. Internal to lists_cpu.
#pragma once

#include <array>
#include <mutex>
#include <span>
#include <vector>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/lists_cpu/pixel_walk.h"
#include "goldfeather/lists_cpu/projected_leaves.h"
#include "goldfeather/lists_cpu/screen_triangles.h"
#include "goldfeather/lists_cpu/tile_spans.h"

namespace goldfeather {

/// The triangles that reach each tile, of those that are drawn.
struct Bins {
    glm::ivec2 tiles{0};
    std::vector<std::uint32_t> starts;     ///< One more than tiles.
    std::vector<std::uint32_t> triangles;  ///< Indices, in order, tile after tile.

    [[nodiscard]] std::span<const std::uint32_t> of(int tile) const {
        const auto i = static_cast<std::size_t>(tile);
        return std::span(triangles).subspan(starts[i], starts[i + 1] - starts[i]);
    }
};

/// What the threads of one picture share.
struct ListsJob {
    const ListsModel& model;
    glm::ivec2 size;
    int max_layers;
    layers::HostStack& out;
    const std::stop_token& stop;
    const ProjectedLeaves& leaves;
    const std::vector<base::View::ExactPlaneDepth>& planes;
    const std::vector<std::uint32_t>& ranks;  ///< Of parts: as PixelWalk wants them.
    Bins bins{};
    std::mutex growing{};  ///< Of out.planes.
};

/// One thread's. A row of a tile is swept from left to right: the triangles that cover a pixel are kept sorted by depth
/// while spans begin and end. Runs of pixels that meet the same triangles in the same order are sorted and walked once.
class TileWorker {
  public:
    explicit TileWorker(ListsJob& job);

    /// Writes every pixel of the tile, in all layers that hold or held anything there. Where the job is stopped the
    /// tile is taken to hold something in every layer.
    void run(int tile);

    [[nodiscard]] std::uint64_t fragments() const { return fragments_; }
    [[nodiscard]] std::size_t longest_list() const { return longest_list_; }
    /// By leaf: 1 where some layer of some pixel is a surface of it.
    [[nodiscard]] const std::vector<char>& seen() const { return seen_; }

  private:
    struct Target {
        float* depth;
        glm::uvec2* surface;
    };
    /// A triangle in the row: its depth at the sample x is `slope` · x + `base`, kept between `least` and
    /// `most`.
    struct Slot {
        double slope, base, least, most;
        int last;  ///< The last pixel, from the tile's corner.
    };
    void fill(const TileBox& box, std::span<const std::uint32_t> triangles);
    void row(const TileBox& box, int y);
    void enter(std::uint32_t triangle, int last, int y);
    /// Makes sorted_ the fragments of the pixel at `x` in the picture, `at` from the tile's corner.
    void advance(int x, int at);
    void index_entering();
    [[nodiscard]] bool take_entering(Fragment& f);
    void forget_entering();
    void sort(std::size_t entered);
    /// The pixels from x on, at most `length`, that have the order and the events of the first.
    [[nodiscard]] int same_order(int x, int length) const;
    [[nodiscard]] bool same_order(int x) const;
    void write(int x, int y, int length);
    /// `sample`: in pixels from the middle of the picture.
    [[nodiscard]] static double depth(const Slot& slot, double sample);
    void count_layers(const TileBox& box);
    void clear(std::size_t pixel, int first, int end);
    void reserve(std::size_t layers);
    void give_up(const TileBox& box);
    /// Layers that the job's output has room for.
    [[nodiscard]] int room() const;

    ListsJob& job_;
    double half_width_, half_height_;  ///< Of the picture, in pixels.
    TileSpans spans_;
    PixelWalk walk_;
    std::vector<Fragment> sorted_;
    std::vector<Fragment> entering_;          ///< Of spans that begin in the pixel.
    std::vector<std::uint32_t> entering_of_;  ///< By leaf: 1 + its place in entering_, 0 where there is none.
    std::vector<Slot> slots_;                 ///< Of the row.
    std::vector<Target> targets_;             ///< By layer.
    std::array<int, TileSpans::kPixels> layers_{};
    int tile_layers_ = 0;
    std::vector<char> seen_;
    std::uint64_t fragments_ = 0;
    std::size_t longest_list_ = 0;
};

}  // namespace goldfeather
