#include "npr/painter/cpu_ink.h"

#include <algorithm>
#include <cmath>

namespace npr {

static_assert(Tiles::kSide == 32, "a row's pixels are the bits of a word");

void TileInk::draw(int tile, shader::Frame& rules) {
    box_ = tiles_.bounds(tile);
    near_.fill(0);
    drawn_ = 0;
    tiles_.for_each_about(tile, [&](int other) {
        for (const CpuEdge& edge : edges_[static_cast<std::size_t>(other)]) {
            if (reaches(edge)) {
                spread(edge, rules);
            }
        }
    });
}

TileInk::Pen TileInk::pen_of(const CpuEdge& edge, shader::Frame& rules) const {
    if (!lines_.facts) {
        const bool hidden = edge.layer > 0 && !lines_.visible_only;
        return {hidden         ? lines_.hidden_width
                : edge.profile ? lines_.width
                               : lines_.inner_width,
                edge.profile ? lines_.profile_strength : lines_.inner_strength};
    }
    const LineFacts facts = rules.unpack_facts(edge.facts);
    const LineType& row = lines_.types.rows[static_cast<std::size_t>(rules.type_of_line(facts))];
    const shader::LineCode::LineType type{row.width, row.strength, row.dash, row.gap};
    // Styles that draw visible lines only have strengths by kinds of edges.
    const bool outline = edge.profile || facts.kind == rules.kSectionEdge;
    const float strength = !lines_.visible_only ? type.strength
                           : outline            ? lines_.profile_strength
                                                : lines_.inner_strength;
    return {type.width * lines_.width * rules.weight_by_distance(facts, lines_.taper) *
                rules.weight_by_end(facts, lines_.halo_gap, lines_.taper_ends),
            strength * rules.pattern_ink(type, facts, lines_.line_unit) * rules.halo_ink(facts, lines_.halo_gap)};
}

void TileInk::spread(const CpuEdge& edge, shader::Frame& rules) {
    const glm::ivec2 lo = glm::max(edge.lower - reach_, box_.lo), hi = glm::min(edge.lower + reach_ + 2, box_.hi);
    if ((drawn_ >> edge.layer & 1U) == 0) {
        drawn_ |= 1U << edge.layer;
        std::fill_n(ink_.begin() + static_cast<std::ptrdiff_t>(at(edge.layer, {0, 0})), kPixels, 0.0F);
    }
    const Pen pen = pen_of(edge, rules);
    const float width = pen.width;
    const float strength = pen.strength * (lines_.hard ? 1 : rules.thin_ink(edge.thickness, width));
    // Farther away there is no ink, by more than rounding.
    const float reach = lines_.hard ? 1e9F
                                    : (0.5F * width + 0.5F) * (0.5F * width + 0.5F) * 1.001F + 0.71F * 0.71F +
                                          1.42F * (0.5F * width + 0.5F);
    for (int y = lo.y; y < hi.y; ++y) {
        float* row = &ink_[at(edge.layer, {0, y - box_.lo.y})];
        for (int x = lo.x; x < hi.x; ++x) {
            const glm::vec2 from_point = glm::vec2(x, y) - edge.at;
            if (glm::dot(from_point, from_point) > reach) {
                continue;
            }
            const float coverage = lines_.hard ? rules.hard_piece(from_point, edge.across, width)
                                               : rules.piece(from_point, edge.across, width);
            if (coverage > 0) {
                const int in_tile = x - box_.lo.x;
                row[in_tile] = std::max(row[in_tile], strength * coverage);
                near_[static_cast<std::size_t>(y - box_.lo.y)] |= 1U << in_tile;
            }
        }
    }
}

}  // namespace npr
