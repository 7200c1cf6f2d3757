#include "ui/pipeline/picture/shadow_caster.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "ui/pipeline/inspection/solid_probe.h"

namespace ui {

namespace {

/// Pixels that ask together which faces may keep the light from them.
constexpr int kBlockSide = 8;
/// More faces than that are better looked for by each ray.
constexpr std::size_t kMostFaces = 40;
/// Of faces that the light passes nearly along, all are looked at.
constexpr double kGrazing = 1e-6;

/// The rays of a view, of which those of neighbors differ by the same everywhere.
class ViewRays {
  public:
    explicit ViewRays(const base::View& view) : first_(view.ray(0, 0)) {
        const base::View::Ray right = view.ray(1, 0), up = view.ray(0, 1);
        right_ = {right.origin - first_.origin, right.direction - first_.direction};
        up_ = {up.origin - first_.origin, up.direction - first_.direction};
    }
    [[nodiscard]] base::View::Ray at(glm::ivec2 p) const {
        const glm::dvec2 by(p);
        return {first_.origin + by.x * right_.origin + by.y * up_.origin,
                first_.direction + by.x * right_.direction + by.y * up_.direction};
    }

  private:
    base::View::Ray first_, right_, up_;
};

/// Directions across the light.
struct Across {
    explicit Across(const glm::dvec3& light)
        : u(glm::normalize(glm::cross(light, std::abs(light.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)))),
          v(glm::cross(light, u)) {}
    [[nodiscard]] glm::dvec2 of(const glm::dvec3& p) const { return {glm::dot(p, u), glm::dot(p, v)}; }

    glm::dvec3 u, v;
};

/// A place that light may fall on.
struct Place {
    std::size_t pixel;
    glm::dvec3 point;
};

/// One for each thread.
class BlockShadows {
  public:
    BlockShadows(const SolidProbe& probe, const ExpressionLinks& links, std::span<const char> casts,
                 const base::View& view, const layers::HostStack& layers, std::vector<npr::ShadowBits>& bits)
        : probe_(probe),
          casts_(casts),
          rays_(view),
          layers_(layers),
          bits_(bits),
          light_(npr::toward_light(view)),
          across_(light_),
          ray_(probe, links) {}

    void operator()(int block) {
        const int across = (layers_.size.x + kBlockSide - 1) / kBlockSide;
        const glm::ivec2 lo = kBlockSide * glm::ivec2(block % across, block / across);
        const glm::ivec2 hi = glm::min(lo + kBlockSide, layers_.size);
        unsettled_.clear();
        for (int y = lo.y; y < hi.y; ++y) {
            for (int x = lo.x; x < hi.x; ++x) {
                unsettled_.push_back({x, y});
            }
        }
        for (int layer = 0; layer < std::min(layers_.layers, npr::kLayersInShadow) && !unsettled_.empty(); ++layer) {
            find_places(layer);
            cast(layer);
        }
    }

  private:
    /// Of the pixels that are not settled; those with nothing to be seen behind the layer are from then on.
    void find_places(int layer) {
        places_.clear();
        auto kept = unsettled_.begin();
        for (const glm::ivec2 p : unsettled_) {
            const layers::Surface s = layers_.at(layer, p.x, p.y);
            if (!(s.depth > 0)) {
                continue;
            }
            if (probe_.scene().parts[probe_.scene().leaves[s.leaf].part].kind != csg::PartKind::Solid) {
                *kept++ = p;
            }
            if (!s.leaving) {
                find_place(s, p);
            }
        }
        unsettled_.erase(kept, unsettled_.end());
    }
    void find_place(const layers::Surface& s, glm::ivec2 p) {
        const csg::solid::Plane& plane = probe_.geometry().planes.planes()[s.plane];
        const base::View::Ray ray = rays_.at(p);
        const double slope = glm::dot(plane.normal, ray.direction);
        if (slope == 0 || (slope > 0 ? -1 : 1) * glm::dot(plane.normal, light_) <= 0) {
            return;
        }
        const std::size_t pixel =
            static_cast<std::size_t>(p.y) * static_cast<std::size_t>(layers_.size.x) + static_cast<std::size_t>(p.x);
        places_.push_back(
            {pixel, ray.origin + (plane.offset - glm::dot(plane.normal, ray.origin)) / slope * ray.direction});
    }
    void cast(int layer) {
        if (places_.empty()) {
            return;
        }
        csg::Box box;
        lo_ = hi_ = across_.of(places_.front().point);
        for (const Place& place : places_) {
            box = csg::enclose(box, place.point);
            lo_ = glm::min(lo_, across_.of(place.point));
            hi_ = glm::max(hi_, across_.of(place.point));
        }
        if (!probe_.faces_along(
                box, light_, kMostFaces, [&](const SolidProbe::Face& f) { return may_hide(f); }, faces_)) {
            for (const Place& place : places_) {
                set(place, layer, ray_.passes(casts_, place.point, light_));
            }
        } else if (!faces_.empty()) {
            for (const Place& place : places_) {
                set(place, layer, ray_.passes(casts_, place.point, light_, faces_));
            }
        }
    }
    /// Not where the face lies beside all of the places, seen from the light, or its plane behind all of them.
    [[nodiscard]] bool may_hide(const SolidProbe::Face& face) const {
        const csg::solid::PlacedLeaf& leaf = probe_.geometry().leaves[face.leaf];
        const glm::uvec3& corners = leaf.triangles[face.triangle];
        const glm::dvec2 a = across_.of(leaf.points[corners.x]), b = across_.of(leaf.points[corners.y]),
                         c = across_.of(leaf.points[corners.z]);
        const glm::dvec2 lo = glm::min(a, glm::min(b, c)) - probe_.event(),
                         hi = glm::max(a, glm::max(b, c)) + probe_.event();
        if (lo.x > hi_.x || lo.y > hi_.y || hi.x < lo_.x || hi.y < lo_.y) {
            return false;
        }
        const csg::solid::Plane& plane = probe_.geometry().planes.planes()[leaf.planes[face.triangle].index];
        const double slope = glm::dot(plane.normal, light_);
        return std::abs(slope) < kGrazing || std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
                   return (plane.offset - glm::dot(plane.normal, place.point)) / slope > probe_.event();
               });
    }
    void set(const Place& place, int layer, bool dark) {
        bits_[place.pixel] |= dark ? npr::ShadowBits{1} << static_cast<unsigned>(layer) : 0;
    }

    const SolidProbe& probe_;
    std::span<const char> casts_;  ///< By part.
    ViewRays rays_;
    const layers::HostStack& layers_;
    std::vector<npr::ShadowBits>& bits_;
    glm::dvec3 light_;
    Across across_;
    PartRay ray_;
    std::vector<glm::ivec2> unsettled_;  ///< Pixels of the block.
    std::vector<Place> places_;
    glm::dvec2 lo_{0}, hi_{0};  ///< Of them, across the light.
    std::vector<SolidProbe::Face> faces_;
};

}  // namespace

struct ShadowCaster::State {
    explicit State(const Model& model) : probe(model.scene, model.geometry), links(model.scene) {
        for (const csg::Part& part : model.scene.parts) {
            casts.push_back(part.kind == csg::PartKind::Solid && !part.hidden ? 1 : 0);
        }
    }

    SolidProbe probe;
    ExpressionLinks links;
    std::vector<char> casts;  ///< By part.
};

ShadowCaster::ShadowCaster(const Model& model) : state_(std::make_unique<State>(model)) {}
ShadowCaster::~ShadowCaster() = default;

std::vector<npr::ShadowBits> ShadowCaster::shadows(const base::View& view, const layers::HostStack& layers,
                                                   const std::stop_token& stop) const {
    std::vector<npr::ShadowBits> bits(static_cast<std::size_t>(layers.size.x) * static_cast<std::size_t>(layers.size.y),
                                      0);
    const glm::ivec2 blocks = (layers.size + kBlockSide - 1) / kBlockSide;
    base::for_each_index(
        blocks.x * blocks.y,
        [&] { return BlockShadows(state_->probe, state_->links, state_->casts, view, layers, bits); }, 0, stop);
    return bits;
}

const ShadowCaster& ShadowCasters::of(const Model& model) {
    if (!caster_ || model_ != &model || generation_ != model.generation) {
        caster_ = std::make_unique<ShadowCaster>(model);
        model_ = &model;
        generation_ = model.generation;
    }
    return *caster_;
}

}  // namespace ui
