#include "ui/pipeline/picture/thickness_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <tuple>

#include <fmt/format.h>

#include "base/parallel.h"
#include "npr/samples.h"
#include "npr/srgb.h"
#include "ui/pipeline/infinity.h"
#include "ui/pipeline/inspection/face_check.h"
#include "ui/pipeline/inspection/solid_probe.h"
#include "ui/pipeline/model_parts.h"
#include "ui/pipeline/picture/legend.h"

namespace ui {

namespace {

constexpr float kUnmeasured = -1, kEmpty = -2;  // Beside lengths: no opposite face; nothing is seen.
constexpr std::size_t kMostPlaces = 5;
constexpr glm::vec3 kNeutral{0.62F};  // Linear: that of faces that are not measured.

bool is_measured(csg::PartKind kind) {
    return kind == csg::PartKind::Solid || kind == csg::PartKind::Translucent;
}

/// Which calls made the surfaces that a place lies between.
using Pair = std::pair<csg::SourceLocation, csg::SourceLocation>;
using Places = std::map<Pair, ThinPlace>;

double cosine_of_opposite() {
    return std::cos(glm::radians(kOppositeDegrees));
}

void keep_thinnest(Places& places, const Pair& pair, const ThinPlace& place) {
    const auto order = [](const ThinPlace& p) { return std::tuple(p.value, p.pixel.y, p.pixel.x); };
    const auto [at, added] = places.try_emplace(pair, place);
    if (!added && order(place) < order(at->second)) {
        at->second = place;
    }
}

/// Measures at what the pixels of one sample see. One for each thread.
class Gauge {
  public:
    Gauge(const SolidProbe& probe, const ExpressionLinks& links, const Model& shown, const ThicknessRequest& request)
        : probe_(probe), shown_(shown), request_(request), ray_(probe, links) {}

    /// World units, kUnmeasured or kEmpty.
    float measure(const base::View& view, const layers::Surface& surface, glm::dvec2 pixel) {
        if (!(surface.depth > 0)) {
            return kEmpty;
        }
        const csg::LeafInstance& seen = shown_.scene.leaves[surface.leaf];
        const csg::solid::Plane& plane = shown_.geometry.planes.planes()[surface.plane];
        const base::View::Ray ray = view.ray(pixel.x, view.size().y - 1 - pixel.y);
        const double slope = glm::dot(plane.normal, ray.direction);
        if (!is_measured(shown_.scene.parts[seen.part].kind) || slope == 0) {
            return kUnmeasured;
        }
        const glm::dvec3 point =
            ray.origin + (plane.offset - glm::dot(plane.normal, ray.origin)) / slope * ray.direction;
        const glm::dvec3 outwards = (slope > 0) == surface.leaving ? plane.normal : -plane.normal;
        probe_.sides(point, outwards, sides_);
        const bool wall = request_.what == ThicknessRequest::What::Wall;
        if (!ray_.at(sides_.behind).in_part(seen.part) || ray_.at(sides_.front).in_part(seen.part) ||
            (!wall && !ray_.at(sides_.front).parts().empty())) {
            return kUnmeasured;
        }
        const glm::dvec3 along = glm::normalize(ray.direction);
        const bool enters = glm::dot(along, outwards) < 0;
        const glm::dvec3 inwards = !request_.along_view ? -outwards : enters ? along : -along;
        const glm::dvec3 direction = wall ? inwards : -inwards;
        const auto hit = wall ? ray_.leave(seen.part, point, direction, sides_.behind, kInfinity)
                              : ray_.enter(point, direction, sides_.front, kInfinity);
        if (!hit || (!request_.along_view && hit->cosine < cosine_of_opposite())) {
            return kUnmeasured;
        }
        if (!sides_.met.empty()) {
            keep(seen.part, point, direction, *hit, pixel);
        }
        return static_cast<float>(hit->distance);
    }

    [[nodiscard]] const Places& places() const { return places_; }

  private:
    void keep(csg::PartId part, const glm::dvec3& point, const glm::dvec3& direction, const PartRay::Hit& hit,
              glm::dvec2 pixel) {
        const Crossing& own = sides_.met.front();
        const glm::dvec3 normal = probe_.normal(own.leaf, own.triangle);
        if (std::abs(glm::dot(normal, probe_.normal(hit.leaf, hit.triangle))) < cosine_of_opposite()) {
            return;  // A ray of the view that grazes an edge.
        }
        const auto& leaves = probe_.scene().leaves;
        const csg::LeafInstance &a = leaves[own.leaf], &b = leaves[hit.leaf];
        keep_thinnest(places_, std::minmax(a.where, b.where),
                      {hit.distance, point, direction, part, a.occurrence, b.occurrence, pixel + 0.5});
    }

    const SolidProbe& probe_;
    const Model& shown_;
    const ThicknessRequest& request_;
    PartRay ray_;
    SolidProbe::Sides sides_;
    Places places_;
};

/// A row of pixels at a time.
struct RowGauge {
    const base::View& view;
    const layers::HostStack& stack;
    std::vector<float>& values;
    std::mutex& mutex;
    Places& places;
    Gauge gauge;

    void operator()(int y) {
        for (int x = 0; x < stack.size.x; ++x) {
            values[static_cast<std::size_t>(y * stack.size.x + x)] =
                gauge.measure(view, stack.at(0, x, stack.size.y - 1 - y), {x, y});
        }
    }
    ~RowGauge() {
        const std::lock_guard lock(mutex);
        for (const auto& [pair, place] : gauge.places()) {
            keep_thinnest(places, pair, place);
        }
    }
};

/// Half of all places are thinner.
double own_range(const std::vector<float>& values) {
    std::vector<float> measured;
    std::copy_if(values.begin(), values.end(), std::back_inserter(measured), [](float v) { return v > 0; });
    if (measured.empty()) {
        return 0;
    }
    const auto at = measured.begin() + static_cast<std::ptrdiff_t>(measured.size() / 2);
    std::nth_element(measured.begin(), at, measured.end());
    return round_up(static_cast<double>(*at));
}

glm::vec3 linear(const glm::vec3& srgb) {
    const npr::SrgbTables& tables = npr::SrgbTables::get();
    return {tables.linear(srgb.r), tables.linear(srgb.g), tables.linear(srgb.b)};
}

glm::vec3 tint_of(float value, double range) {
    return value == kEmpty        ? glm::vec3(1)
           : value == kUnmeasured ? kNeutral
                                  : linear(thickness_tone(static_cast<float>(std::min(1.0, value / range))));
}

}  // namespace

glm::vec3 thickness_tone(float share) {
    static constexpr std::array<glm::vec3, 5> kTones{glm::vec3(0.9F, 0.1F, 0.12F), glm::vec3(0.97F, 0.5F, 0.15F),
                                                     glm::vec3(1.0F, 0.9F, 0.35F), glm::vec3(0.55F, 0.82F, 0.6F),
                                                     glm::vec3(0.45F, 0.68F, 0.9F)};
    const float at = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kTones.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(at), kTones.size() - 2);
    return glm::mix(kTones[below], kTones[below + 1], at - static_cast<float>(below));
}

struct ThicknessGauge::State {
    explicit State(const Model& model) : probe(model.scene, model.geometry), links(model.scene) {}

    SolidProbe probe;
    ExpressionLinks links;
    std::optional<double> range;             ///< That was asked for.
    std::vector<std::vector<float>> values;  ///< By sample and pixel.
    Places places;
};

ThicknessGauge::ThicknessGauge(const Model& model) : state_(std::make_unique<State>(model)) {}
ThicknessGauge::~ThicknessGauge() = default;

void ThicknessGauge::measure(Renderer& renderer, const Model& shown, const PictureRequest& picture,
                             const ThicknessRequest& request, int sample, const std::stop_token& stop) {
    State& state = *state_;
    if (sample == 0) {
        state.values.clear();
        state.places.clear();
        state.range = request.range;
    }
    if (shown.empty()) {
        return;
    }
    const base::View view =
        npr::sample_view(picture, static_cast<std::size_t>(sample), shown.geometry.box.lo, shown.geometry.box.hi);
    const auto stack = renderer.first_layer(shown, view);
    std::vector<float> values(static_cast<std::size_t>(picture.size.x) * static_cast<std::size_t>(picture.size.y),
                              kEmpty);
    std::mutex mutex;
    base::for_each_index(
        picture.size.y,
        [&] {
            return RowGauge{view, *stack, values, mutex, state.places, Gauge(state.probe, state.links, shown, request)};
        },
        0, stop);
    state.values.push_back(std::move(values));
}

ThicknessMap ThicknessGauge::map() const {
    ThicknessMap map;
    const std::size_t samples = state_->values.size();
    if (samples == 0) {
        return map;
    }
    map.range = state_->range ? *state_->range : own_range(state_->values.front());
    map.tint.assign(state_->values.front().size(), glm::vec3(0));
    for (const std::vector<float>& of_sample : state_->values) {
        for (std::size_t i = 0; i < of_sample.size(); ++i) {
            map.tint[i] += tint_of(of_sample[i], std::max(map.range, 1e-300)) / static_cast<float>(samples);
        }
    }
    for (const auto& [pair, place] : state_->places) {
        map.places.push_back(place);
    }
    std::stable_sort(map.places.begin(), map.places.end(),
                     [](const ThinPlace& a, const ThinPlace& b) { return a.value < b.value; });
    map.places.resize(std::min(map.places.size(), kMostPlaces));
    return map;
}

ThicknessMap thickness_map(Renderer& renderer, const Model& model, const Model& shown, const PictureRequest& picture,
                           const ThicknessRequest& request, const std::stop_token& stop) {
    if (shown.empty()) {
        return {};
    }
    ThicknessGauge gauge(model);
    const auto samples = static_cast<int>(npr::sample_offsets(picture.samples).size());
    for (int sample = 0; sample < samples; ++sample) {
        gauge.measure(renderer, shown, picture, request, sample, stop);
    }
    return gauge.map();
}

std::shared_ptr<const Model> without_colors(const Model& model) {
    auto plain = std::make_shared<Model>(model);
    plain->generation = next_generation();
    const auto take = [](csg::Rgba& color) { color = {-1, -1, -1, color.a}; };
    for (csg::LeafInstance& leaf : plain->scene.leaves) {
        take(leaf.color);
    }
    for (csg::Part& part : plain->scene.parts) {
        take(part.color);
    }
    return plain;
}

void tint(base::Image& image, const ThicknessMap& map) {
    const npr::SrgbTables& tables = npr::SrgbTables::get();
    for (std::size_t i = 0; i < map.tint.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            std::uint8_t& byte = image.rgba[4 * i + static_cast<std::size_t>(c)];
            byte = tables.byte(tables.linear(static_cast<float>(byte) / 255) * map.tint[i][c]);
        }
    }
}

void draw_thickness(base::Image& image, const ThicknessMap& map, const glm::vec3& ground) {
    if (map.tint.empty()) {
        return;
    }
    tint(image, map);
    for (std::size_t i = 0; i < map.places.size(); ++i) {
        const glm::dvec2 at = map.places[i].pixel;
        const auto crowds = [&](const ThinPlace& other) {
            const glm::dvec2 apart = glm::abs(other.pixel - at) / static_cast<double>(image.height);
            return apart.x < 0.15 && apart.y < 0.03;
        };
        const auto before = map.places.begin() + static_cast<std::ptrdiff_t>(i);
        const auto lower = std::count_if(map.places.begin(), before, crowds);
        draw_ring(image, at, fmt::format("{:.3g}", map.places[i].value), static_cast<int>(lower));
    }
    draw_legend(image, map.range, thickness_tone, ground);
}

}  // namespace ui
