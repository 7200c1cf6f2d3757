#include "goldfeather/scs/scs.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/stop.h"
#include "goldfeather/lists/list_resolver.h"
#include "goldfeather/lists_cpu/screen_triangles.h"

namespace goldfeather {
namespace {

/// As in goldfeather/scs/scs.glsl.
constexpr std::size_t kScsPixelBytes = 9 * sizeof(std::uint32_t);

using ScreenRectangle = base::View::Rectangle;

ScreenRectangle intersected(const ScreenRectangle& a, const ScreenRectangle& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

}  // namespace

/// Pixels of the picture.
struct Scs::Rectangle {
    ScreenRectangle box;
};

/// Subtracted leaves that are apart from each other on the screen.
struct Scs::Group {
    std::vector<csg::LeafId> leaves;
    std::vector<ScreenRectangle> boxes;

    [[nodiscard]] bool apart_from(const ScreenRectangle& box) const {
        return std::all_of(boxes.begin(), boxes.end(),
                           [&](const ScreenRectangle& b) { return intersected(b, box).empty(); });
    }
};

struct Scs::PlannedProduct {
    Rectangle rectangle;
    std::vector<csg::LeafId> intersected;
    std::vector<Group> subtracted;  ///< From front to back.
};

/// Rows of the picture that are drawn at once.
struct Scs::Band {
    const base::View& view;
    const LeafBuffers& leaves;
    int first_row = 0;
    glm::ivec2 size{0};
    const std::stop_token& stop;  ///< Once it is asked for, nothing is drawn any more.
};

Scs::Scs(const gl::Functions& gl, std::size_t memory_budget)
    : gl_(gl),
      memory_budget_(memory_budget),
      prepare_(gl, ListResolver::shaders(), {"goldfeather/prepare.comp"}),
      begin_(gl, ListResolver::shaders(), {"goldfeather/scs/scs_begin.comp"}),
      intersect_(gl, ListResolver::shaders(), {"goldfeather/leaf.vert", "goldfeather/scs/scs_intersect.frag"}),
      mark_(gl, ListResolver::shaders(), {"goldfeather/leaf.vert", "goldfeather/scs/scs_mark.frag"}),
      advance_(gl, ListResolver::shaders(), {"goldfeather/leaf.vert", "goldfeather/scs/scs_advance.frag"}),
      identify_(gl, ListResolver::shaders(), {"goldfeather/leaf.vert", "goldfeather/scs/scs_identify.frag"}),
      merge_(gl, ListResolver::shaders(), {"goldfeather/scs/scs_merge.comp"}),
      store_(gl, ListResolver::shaders(), {"goldfeather/scs/scs_store.comp"}),
      view_block_(gl),
      leaf_array_(gl),
      pixels_(gl),
      target_(gl),
      moved_(gl, GL_SAMPLES_PASSED) {
    LeafBuffers::describe_positions(gl, leaf_array_);
}

std::string Scs::obstacle(const base::View& view, const csg::solid::Geometry& geometry,
                          std::span<const Product> products, int max_layers) {
    if (max_layers != 1) {
        return "scs finds one layer only";
    }
    for (const Product& product : products) {
        for (const Literal& literal : product.literals) {
            const csg::solid::PlacedLeaf& leaf = geometry.leaves[literal.leaf];
            if (!leaf.triangles.empty() && !leaf.solid->convex) {
                return "scs needs convex leaves";
            }
            if (near_plane_cuts(view, leaf.box)) {
                return "scs needs the eye outside of every leaf";
            }
        }
    }
    return {};
}

std::vector<Scs::PlannedProduct> Scs::plan(const base::View& view, const PartProducts& part, WalkStats& stats) {
    const auto box_of = [&](const csg::Box& box) {
        return box.empty() ? ScreenRectangle{} : view.screen_box(box.lo, box.hi);
    };
    const auto distance = [&](csg::LeafId leaf) {
        return -(view.eye_from_world() * glm::dvec4(part.leaf_boxes[leaf].center(), 1.0)).z;
    };
    std::vector<PlannedProduct> planned;
    for (const Product& product : part.products) {
        PlannedProduct p{{box_of(product.box)}, {}, {}};
        std::vector<csg::LeafId> subtracted;
        for (const Literal& literal : product.literals) {
            const ScreenRectangle box = box_of(part.leaf_boxes[literal.leaf]);
            if (!literal.complement) {
                p.intersected.push_back(literal.leaf);
                p.rectangle.box = intersected(p.rectangle.box, box);
            } else {
                subtracted.push_back(literal.leaf);
            }
        }
        if (p.rectangle.box.empty()) {
            ++stats.skipped_products;
            continue;
        }
        std::erase_if(subtracted, [&](csg::LeafId leaf) {
            return intersected(box_of(part.leaf_boxes[leaf]), p.rectangle.box).empty();
        });
        std::stable_sort(subtracted.begin(), subtracted.end(),
                         [&](csg::LeafId a, csg::LeafId b) { return distance(a) < distance(b); });
        for (const csg::LeafId leaf : subtracted) {
            const ScreenRectangle box = box_of(part.leaf_boxes[leaf]);
            auto group = std::find_if(p.subtracted.begin(), p.subtracted.end(),
                                      [&](const Group& g) { return g.apart_from(box); });
            if (group == p.subtracted.end()) {
                group = p.subtracted.insert(group, Group{});
            }
            group->leaves.push_back(leaf);
            group->boxes.push_back(box);
        }
        stats.drawn_leaves += static_cast<std::uint32_t>(p.intersected.size() + subtracted.size());
        ++stats.drawn_products;
        planned.push_back(std::move(p));
    }
    return planned;
}

layers::TextureStack Scs::peel(const base::View& view, LeafBuffers& leaves, const PartProducts& part, WalkStats& stats,
                               const std::stop_token& stop) {
    layers::TextureStack stack;
    stack.size = view.size();
    grow(gl_, stack, 1);
    const std::vector<PlannedProduct> products = plan(view, part, stats);
    stack.complete = products.empty();
    if (products.empty()) {
        return stack;
    }
    view_block_.update(view, leaves.frame().center, leaves.frame().diagonal);
    view_block_.bind();
    leaves.project(view, prepare_, stop);
    leaves.bind();
    gl_.VertexArrayVertexBuffer(leaf_array_.id(), 1, leaves.positions().id(), 0, sizeof(glm::vec4));

    const std::size_t row = static_cast<std::size_t>(view.size().x) * kScsPixelBytes;
    const int rows =
        static_cast<int>(std::clamp<std::size_t>(memory_budget_ / row, 1, static_cast<std::size_t>(view.size().y)));
    for (int first = 0; first < view.size().y; first += rows) {
        const Band band{view, leaves, first, {view.size().x, std::min(rows, view.size().y - first)}, stop};
        if (!target_color_ || target_color_.size() != band.size) {
            target_color_ = gl::Texture::make_2d(gl_, GL_R8, band.size);
            target_.attach({&target_color_});
        }
        pixels_.reserve(row * static_cast<std::size_t>(band.size.y), GL_DYNAMIC_COPY);
        pixels_.bind(GL_SHADER_STORAGE_BUFFER, 2);
        gl_.ClearNamedBufferData(pixels_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
        for (const PlannedProduct& product : products) {
            draw_product(product, band, stats);
            if (stop.stop_possible()) {
                gl_.Finish();
                base::end_if_asked(stop);
            }
        }
        gl_.BindImageTexture(0, stack.depth.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
        gl_.BindImageTexture(1, stack.surface.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RG32UI);
        store_.set("first_row", first);
        for_pixels(store_, {{0, first, band.size.x, first + band.size.y}}, band);
        gl_.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                          GL_TEXTURE_UPDATE_BARRIER_BIT);
        ++stats.bands;
        stats.memory = std::max(stats.memory, pixels_.size());
    }
    stats.layers = std::max(stats.layers, 1);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.UseProgram(0);
    return stack;
}

void Scs::draw_product(const PlannedProduct& product, const Band& band, WalkStats& stats) {
    const ScreenRectangle rows{0, band.first_row, band.size.x, band.first_row + band.size.y};
    const ScreenRectangle box = intersected(product.rectangle.box, rows);
    if (box.empty()) {
        return;
    }
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(box.x0, box.y0 - band.first_row, box.x1 - box.x0, box.y1 - box.y0);
    const auto intersected_leaves = static_cast<unsigned>(product.intersected.size());
    for (const gl::Program* program : {&mark_, &identify_, &merge_}) {
        program->set("intersected", intersected_leaves);
    }
    for_pixels(begin_, {box}, band);
    draw_leaves(intersect_, product.intersected, band, stats);
    subtract(product, band, stats);
    draw_leaves(identify_, product.intersected, band, stats);
    for (const Group& group : product.subtracted) {
        draw_leaves(identify_, group.leaves, band, stats);
    }
    gl_.Disable(GL_SCISSOR_TEST);
    for_pixels(merge_, {box}, band);
}

/// Each round moves at least one pixel out of a leaf that it is not in again, so the rounds come to an end.
void Scs::subtract(const PlannedProduct& product, const Band& band, WalkStats& stats) {
    unsigned pass = 0;
    for (bool moved = !product.subtracted.empty(); moved;) {
        moved_.begin();
        for (const Group& group : product.subtracted) {
            ++pass;
            mark_.set("pass", pass);
            advance_.set("pass", pass);
            draw_leaves(mark_, group.leaves, band, stats);
            draw_leaves(advance_, group.leaves, band, stats);
        }
        moved_.end();
        moved = moved_.result() > 0;
    }
}

void Scs::draw_leaves(const gl::Program& program, std::span<const csg::LeafId> ids, const Band& band,
                      WalkStats& stats) const {
    if (band.stop.stop_requested()) {
        return;
    }
    target_.bind();
    gl_.Viewport(0, -band.first_row, band.view.size().x, band.view.size().y);
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.FrontFace(GL_CCW);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    program.set("band_size", band.size);
    program.set("first_row", static_cast<float>(band.first_row));
    program.use();
    leaf_array_.bind();
    for (const csg::LeafId id : ids) {
        const LeafBuffers::Range range = band.leaves.ranges()[id];
        gl_.DrawArrays(GL_TRIANGLES, static_cast<GLint>(range.first_vertex), static_cast<GLsizei>(range.vertex_count));
    }
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    ++stats.passes;
}

void Scs::for_pixels(const gl::Program& program, const Rectangle& rectangle, const Band& band) const {
    const ScreenRectangle& box = rectangle.box;
    const glm::ivec2 size{box.x1 - box.x0, box.y1 - box.y0};
    program.set("band_size", band.size);
    program.set("rectangle_first", glm::ivec2(box.x0, box.y0 - band.first_row));
    program.set("rectangle_size", size);
    program.use();
    gl_.DispatchCompute(static_cast<GLuint>(size.x + 7) / 8, static_cast<GLuint>(size.y + 7) / 8, 1);
    gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace goldfeather
