#include "peel/peeler.h"

#include <algorithm>
#include <utility>

#include "base/stop.h"
#include "gl/error.h"
#include "goldfeather/surface_table.h"
#include "peel/shaders.h"

namespace peel {
namespace {

gl::ShaderLibrary shaders() {
    gl::ShaderLibrary library;
    library.add(layers::shader_files());
    library.add(peel::shader_files());
    return library;
}

}  // namespace

PeelModel::PeelModel(const gl::Functions& gl, const csg::Scene& scene, const csg::solid::Geometry& geometry,
                     std::vector<std::vector<goldfeather::Product>> part_products, EngineKind kind)
    : engine(kind),
      lists(scene, geometry),
      table(std::make_shared<layers::SurfaceBuffers>(gl, *goldfeather::surface_table(scene, geometry))),
      products(std::move(part_products)),
      box(geometry.box) {
    if (kind != EngineKind::ListsCpu) {
        leaves_fault = goldfeather::LeafBuffers::obstacle(gl, geometry);
        if (leaves_fault.empty()) {
            leaves.emplace(gl, geometry, table->local_centre);
        }
    }
    if (kind == EngineKind::Lists && leaves) {
        lists_scene.emplace(gl, scene);
    }
    leaf_boxes.reserve(geometry.leaves.size());
    for (const auto& leaf : geometry.leaves) {
        leaf_boxes.push_back(leaf.box);
        wound.push_back(leaf.solid->winds() ? 1 : 0);
        open.push_back(leaf.solid->closed ? 0 : 1);
    }
    for (const auto& part : scene.parts)
        kinds.push_back(part.kind);
}

Peeler::Peeler(const gl::Functions& gl, std::size_t memory_budget, double minimal_fraction)
    : gl_(gl),
      memory_budget_(memory_budget),
      minimal_fraction_(minimal_fraction),
      empty_array_(gl),
      target_(gl),
      upload_(gl) {}

layers::TextureStack Peeler::peel(const base::View& view, PeelModel& model, int max_layers, WalkStats& stats,
                                  const std::stop_token& stop) {
    if (model.engine == EngineKind::ListsCpu) {
        return peel_lists_cpu(view, model, max_layers, stats, stop);
    }
    if (!model.leaves) {
        stats.fallback = model.leaves_fault;
        return peel_lists_cpu(view, model, max_layers, stats, stop);
    }
    upload_.forget();
    if (model.engine == EngineKind::Lists) {
        auto stack = peel_lists(view, model, max_layers, stats, stop);
        return stack ? std::move(*stack) : peel_lists_cpu(view, model, max_layers, stats, stop);
    }
    if (model.engine == EngineKind::Scs) {
        for (const auto& products : model.products) {
            const std::string obstacle = goldfeather::Scs::obstacle(view, model.lists.geometry, products, max_layers);
            if (!obstacle.empty()) {
                stats.fallback = obstacle;
                return peel_lists_cpu(view, model, max_layers, stats, stop);
            }
        }
    }
    return peel_parts(view, model, max_layers, stats, stop);
}

std::optional<layers::TextureStack> Peeler::peel_lists(const base::View& view, PeelModel& model, int max_layers,
                                                       WalkStats& stats, const std::stop_token& stop) {
    if (!lists_ && lists_fault_.empty()) {
        try {
            lists_.emplace(gl_, memory_budget_);
        } catch (const gl::Error& error) {
            lists_fault_ = error.what();  // Nor will it be better the next time.
        }
    }
    if (lists_) {
        try {
            return lists_->peel(view, model.lists.geometry, *model.leaves, *model.lists_scene, model.table, max_layers,
                                stats, stop);
        } catch (const gl::Error& error) {
            stats.fallback = error.what();  // Of this picture.
        }
    }
    if (!lists_) {
        stats.fallback = lists_fault_;
    }
    return std::nullopt;
}

layers::TextureStack Peeler::peel_lists_cpu(const base::View& view, const PeelModel& model, int max_layers,
                                            WalkStats& stats, const std::stop_token& stop) {
    goldfeather::ListsStats lists;
    goldfeather::peel_lists(model.lists, view, max_layers, 0, cpu_layers_, lists, stop);
    goldfeather::add(stats, lists);
    layers::leave_out_sparse_layers(cpu_layers_, minimal_fraction_);

    layers::TextureStack stack = upload_.upload(cpu_layers_);
    stack.table = model.table;
    return stack;
}

layers::TextureStack Peeler::peel_parts(const base::View& view, PeelModel& model, int max_layers, WalkStats& stats,
                                        const std::stop_token& stop) {
    const bool scs = model.engine == EngineKind::Scs;
    if (scs && !scs_)
        scs_.emplace(gl_, memory_budget_);
    if (!scs && !engine_)
        engine_.emplace(gl_, memory_budget_, minimal_fraction_);
    const auto walk = [&](std::span<const goldfeather::Product> products) {
        const goldfeather::PartProducts part{products, model.leaf_boxes, model.wound, model.open};
        if (scs)
            return scs_->peel(view, *model.leaves, part, model.table, stats, stop);
        return engine_->walk(view, *model.leaves, part, model.table, max_layers, stats, stop);
    };
    if (model.products.empty())
        return walk({});
    // Highlighted parts come before all others, and each kind in order of the parts' ids.
    std::optional<layers::TextureStack> plain, highlighted;
    for (std::size_t part = 0; part < model.products.size(); ++part) {
        std::optional<layers::TextureStack>& kind = model.kinds[part] == csg::PartKind::Highlight ? highlighted : plain;
        base::end_if_asked(stop);
        layers::TextureStack next = walk(model.products[part]);
        kind = kind ? merge(*kind, next, max_layers) : std::move(next);
    }
    if (plain && highlighted)
        return merge(*highlighted, *plain, max_layers);
    return std::move(plain ? *plain : *highlighted);
}

layers::TextureStack Peeler::merge(const layers::TextureStack& front, const layers::TextureStack& back,
                                   int max_layers) {
    if (!merge_)
        merge_.emplace(gl_, shaders(),
                       std::initializer_list<std::string_view>{"peel/fullscreen.vert", "peel/merge.frag"});
    layers::TextureStack merged;
    merged.size = front.size;
    merged.table = front.table;
    const int both = front.layers + back.layers;
    merged.layers = max_layers == kAllLayers ? both : std::min(both, max_layers);
    merged.complete = front.complete && back.complete && (max_layers == kAllLayers || both <= max_layers);
    merged.depth = gl::Texture::make_2d_array(gl_, GL_R32F, merged.size, merged.layers);
    merged.surface = gl::Texture::make_2d_array(gl_, GL_RG32UI, merged.size, merged.layers);

    if (!target_color_ || target_color_.size() != merged.size) {
        target_color_ = gl::Texture::make_2d(gl_, GL_R8, merged.size);
        target_.attach({&target_color_});
    }
    target_.bind();
    gl_.Viewport(0, 0, merged.size.x, merged.size.y);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    front.depth.bind(0);
    front.surface.bind(1);
    back.depth.bind(2);
    back.surface.bind(3);
    gl_.BindImageTexture(0, merged.depth.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
    gl_.BindImageTexture(1, merged.surface.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RG32UI);
    merge_->set("front_layers", front.layers);
    merge_->set("back_layers", back.layers);
    merge_->set("layers", merged.layers);
    merge_->use();
    empty_array_.bind();
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    return merged;
}

}  // namespace peel
