#include "npr/painter/cpu_edges.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/parallel.h"
#include "npr/painter/cpu_tiles.h"
#include "npr/painter/memo.h"
#include "npr/shader_frame.h"

namespace npr {
namespace shader {

struct PlaneFrame : Frame {
    using Frame::Frame;
#include "npr/plane_lookup.glsl"
};

/// The compute shaders of the edge map, for one link after the other.
struct EdgeSearch : PlaneFrame {
    EdgeSearch(const CpuFrame& frame, const EdgeSettings& settings)
        : PlaneFrame(frame),
          part_edges(settings.parts),
          visible_only(settings.visible_only),
          follow_borders(settings.follow_borders),
          facts(settings.facts),
          clearances(settings.clearances),
          crease_angle(radians(settings.crease_degrees)) {}

    bool part_edges, visible_only, follow_borders, facts, clearances;
    float crease_angle;

#include "npr/edges/same_surface.glsl"

    vec2 depth_gradient(uint plane) {
        return gradients.of(plane, [&] { return PlaneFrame::depth_gradient(plane); });
    }
    uint surface_bits(ivec2 p) {
        return bits.of(index(p), [&] { return PlaneFrame::surface_bits(p); });
    }
    int layer_of(ivec2 p, uint key) {
        return (surface_bits(p) & bit_of(uvec2(0, key))) == 0U ? -1 : PlaneFrame::layer_of(p, key);
    }

    /// All pixels that are asked for are in the picture.
    Surface layer_surface(ivec2 p, int layer, vec3 ray) {
        const uvec2 ids = surface_ids(p, layer);
        return ids.x == kNoSurface ? no_surface()
                                   : surface_of(ids, depths[static_cast<std::size_t>(layer)][index(p)], ray);
    }

#include "npr/planes.glsl"

    /// Planes go on in the same layer most often; what does not is asked for again, since links follow the same
    /// borders.
    Continuation continuation_at(ivec2 pixel, int layer, ivec2 offset) {
        if (const uvec2 there = surface_ids(pixel + offset, layer);
            there.x != kNoSurface && there.y == surface_ids(pixel, layer).y) {
            return {true, layer, 1, 0.5F, vec2(offset)};
        }
        const auto way = static_cast<std::size_t>(offset.x + 2 * offset.y + 2);
        return continuations.of((index(pixel) << 19U) + (static_cast<std::size_t>(layer) << 3U) + way, [&] {
            return continuation(layer_surface(pixel, layer, pixel_ray(pixel)), pixel, offset);
        });
    }

#include "npr/edges/creases.glsl"

#include "npr/edges/edge_search.glsl"

#include "npr/edges/contour.glsl"

#include "npr/edges/edge_rules.glsl"

#include "npr/edges/line_rules.glsl"

    void add(uint, int layer, uint end) {
        candidates.push_back({layer, end != 0U});
    }

    /// Do the ends of the link see different surfaces?
    [[nodiscard]] bool differs(ivec2 p, ivec2 q) {
        for (int i = 0;; ++i) {
            const uvec2 a = surface_ids(p, i);
            if (a != surface_ids(q, i)) {
                return true;
            }
            if (a.x == kNoSurface || (visible_only && opaque(a))) {
                return false;
            }
        }
    }

    void link(ivec2 p, int axis, std::vector<CpuEdge>& edges) {
        const ivec2 step(1 - axis, axis);
        candidates.clear();
        search_link(0, p, p + step);
        const auto first = static_cast<std::ptrdiff_t>(edges.size());
        for (const Candidate& c : candidates) {
            const ivec2 from = c.upper ? p + step : p, onward = c.upper ? -step : step;
            const FoundEdge e = edge_of(c.layer, from, onward);
            if (e.found) {
                const float at = clamp(e.point.at, 0.0F, 1.0F);
                keep({p, vec2(p) + (c.upper ? 1.0F - at : at) * vec2(step), e.point.across,
                      static_cast<std::uint8_t>(axis), static_cast<std::uint8_t>(edge_layer(e.layer)),
                      e.point.kind == kProfileEdge, e.point.thickness,
                      facts ? pack_facts(line_facts(c.layer, from, onward, e)) : uvec2(0)},
                     edges, first);
            }
        }
    }

  private:
    struct Candidate {
        int layer;
        bool upper;
    };

    /// One edge a link and layer: profile edges win, then thicker ones, then that farther along the link. Found from
    /// both ends of the link alike, it has the larger words of both facts, as in npr/edges/edge_facts.comp.
    void keep(const CpuEdge& edge, std::vector<CpuEdge>& edges, std::ptrdiff_t first) {
        const auto same =
            std::find_if(edges.begin() + first, edges.end(), [&](const CpuEdge& e) { return e.layer == edge.layer; });
        const auto rank = [](const CpuEdge& e) {
            return std::tuple(e.profile, std::lround(e.thickness * 1023), e.at.x + e.at.y);
        };
        if (same == edges.end()) {
            edges.push_back(edge);
            return;
        }
        const bool alike = facts && packed(edge) == packed(*same);
        const uvec2 larger = max(edge.facts, same->facts);
        if (rank(edge) > rank(*same)) {
            *same = edge;
        }
        if (alike) {
            same->facts = larger;
        }
    }

    uint packed(const CpuEdge& e) {
        return pack_edge(edge_point(e.profile ? kProfileEdge : kInnerEdge, e.thickness,
                                    e.at[e.axis] - static_cast<float>(e.lower[e.axis]), e.across));
    }

    std::vector<Candidate> candidates;
    Memo<vec2, 10> gradients;              ///< By plane.
    Memo<uint, 12> bits;                   ///< By pixel.
    Memo<Continuation, 12> continuations;  ///< By pixel, layer and way on.
};

}  // namespace shader

namespace {

/// For the pixels of a tile's row: bit 0 where the link to the right may have edges, bit 1 where the link up may.
using Row = std::array<std::uint8_t, layers::HostStack::kTileSide>;

class TileSearch {
  public:
    TileSearch(const CpuFrame& frame, const EdgeSettings& settings) : tiles_(frame.layers), search_(frame, settings) {}

    void run(int tile, std::vector<CpuEdge>& edges) {
        const TileBounds box = tiles_.bounds(tile);
        const int layers = tiles_.held_about(tile);
        if (layers == 0) {
            return;
        }
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            const Row links = search_.visible_only ? visible_links(box, y) : all_links(box, y, layers);
            for (int x = box.lo.x; x < box.hi.x; ++x) {
                const std::uint8_t open = links[static_cast<std::size_t>(x - box.lo.x)];
                for (int axis = 0; axis < 2; ++axis) {
                    if ((open >> axis & 1) != 0) {
                        search_.link({x, y}, axis, edges);
                    }
                }
            }
        }
    }

  private:
    /// Compares whole rows, layer by layer: most links see the same on both ends.
    Row all_links(const TileBounds& box, int y, int layers) {
        const auto count = static_cast<std::size_t>(box.hi.x - box.lo.x);
        const bool last_column = box.hi.x == search_.size.x, last_row = y + 1 == search_.size.y;
        std::array<std::uint64_t, layers::HostStack::kTileSide> right{}, up{};
        for (int layer = 0; layer < layers; ++layer) {
            const glm::uvec2* row = search_.surfaces[static_cast<std::size_t>(layer)] + search_.index({box.lo.x, y});
            const glm::uvec2* above = last_row ? row : row + search_.size.x;
            for (std::size_t x = 0; x < count; ++x) {
                up[x] |= bits(row[x]) ^ bits(above[x]);
            }
            for (std::size_t x = 0; x + (last_column ? 1 : 0) < count; ++x) {
                right[x] |= bits(row[x]) ^ bits(row[x + 1]);
            }
        }
        Row links{};
        for (std::size_t x = 0; x < count; ++x) {
            links[x] = static_cast<std::uint8_t>((right[x] != 0 ? 1 : 0) | (up[x] != 0 ? 2 : 0));
        }
        return links;
    }

    /// Compares no farther than to the first opaque surface.
    Row visible_links(const TileBounds& box, int y) {
        Row links{};
        for (int x = box.lo.x; x < box.hi.x; ++x) {
            const bool right = x + 1 < search_.size.x && search_.differs({x, y}, {x + 1, y});
            const bool up = y + 1 < search_.size.y && search_.differs({x, y}, {x, y + 1});
            links[static_cast<std::size_t>(x - box.lo.x)] = static_cast<std::uint8_t>((right ? 1 : 0) | (up ? 2 : 0));
        }
        return links;
    }

    static std::uint64_t bits(const glm::uvec2& ids) { return std::bit_cast<std::uint64_t>(ids); }

    Tiles tiles_;
    shader::EdgeSearch search_;
};

}  // namespace

CpuEdges find_edges(const CpuFrame& frame, const EdgeSettings& settings) {
    CpuEdges edges(static_cast<std::size_t>(Tiles(frame.layers).count()));
    base::for_each_index(
        static_cast<int>(edges.size()),
        [&] {
            return [&edges, search = TileSearch(frame, settings)](int tile) mutable {
                search.run(tile, edges[static_cast<std::size_t>(tile)]);
            };
        },
        0, frame.stop);
    return edges;
}

}  // namespace npr
