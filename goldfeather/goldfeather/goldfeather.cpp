#include "goldfeather/goldfeather/goldfeather.h"

#include <algorithm>
#include <limits>

#include "base/stop.h"
#include "goldfeather/goldfeather_shaders.h"
#include "goldfeather/lists_cpu/screen_triangles.h"

namespace goldfeather {
namespace {

/// Binding points of the storage buffers, as in goldfeather/*.glsl.
enum Binding : GLuint { kPixels = 2, kInsideBits, kToggledBits, kProducts, kEntries, kTileProducts, kTileLeaves = 9 };

struct LeafSlotRow {
    PixelBox box;
    glm::uvec4 leaf;
};

struct ProductRow {
    PixelBox box;
    glm::uvec4 entries;
};

struct TileRow {
    PixelBox box;
    glm::uvec4 lists;
};

/// As in goldfeather/goldfeather/walk.glsl.
struct PixelState {
    float current;
    std::uint32_t found, plane, unused;
};

gl::ShaderLibrary shaders() {
    gl::ShaderLibrary library;
    library.add(gl::shader_files());
    library.add(layers::shader_files());
    library.add(goldfeather::shader_files());
    return library;
}

/// Tiles that are resolved at once where it may have to stop in between.
constexpr GLuint kPieceTiles = 64;

/// Can the near plane be inside a leaf?
bool eye_among(const base::View& view, const ScreenPlan& plan, std::span<const csg::Box> boxes) {
    return std::any_of(plan.leaves.begin(), plan.leaves.end(),
                       [&](const PlannedLeaf& leaf) { return near_plane_cuts(view, boxes[leaf.leaf]); });
}

}  // namespace

/// Rows of the picture that are walked at once.
struct Goldfeather::Band {
    glm::ivec2 size;
    int first_row = 0;
    glm::ivec2 picture;
    std::uint32_t words = 0, first_counter = 0;
    bool count_inside = false;
    const Programs& programs;
};

Goldfeather::Goldfeather(const gl::Functions& gl, std::size_t memory_budget, double minimal_fraction)
    : gl_(gl),
      memory_budget_(memory_budget),
      minimal_fraction_(minimal_fraction),
      prepare_(gl, shaders(), {"goldfeather/prepare.comp"}),
      programs_(make_programs(false)),
      view_block_(gl),
      leaf_array_(gl),
      tile_array_(gl),
      draw_ids_(gl),
      tiles_(gl),
      leaf_draws_(gl),
      tile_draws_(gl),
      products_(gl),
      entries_(gl),
      tile_products_(gl),
      tile_leaves_(gl),
      pixels_(gl),
      inside_bits_(gl),
      toggled_bits_(gl),
      geometry_target_(gl),
      resolve_target_(gl),
      candidates_(gl, GL_SAMPLES_PASSED),
      filled_(gl, GL_SAMPLES_PASSED) {
    gl.EnableVertexArrayAttrib(leaf_array_.id(), 0);
    gl.VertexArrayAttribIFormat(leaf_array_.id(), 0, 2, GL_UNSIGNED_INT, 0);
    gl.VertexArrayAttribBinding(leaf_array_.id(), 0, 0);
    gl.VertexArrayBindingDivisor(leaf_array_.id(), 0, 1);
    LeafBuffers::describe_positions(gl, leaf_array_);
    for (GLuint i = 0; i < 2; ++i) {
        gl.EnableVertexArrayAttrib(tile_array_.id(), i);
        gl.VertexArrayAttribIFormat(tile_array_.id(), i, 4, GL_UNSIGNED_INT,
                                    i * static_cast<GLuint>(sizeof(glm::uvec4)));
        gl.VertexArrayAttribBinding(tile_array_.id(), i, 0);
    }
    gl.VertexArrayBindingDivisor(tile_array_.id(), 0, 1);
}

Goldfeather::~Goldfeather() = default;

Goldfeather::Programs Goldfeather::make_programs(bool counters) const {
    const gl::Defines defines{{"kCounters", counters ? "true" : "false"}};
    return {gl::Program(gl_, shaders(), {"goldfeather/leaf.vert", "goldfeather/goldfeather/walk.frag"}, defines),
            gl::Program(gl_, shaders(), {"goldfeather/goldfeather/tile.vert", "goldfeather/goldfeather/resolve.frag"},
                        defines)};
}

const Goldfeather::Programs& Goldfeather::programs(bool counters) {
    if (counters && !counting_) {
        counting_ = make_programs(true);
    }
    return counters ? *counting_ : programs_;
}

void Goldfeather::upload(const ScreenPlan& plan, const LeafBuffers& leaves, std::span<const char> open) {
    std::vector<glm::uvec2> ids;
    std::vector<DrawCommand> commands;
    for (const PlannedLeaf& leaf : plan.leaves) {
        const LeafBuffers::Range range = leaves.ranges()[leaf.leaf];
        if (range.vertex_count == 0) {
            continue;
        }
        add_triangles(commands, range.first_vertex, range.vertex_count, static_cast<GLuint>(ids.size()));
        ids.emplace_back(leaf.slot, open.empty() || open[leaf.leaf] == 0 ? 1U : 0U);
    }
    draw_ids_.upload<glm::uvec2>(ids, GL_STREAM_DRAW);
    leaf_draws_.upload(commands, kPieceVertices);
    gl_.VertexArrayVertexBuffer(leaf_array_.id(), 0, draw_ids_.id(), 0, sizeof(glm::uvec2));

    std::vector<ProductRow> products;
    for (const PlannedProduct& p : plan.products) {
        products.push_back({p.box, {p.first_entry, p.entry_count, 0, 0}});
    }
    std::vector<LeafSlotRow> tile_leaves;
    for (const std::uint32_t i : plan.tile_leaves) {
        tile_leaves.push_back({plan.leaves[i].box, {plan.leaves[i].leaf, plan.leaves[i].slot, 0, 0}});
    }
    std::vector<TileRow> tiles;
    for (const Tile& t : plan.tiles) {
        tiles.push_back({t.box, {t.first_product, t.product_count, t.first_leaf, t.leaf_count}});
    }
    products_.upload<ProductRow>(products, GL_STREAM_DRAW);
    entries_.upload<Entry>(plan.entries, GL_STREAM_DRAW);
    tile_products_.upload<std::uint32_t>(plan.tile_products, GL_STREAM_DRAW);
    tile_leaves_.upload<LeafSlotRow>(tile_leaves, GL_STREAM_DRAW);
    tiles_.upload<TileRow>(tiles, GL_STREAM_DRAW);
    commands.clear();
    const auto tile_count = static_cast<GLuint>(tiles.size());
    for (GLuint first = 0; first < tile_count; first += kPieceTiles) {
        commands.push_back({4, std::min(kPieceTiles, tile_count - first), 0, first});
    }
    tile_draws_.upload(commands, 1);
    gl_.VertexArrayVertexBuffer(tile_array_.id(), 0, tiles_.id(), 0, sizeof(TileRow));
}

layers::TextureStack Goldfeather::walk(const base::View& view, LeafBuffers& leaves, const PartProducts& part,
                                       int max_layers, WalkStats& stats, const std::stop_token& stop) {
    const ScreenPlan screen = plan(view, part.products, part.leaf_boxes, part.wound);
    layers::TextureStack stack;
    stack.size = view.size();
    stack.layers = 0;
    grow(gl_, stack, max_layers == kAllLayers ? 4 : max_layers);
    stats.drawn_leaves += static_cast<std::uint32_t>(screen.leaves.size());
    stats.drawn_products += static_cast<std::uint32_t>(screen.products.size());
    stats.skipped_products += static_cast<std::uint32_t>(part.products.size() - screen.products.size());
    stats.slots = std::max(stats.slots, screen.slots);
    stack.complete = true;
    if (screen.tiles.empty()) {
        return stack;
    }
    int most = 0;

    upload(screen, leaves, part.open);
    view_block_.update(view, leaves.frame().center, leaves.frame().diagonal);
    view_block_.bind();
    leaves.project(view, prepare_, stop);
    leaves.bind();
    gl_.VertexArrayVertexBuffer(leaf_array_.id(), 1, leaves.positions().id(), 0, sizeof(glm::vec4));

    // The state of a row of pixels decides how many rows are walked at once.
    const std::size_t row =
        static_cast<std::size_t>(view.size().x) * (sizeof(PixelState) + 8 * std::size_t{screen.words()});
    const auto rows = static_cast<int>(std::clamp<std::size_t>(memory_budget_ / row, 1, screen.box.y1 - screen.box.y0));
    for (int first = static_cast<int>(screen.box.y0); first < static_cast<int>(screen.box.y1); first += rows) {
        const Band band{{view.size().x, std::min(rows, static_cast<int>(screen.box.y1) - first)},
                        first,
                        view.size(),
                        screen.words(),
                        screen.first_counter(),
                        eye_among(view, screen, part.leaf_boxes),
                        programs(screen.counters > 0)};
        most = std::max(most, draw_band(band, stack, max_layers, stats, stop));
        ++stats.bands;
    }
    stack.complete = stack.complete && (max_layers == kAllLayers || most < max_layers);
    if (max_layers == kAllLayers) {
        stack.layers = std::max(most, 1);
    }
    stats.layers = std::max(stats.layers, most);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.UseProgram(0);
    return stack;
}

int Goldfeather::draw_band(const Band& band, layers::TextureStack& stack, int max_layers, WalkStats& stats,
                           const std::stop_token& stop) {
    const auto pixel_count = static_cast<std::size_t>(band.size.x) * static_cast<std::size_t>(band.size.y);
    const auto reserve = [&](gl::Buffer& buffer, std::size_t bytes, GLuint binding) {
        if (buffer.size() != bytes) {
            buffer.reserve(bytes, GL_DYNAMIC_COPY);
        }
        buffer.bind(GL_SHADER_STORAGE_BUFFER, binding);
    };
    reserve(pixels_, pixel_count * sizeof(PixelState), kPixels);
    const std::size_t bit_bytes = pixel_count * 4 * band.words;
    reserve(inside_bits_, bit_bytes, kInsideBits);
    reserve(toggled_bits_, bit_bytes, kToggledBits);
    for (const gl::Buffer* buffer : {&pixels_, &inside_bits_, &toggled_bits_}) {
        gl_.ClearNamedBufferData(buffer->id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    }
    products_.bind(GL_SHADER_STORAGE_BUFFER, kProducts);
    entries_.bind(GL_SHADER_STORAGE_BUFFER, kEntries);
    tile_products_.bind(GL_SHADER_STORAGE_BUFFER, kTileProducts);
    tile_leaves_.bind(GL_SHADER_STORAGE_BUFFER, kTileLeaves);

    if (!next_depth_ || next_depth_.size() != band.size) {
        next_depth_ = gl::Texture::make_2d(gl_, GL_DEPTH_COMPONENT32F, band.size);
        resolve_color_ = gl::Texture::make_2d(gl_, GL_R8, band.size);
        geometry_target_.attach({}, &next_depth_);
        resolve_target_.attach({&resolve_color_});
    }

    const auto first_row = static_cast<float>(band.first_row);
    const auto& [geometry, resolve] = band.programs;
    for (const gl::Program* program : {&geometry, &resolve}) {
        program->set("first_row", first_row);
        program->set("band_size", band.size);
        program->set("starting", true);
        program->set("count_inside", band.count_inside);
        program->set("first_counter", band.first_counter);
    }
    resolve.set("words", band.words);
    resolve.set("layer_limit",
                max_layers == kAllLayers ? std::numeric_limits<unsigned>::max() : static_cast<unsigned>(max_layers));

    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_TRUE);

    for (bool starting = true;; starting = false) {
        // Toggle the event that each pixel stands at, and find the next one.
        geometry_target_.bind();
        const float far = 0;
        gl_.ClearNamedFramebufferfv(geometry_target_.id(), GL_DEPTH, 0, &far);
        gl_.Viewport(0, -band.first_row, band.picture.x, band.picture.y);
        gl_.Enable(GL_DEPTH_TEST);
        geometry.use();
        geometry.set("starting", starting);
        leaf_array_.bind();
        candidates_.begin();
        leaf_draws_.draw(GL_TRIANGLES, stop);
        candidates_.end();
        base::end_if_asked(stop);
        gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
        ++stats.passes;

        // Evaluate the sum of products around the event, and store a layer where it changes.
        resolve_target_.bind();
        gl_.Viewport(0, 0, band.size.x, band.size.y);
        gl_.Disable(GL_DEPTH_TEST);
        next_depth_.bind(10);
        gl_.BindImageTexture(0, stack.depth.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
        gl_.BindImageTexture(1, stack.surface.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RG32UI);
        resolve.use();
        resolve.set("starting", starting);
        resolve.set("layer_capacity", static_cast<unsigned>(stack.layers));
        tile_array_.bind();
        filled_.begin();
        tile_draws_.draw(GL_TRIANGLE_STRIP, stop);
        filled_.end();
        base::end_if_asked(stop);
        gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                          GL_TEXTURE_FETCH_BARRIER_BIT);

        const GLuint64 ahead = candidates_.result();
        stats.fragments += ahead;
        if (max_layers == kAllLayers && filled_.result() > 0) {
            grow(gl_, stack, 2 * stack.layers);
        }
        // As many pixels as fragments ahead, at most. The few that are left out end the stack early.
        if (static_cast<double>(ahead) < minimal_fraction_ * static_cast<double>(pixel_count) || ahead == 0) {
            stack.complete = stack.complete && ahead == 0;
            break;
        }
    }
    return most_layers(pixel_count);
}

int Goldfeather::most_layers(std::size_t pixel_count) const {
    std::vector<PixelState> states(pixel_count);
    gl_.GetNamedBufferSubData(pixels_.id(), 0, static_cast<GLsizeiptr>(pixel_count * sizeof(PixelState)),
                              states.data());
    std::uint32_t most = 0;
    for (const PixelState& state : states) {
        most = std::max(most, state.found >> 1);
    }
    return static_cast<int>(most);
}

}  // namespace goldfeather
