// From the triangles that reach a tile to the layers of its pixels. Internal to lists_cpu.
#pragma once

#include <array>
#include <mutex>
#include <span>
#include <vector>

#include "goldfeather/lists_cpu.h"
#include "goldfeather/pixel_walk.h"
#include "goldfeather/screen_triangles.h"
#include "goldfeather/tile_lists.h"

namespace goldfeather {

/// The triangles that reach each tile.
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
    CpuLayers& out;
    std::vector<ScreenTriangle> triangles{};
    std::vector<gl::View::ExactPlaneDepth> planes{};
    std::vector<char> counted_from_behind{};
    Bins bins{};
    std::mutex growing{};  ///< Of out.planes.
};

/// One thread's. Runs of pixels in a row that meet the same triangles in the same order are sorted and walked once.
class TileWorker {
  public:
    explicit TileWorker(ListsJob& job);

    /// Writes every pixel of the tile, in all layers that hold or held anything there.
    void run(int tile);

    [[nodiscard]] std::uint64_t fragments() const { return fragments_; }
    [[nodiscard]] std::uint32_t longest_list() const { return longest_list_; }
    [[nodiscard]] int most_layers() const { return most_layers_; }

  private:
    struct Target {
        float* depth;
        glm::uvec2* surface;
    };
    /// A run of pixels in a row: `at` in the lists, `layers_at` in the tile, `target` in the picture.
    struct Run {
        int at, layers_at;
        std::size_t target;
        int length;
    };
    void fill(const TileBox& box, std::span<const std::uint32_t> triangles);
    void row(const TileBox& box, int y);
    /// Draws as much of the run as has the order of its first pixel, and gives how much that was.
    int draw(const Run& run, std::uint32_t count);
    void sort(int at, std::uint32_t count);
    [[nodiscard]] bool same_order(int at) const;
    void clear_below(const TileBox& box, int layers);
    void reserve(std::size_t layers);

    ListsJob& job_;
    TileLists lists_;
    PixelWalk walk_;
    std::vector<Fragment> sorted_;
    std::vector<std::uint32_t> order_;  ///< Of sorted_: positions in the pixel's list.
    std::vector<Target> targets_;       ///< By layer.
    std::array<int, TileLists::kPixels> layers_{};
    int tile_layers_ = 0;
    int most_layers_ = 0;
    std::uint64_t fragments_ = 0;
    std::uint32_t longest_list_ = 0;
};

}  // namespace goldfeather
