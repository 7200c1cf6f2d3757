// Booleans of random solids: the exact mesh and the picture against the winding numbers of the leaves along rays, and
// the volume of what is made of unit cubes.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "csg/reference/boolean.h"
#include "csg/scad/text/csg_text.h"
#include "goldfeather/lists_cpu/lists_cpu.h"
#include "tests/fuzz/random_solids.h"
#include "tests/fuzz/ray_lengths.h"

namespace {

constexpr int kSide = 8;  ///< Of the grid and the picture: a pixel is a unit.
/// Vertices of a picture are rounded to 1/256 of a pixel (docs/ENGINES.md); the rest is for the exact mesh, whose
/// points may be off by the tolerance of the plane table.
constexpr double kPictureMargin = 1.0 / 180, kMeshMargin = 1e-6;
/// Depths are floats.
constexpr double kDepthError = 0x1p-22;

/// Rays away from the places where edges of a grid are seen. Each stands for its unit square, where all is of unit
/// cubes.
const glm::dvec2 kJitter(0.1237, -0.2871);

/// The model, its mesh and picture, and what rays say about them.
class Sample {
  public:
    explicit Sample(fuzz::Bytes& bytes) : model_(fuzz::solid_tree(bytes)), scene_(csg::make_scene(model_.tree)) {
        static csg::solid::SolidCache cache;
        geometry_ = csg::solid::place(model_.tree, scene_, cache);
        cache.trim();
        cache.trim();
    }

    void check(bool both_methods) const {
        if (scene_.parts.empty()) {
            return;
        }
        const csg::reference::BooleanResult result = mesh({});
        if (both_methods) {
            const double exact = mesh(csg::reference::Method::Exact).facts.volume;
            if (std::abs(exact - result.facts.volume) > 1e-7) {
                fail("volumes by planes and by exact arithmetic", result.facts.volume, exact);
            }
        }
        if (geometry_.box.empty()) {
            if (!result.mesh.empty()) {
                fail("a mesh of nothing", result.facts.volume, 0);
            }
            return;
        }
        const base::View view = from_above();
        const std::vector<glm::dvec2> rays = rays_of(view);
        const auto right = fuzz::lengths_inside(scene_, geometry_, rays);
        check_mesh(result.mesh, right, rays);
        check_picture(view, right);
        check_cubes(result.facts.volume, right);
    }

  private:
    [[noreturn]] void fail(const char* what, double is, double right) const {
        std::fprintf(stderr, "%s: %.17g instead of %.17g\n%s", what, is, right,
                     csg::scad::csg_text(model_.tree).c_str());
        std::abort();
    }

    [[nodiscard]] csg::reference::BooleanResult mesh(std::optional<csg::reference::Method> method) const {
        try {
            csg::reference::BooleanRequest request;
            request.method = method;
            request.threads = 1;
            return csg::reference::make_mesh(scene_, geometry_, request);
        } catch (const std::exception& problem) {
            fail(problem.what(), 0, 0);
        }
    }

    [[nodiscard]] base::View from_above() const {
        base::Camera camera;
        camera.target = glm::dvec3(0.5 * kSide, 0.5 * kSide, 0);
        camera.rotation = glm::dvec3(0.0);
        camera.fov = 90;
        camera.distance = 0.5 * kSide;  // Of an orthographic view with that angle: half its height.
        camera.projection = base::Projection::Orthographic;
        return {camera, {kSide, kSide}, geometry_.box.lo, geometry_.box.hi, kJitter};
    }
    static std::vector<glm::dvec2> rays_of(const base::View& view) {
        std::vector<glm::dvec2> rays;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                rays.emplace_back(view.ray(x, y).origin);
            }
        }
        return rays;
    }

    void check_mesh(const csg::reference::Mesh& mesh, const std::vector<fuzz::RayLength>& right,
                    const std::vector<glm::dvec2>& rays) const {
        const auto found = fuzz::lengths_inside(mesh, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const double error = 1e-11 + 4 * geometry_.planes.tolerance() * (right[i].slopes + found[i].slopes);
            if (right[i].nearest > kMeshMargin && std::abs(found[i].length - right[i].length) > error) {
                std::fprintf(stderr, "at (%g, %g): ", rays[i].x, rays[i].y);
                fail("inside the mesh", found[i].length, right[i].length);
            }
        }
    }

    void check_picture(const base::View& view, const std::vector<fuzz::RayLength>& right) const {
        const goldfeather::ListsModel lists(scene_, geometry_);
        layers::HostStack stack;
        goldfeather::ListsStats stats;
        goldfeather::peel_lists(lists, view, 0, 1, stack, stats);
        const double depth_error = kDepthError * (view.far_distance() - view.near_distance());
        for (std::size_t i = 0; i < right.size(); ++i) {
            double length = 0;
            for (std::size_t layer = 0; layer < static_cast<std::size_t>(stack.counts[i]); ++layer) {
                const auto& plane = stack.planes[layer];
                const auto surface = layers::decode(plane.depth[i], plane.surface[i]);
                length += (surface.leaving ? 1 : -1) * view.distance(surface.depth);
            }
            if (right[i].nearest > kPictureMargin &&
                std::abs(length - right[i].length) > 1e-11 + depth_error * right[i].slopes) {
                std::fprintf(stderr, "at pixel (%d, %d): ", static_cast<int>(i) % kSide, static_cast<int>(i) / kSide);
                fail("inside the picture", length, right[i].length);
            }
        }
    }

    void check_cubes(double volume, const std::vector<fuzz::RayLength>& right) const {
        const csg::Box& box = geometry_.box;
        if (!model_.of_unit_cubes || box.lo.x < 0 || box.lo.y < 0 || box.hi.x > kSide || box.hi.y > kSide) {
            return;
        }
        double sum = 0;
        for (const fuzz::RayLength& ray : right) {
            sum += ray.length;
        }
        if (std::abs(volume - std::round(sum)) > 1e-9 || std::abs(sum - std::round(sum)) > 1e-9) {
            fail("volume of unit cubes", volume, sum);
        }
    }

    fuzz::SolidTree model_;
    csg::Scene scene_;
    csg::solid::Geometry geometry_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) {
        return 0;
    }
    fuzz::Bytes bytes(data, size);
    // Exact arithmetic is slow.
    const bool both_methods = bytes.below(16) == 1;
    Sample(bytes).check(both_methods);
    return 0;
}
