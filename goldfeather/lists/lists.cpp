#include "goldfeather/lists/lists.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "base/stop.h"
#include "gl/error.h"
#include "goldfeather/lists/list_self_test.h"
#include "goldfeather/lists_cpu/screen_triangles.h"

namespace goldfeather {
namespace {

constexpr std::size_t kEntryBytes = sizeof(glm::uvec2);
/// Of a pixel, without its list: its counters; and its place among the jobs of each class, and where its walk stands.
constexpr std::size_t kListPixelBytes = sizeof(PixelList),
                      kJobBytes = kListClasses * sizeof(glm::uvec2) + 2 * kEntryBytes;
/// A long list has as much room again, for the leaves that hold the point.
constexpr std::size_t kListBytes = 2 * kEntryBytes;

constexpr const char* kComputesWrong = "the shader that resolves per-pixel lists computes wrong on this OpenGL: ";

gl::Defines class_limits() {
    return {{"kShortest", std::to_string(kShortLists[0]) + "u"}, {"kShort", std::to_string(kShortLists[1]) + "u"}};
}

}  // namespace

/// One picture, and the band at hand.
struct Lists::Job {
    const base::View& view;
    LeafBuffers& leaves;
    ListsScene& scene;
    layers::TextureStack& stack;
    WalkStats& stats;
    std::uint32_t layer_limit;
    const std::stop_token& stop;
    std::vector<LeafBuffers::Range> ranges{};
    bool count_inside = false, windings = false;
    int first_row = 0;
    glm::ivec2 band_size{0};
    int most_layers = 0;
};

Lists::Lists(const gl::Functions& gl, std::size_t memory_budget)
    : gl_(gl),
      memory_budget_(memory_budget),
      most_bytes_(most_bytes_of_a_block(gl)),
      prepare_(gl, ListResolver::shaders(), {"goldfeather/prepare.comp"}),
      count_(gl, ListResolver::shaders(), {"goldfeather/leaf.vert", "goldfeather/lists/lists_count.frag"}),
      allocate_(gl, ListResolver::shaders(), {"goldfeather/lists/lists_allocate.comp"}, class_limits()),
      fill_(gl, ListResolver::shaders(), {"goldfeather/leaf.vert", "goldfeather/lists/lists_fill.frag"}),
      resolver_(gl, ListResolver::shaders()),
      buffers_(gl),
      view_block_(gl),
      leaf_array_(gl),
      draws_(gl),
      target_(gl),
      surfaces_(gl, GL_SAMPLES_PASSED) {
    LeafBuffers::describe_positions(gl, leaf_array_);
    if (const std::string wrong = self_test(gl, resolver_, false); !wrong.empty()) {
        throw gl::Error(kComputesWrong + wrong);
    }
}

layers::TextureStack Lists::peel(const base::View& view, const csg::solid::Geometry& geometry, LeafBuffers& leaves,
                                 ListsScene& scene, int max_layers, WalkStats& stats, const std::stop_token& stop) {
    layers::TextureStack stack;
    stack.size = view.size();
    const bool all = max_layers == kAllLayers;
    Job job{view,  leaves, scene,
            stack, stats,  all ? std::numeric_limits<std::uint32_t>::max() : static_cast<std::uint32_t>(max_layers),
            stop};

    std::vector<std::uint32_t> flags(geometry.leaves.size(), 0);
    for (csg::LeafId id = 0; id < geometry.leaves.size(); ++id) {
        const csg::solid::PlacedLeaf& leaf = geometry.leaves[id];
        const LeafBuffers::Range range = leaves.ranges()[id];
        if (range.vertex_count == 0 || leaf.box.empty() || is_hidden(scene.scene, id) ||
            view.screen_box(leaf.box.lo, leaf.box.hi).empty()) {
            ++stats.skipped_leaves;
            continue;
        }
        ++stats.drawn_leaves;
        if (leaf.solid->closed && near_plane_cuts(view, leaf.box)) {
            flags[id] |= BlistBuffer::kBehind;
            job.count_inside = true;
        }
        if (leaf.solid->winds()) {
            flags[id] |= BlistBuffer::kWound;
            job.windings = true;
        }
        if (!job.ranges.empty() &&
            job.ranges.back().first_vertex + job.ranges.back().vertex_count == range.first_vertex) {
            job.ranges.back().vertex_count += range.vertex_count;
        } else {
            job.ranges.push_back(range);
        }
    }
    grow(gl_, stack, all ? layers_before_ : std::min(layers_before_, max_layers));
    stack.complete = true;
    if (job.ranges.empty()) {
        return stack;
    }
    if (job.windings && !windings_tested_) {
        if (const std::string wrong = self_test(gl_, resolver_, true); !wrong.empty()) {
            throw gl::Error(kComputesWrong + wrong);
        }
        windings_tested_ = true;
    }
    scene.blist.set_flags(flags);
    view_block_.update(view, leaves.frame().center, leaves.frame().diagonal);
    view_block_.bind();
    leaves.project(view, prepare_, stop);
    leaves.bind();
    gl_.VertexArrayVertexBuffer(leaf_array_.id(), 1, leaves.positions().id(), 0, sizeof(glm::vec4));
    upload_draws(job);

    // At least half of the budget is left for the lists.
    const std::size_t row = static_cast<std::size_t>(view.size().x) * (kListPixelBytes + kJobBytes);
    const std::size_t rows = std::clamp<std::size_t>(std::min(memory_budget_ / 2, most_bytes_) / row, 1,
                                                     static_cast<std::size_t>(view.size().y));
    for (job.first_row = 0; job.first_row < view.size().y; job.first_row += static_cast<int>(rows)) {
        job.band_size = {view.size().x, std::min(static_cast<int>(rows), view.size().y - job.first_row)};
        peel_band(job);
    }
    stack.complete = all || job.most_layers < max_layers;
    if (all) {
        stack.layers = std::max(job.most_layers, 1);
    }
    layers_before_ = std::clamp(job.most_layers, 1, 64);
    stats.layers = std::max(stats.layers, job.most_layers);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.UseProgram(0);
    return stack;
}

void Lists::upload_draws(const Job& job) {
    std::vector<DrawCommand> commands;
    for (const LeafBuffers::Range& range : job.ranges) {
        add_triangles(commands, range.first_vertex, range.vertex_count, 0);
    }
    draws_.upload(commands, kPieceVertices);
}

void Lists::draw(const Job& job, const gl::Program& program) const {
    target_.bind();
    gl_.Viewport(0, -job.first_row, job.view.size().x, job.view.size().y);
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    program.set("band_size", job.band_size);
    program.use();
    leaf_array_.bind();
    draws_.draw(GL_TRIANGLES, job.stop);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    ++job.stats.passes;
}

void Lists::peel_band(Job& job) {
    if (!target_color_ || target_color_.size() != job.band_size) {
        target_color_ = gl::Texture::make_2d(gl_, GL_R8, job.band_size);
        target_.attach({&target_color_});
    }
    const Rectangle band{{0, 0}, job.band_size};
    if (const std::size_t bytes = band.pixels() * sizeof(PixelList); buffers_.pixels.size() != bytes) {
        buffers_.pixels.reserve(bytes, GL_DYNAMIC_COPY);
    }
    gl_.ClearNamedBufferData(buffers_.pixels.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    buffers_.bind();
    gl_.Disable(GL_SCISSOR_TEST);
    surfaces_.begin();
    draw(job, count_);
    surfaces_.end();
    base::end_if_asked(job.stop);
    const std::uint64_t surfaces = surfaces_.result();
    job.stats.fragments += surfaces;
    if (surfaces == 0) {
        return;
    }
    for (const Rectangle& rectangle : split(job, surfaces)) {
        peel_rectangle(job, rectangle);
    }
}

/// Halves rectangles until each keeps the budget, or is one pixel.
std::vector<Lists::Rectangle> Lists::split(const Job& job, std::uint64_t surfaces) const {
    const Rectangle band{{0, 0}, job.band_size};
    const std::size_t held = band.pixels() * kListPixelBytes;
    const std::size_t budget = std::min(memory_budget_ - std::min(memory_budget_, held), most_bytes_);
    if (surfaces * kListBytes + band.pixels() * kJobBytes <= budget) {
        return {band};
    }
    std::vector<PixelList> lists(band.pixels());
    gl_.GetNamedBufferSubData(buffers_.pixels.id(), 0, static_cast<GLsizeiptr>(lists.size() * sizeof(PixelList)),
                              lists.data());
    std::vector<Rectangle> fitting, waiting{band};
    while (!waiting.empty()) {
        const Rectangle r = waiting.back();
        waiting.pop_back();
        std::uint64_t bytes = r.pixels() * kJobBytes;
        for (int y = r.first.y; y < r.first.y + r.size.y; ++y) {
            for (int x = r.first.x; x < r.first.x + r.size.x; ++x) {
                bytes += kListBytes * lists[static_cast<std::size_t>(y) * static_cast<std::size_t>(band.size.x) +
                                            static_cast<std::size_t>(x)]
                                          .count;
            }
        }
        if (bytes <= budget || (r.pixels() == 1 && bytes <= most_bytes_)) {
            fitting.push_back(r);
        } else if (r.pixels() == 1) {
            throw gl::Error("a pixel has more surfaces than this OpenGL can list");
        } else {
            const int axis = r.size.y >= r.size.x ? 1 : 0;
            Rectangle a = r, b = r;
            a.size[axis] = r.size[axis] / 2;
            b.first[axis] += a.size[axis];
            b.size[axis] -= a.size[axis];
            waiting.push_back(b);
            waiting.push_back(a);
        }
    }
    return fitting;
}

void Lists::peel_rectangle(Job& job, const Rectangle& rectangle) {
    const auto memory = [&] { return buffers_.pixels.size() + buffers_.jobs.size() + buffers_.entries.size(); };
    // A buffer stays as large as it has been, unless all of them together are too large then.
    const auto reserve = [&](gl::Buffer& buffer, std::size_t bytes) {
        if (buffer.size() < bytes || memory() > memory_budget_) {
            buffer.reserve(bytes, GL_DYNAMIC_COPY);
        }
    };
    reserve(buffers_.jobs, rectangle.pixels() * kListClasses * sizeof(glm::uvec2));
    if (memory() > memory_budget_) {
        reserve(buffers_.entries, 0);
    }
    const ListStatus none;
    buffers_.status.upload_bytes(&none, sizeof none, GL_DYNAMIC_COPY);
    buffers_.bind();
    allocate_.set("band_size", job.band_size);
    allocate_.set("rectangle_first", rectangle.first);
    allocate_.set("rectangle_size", rectangle.size);
    allocate_.use();
    gl_.DispatchCompute(static_cast<GLuint>(rectangle.size.x + 7) / 8, static_cast<GLuint>(rectangle.size.y + 7) / 8,
                        1);
    gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    const ListStatus allocated = status();
    if (allocated.entries == 0) {
        return;
    }

    reserve(buffers_.entries, allocated.entries * kEntryBytes);
    buffers_.bind();
    fill_.set("entry_capacity", allocated.entries);
    fill_.set("first_row", static_cast<float>(job.first_row));
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(rectangle.first.x, rectangle.first.y, rectangle.size.x, rectangle.size.y);
    draw(job, fill_);
    gl_.Disable(GL_SCISSOR_TEST);
    base::end_if_asked(job.stop);

    for (;;) {
        const ListStatus resolved = resolver_.resolve(
            buffers_, job.scene.blist,
            {job.stack, job.first_row, job.band_size, job.layer_limit, job.count_inside, job.windings, 0},
            allocated.class_sizes, static_cast<std::uint32_t>(rectangle.pixels()), job.stop);
        const auto found = static_cast<int>(resolved.most_layers);
        job.most_layers = std::max(job.most_layers, found);
        if (found <= job.stack.layers) {
            break;
        }
        grow(gl_, job.stack, found);
    }
    ++job.stats.bands;
    job.stats.longest_list = std::max(job.stats.longest_list, allocated.longest);
    job.stats.memory = std::max(job.stats.memory, memory());
}

ListStatus Lists::status() const {
    ListStatus status;
    gl_.GetNamedBufferSubData(buffers_.status.id(), 0, sizeof status, &status);
    return status;
}

}  // namespace goldfeather
