#include "tests/stability/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace stability {

namespace {

using comparison::Subject;
using layers::HostStack;

/// More than that and the walk takes minutes on a software renderer.
constexpr std::size_t kMostLeavesOfTheWalk = 300;
/// The same for OpenCSG, over all products.
constexpr std::size_t kMostLiteralsOfOpenCsg = 5000;

/// A ray costs as many steps as there are leaves. With more leaves than this, some of the pixels are tested.
constexpr std::size_t kMostLeavesOfAllRays = 20000;
constexpr int kStepOfRays = 11;  ///< Prime to the usual widths: visits all columns.

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The truth of a picture, cast once for all engines.
struct Truth {
    Truth(const Subject& subject, const base::View& v) : view(v), diagonal(subject.geometry.box.diagonal()) {
        const truth::RayCaster caster(subject.scene, subject.geometry, view);
        const int step = subject.scene.leaves.size() > kMostLeavesOfAllRays ? kStepOfRays : 1;
        for (int i = 0; i < view.size().x * view.size().y; i += step) {
            const glm::ivec2 pixel(i % view.size().x, i / view.size().x);
            rays.push_back({pixel, caster.cast(pixel.x, pixel.y)});
            pixels += rays.back().ray.hit ? 1 : 0;
            undecided += rays.back().ray.decided ? 0 : 1;
        }
    }
    struct PixelRay {
        glm::ivec2 pixel;
        truth::Ray ray;
    };
    base::View view;
    double diagonal;
    std::vector<PixelRay> rays;
    std::size_t pixels = 0, undecided = 0;
};

/// Depth errors of first surfaces, as they come in.
class DepthErrors {
  public:
    explicit DepthErrors(double diagonal) : diagonal_(std::max(diagonal, 1e-300)) {}
    void add(double distance, double expected) {
        const double error = std::abs(distance - expected) / diagonal_;
        squares_ += error * error;
        most_ = std::max(most_, error);
        ++count_;
    }
    void store(Errors& errors) const {
        errors.depth_rms = count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0;
        errors.depth_most = most_;
    }

  private:
    double diagonal_, squares_ = 0, most_ = 0;
    std::size_t count_ = 0;
};

/// `most_layers`: that the engine finds.
Errors compare(const Subject& subject, const Truth& truth, const layers::HostStack& stack, int most_layers) {
    Errors errors;
    errors.drawn = true;
    DepthErrors depth(truth.diagonal);
    const auto& planes = subject.geometry.planes.planes();
    for (const Truth::PixelRay& cast : truth.rays) {
        truth::Ray ray = cast.ray;
        if (most_layers != goldfeather::kAllLayers && ray.surfaces.size() > static_cast<std::size_t>(most_layers)) {
            ray.surfaces.resize(static_cast<std::size_t>(most_layers));
        }
        const int x = cast.pixel.x, y = cast.pixel.y;
        std::vector<layers::Surface> actual;
        for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0; ++layer) {
            actual.push_back(stack.at(layer, x, y));
        }
        const bool same =
            std::equal(ray.surfaces.begin(), ray.surfaces.end(), actual.begin(), actual.end(), comparison::same);
        errors.wrong += ray.decided && !same ? 1 : 0;
        errors.coverage += ray.surfaces.empty() != actual.empty() ? 1 : 0;
        errors.layers += ray.surfaces.size() != actual.size() ? 1 : 0;
        if (!ray.surfaces.empty() && !actual.empty()) {
            depth.add(truth.view.distance(static_cast<double>(actual[0].depth)), ray.surfaces[0].distance);
            constexpr double kOneDegree = 0.99984769516;  // its cosine
            const auto& expected = ray.surfaces[0].planes;
            errors.normal += std::none_of(expected.begin(), expected.end(),
                                          [&](std::uint32_t plane) {
                                              return std::abs(glm::dot(planes[plane].normal,
                                                                       planes[actual[0].plane].normal)) >= kOneDegree;
                                          })
                                 ? 1
                                 : 0;
        }
    }
    depth.store(errors);
    return errors;
}

std::size_t literals(const Subject& subject) {
    std::size_t count = 0;
    for (const auto& part : subject.products) {
        for (const goldfeather::Product& product : part) {
            count += product.literals.size();
        }
    }
    return count;
}

/// OpenCSG gives the depth of the first surface only, with 24 bits between its near and far plane: wrong is what is off
/// by more than a thousandth of the scene, or lies on no surface at all.
Errors compare(const Truth& truth, const opencsg::Picture& picture) {
    Errors errors;
    errors.drawn = true;
    DepthErrors depth(truth.diagonal);
    for (const Truth::PixelRay& cast : truth.rays) {
        const truth::Ray& ray = cast.ray;
        const double distance =
            picture.distance[static_cast<std::size_t>(cast.pixel.y * picture.size.x + cast.pixel.x)];
        const bool hit = std::isfinite(distance);
        const bool covered = hit == !ray.surfaces.empty();
        errors.coverage += covered ? 0 : 1;
        bool same = covered;
        if (hit && !ray.surfaces.empty()) {
            depth.add(distance, ray.surfaces[0].distance);
            same = std::abs(distance - ray.surfaces[0].distance) <= 1e-3 * truth.diagonal;
        }
        errors.wrong += ray.decided && !same ? 1 : 0;
    }
    depth.store(errors);
    return errors;
}

}  // namespace

Sweep::Sweep(const SweepOptions& options) : options_(options) {
    for (const goldfeather::EngineInfo& info : goldfeather::engines()) {
        const std::string name(info.name);
        auto made = comparison::make_engine(info, gl::ContextKind::Egl);
        if (made.engine) {
            engines_.push_back({name, std::move(made.engine)});
        } else {
            missing_.push_back(name + ": " + made.reason);
        }
    }
    auto made = opencsg::create(glm::ivec2(options.size));
    opencsg_ = std::move(made.engine);
    if (!opencsg_) {
        missing_.push_back("OpenCSG: " + made.reason);
    }
}

std::vector<Measure> Sweep::run(const Family& family) {
    std::vector<Measure> measures;
    std::vector<double> levels = family.levels;
    if (options_.few_levels && levels.size() > 3) {
        levels = {levels.front(), levels[levels.size() / 2], levels.back()};
    }
    for (const double level : levels) {
        measure(family, level, measures);
    }
    return measures;
}

void Sweep::measure(const Family& family, double level, std::vector<Measure>& measures) {
    Case shown = family.make(level);
    const Subject subject(shown.tree);
    const std::size_t leaves = subject.scene.leaves.size();
    if (leaves > options_.most_leaves) {
        return;
    }
    for (const bool orthographic : {false, true}) {
        shown.camera.projection = orthographic ? base::Projection::Orthographic : base::Projection::Perspective;
        const base::View view = subject.view(shown.camera, glm::ivec2(options_.size));
        const Truth truth(subject, view);
        const auto add = [&](const std::string& engine, const Errors& errors) {
            measures.push_back({family.name, engine, level, orthographic, truth.pixels, truth.undecided, errors});
        };
        for (const Engine& e : engines_) {
            Errors errors;
            if (!e.engine->capabilities().needs_products ||
                (subject.over_budget == 0 && leaves <= kMostLeavesOfTheWalk)) {
                const double start = now_ms();
                try {
                    const layers::HostStack stack = e.engine->peel(subject, view, e.engine->capabilities().most_layers);
                    const double spent = now_ms() - start;
                    errors = compare(subject, truth, stack, e.engine->capabilities().most_layers);
                    errors.milliseconds = spent;
                } catch (const goldfeather::EngineObstacle&) {
                    errors = {};  // Not drawn by this one.
                }
            }
            add(e.name, errors);
        }
        if (opencsg_) {
            Errors errors;
            if (subject.over_budget == 0 && literals(subject) <= kMostLiteralsOfOpenCsg) {
                opencsg_->load(subject.geometry, subject.products, view, opencsg::Algorithm::Automatic);
                const double start = now_ms();
                opencsg_->draw();
                const double spent = now_ms() - start;
                errors = compare(truth, opencsg_->read());
                errors.milliseconds = spent;
            }
            add("OpenCSG", errors);
        }
    }
}

}  // namespace stability
