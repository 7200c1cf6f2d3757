#include "ui/pipeline/picture/sorted_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "base/stop.h"
#include "csg/reference/boolean.h"
#include "goldfeather/surface_table.h"
#include "npr/style.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

/// By leaf: is it subtracted, so that its faces are cuts?
std::vector<char> subtracted(const csg::Scene& scene) {
    std::vector<char> of_leaf(scene.leaves.size(), 0), of_expression(scene.expressions.size(), 0);
    for (std::size_t i = scene.expressions.size(); i-- > 0;) {
        const csg::Expression& e = scene.expressions[i];
        if (e.kind == csg::ExpressionKind::Leaf) {
            of_leaf[e.leaf] = of_expression[i];
            continue;
        }
        const auto children = scene.children(e);
        for (std::size_t c = 0; c < children.size(); ++c) {
            const bool turns = e.kind == csg::ExpressionKind::Difference && c > 0;
            of_expression[children[c]] = static_cast<char>((of_expression[i] != 0) != turns ? 1 : 0);
        }
    }
    return of_leaf;
}

/// As npr/surface_color.glsl has it.
glm::vec4 color_of(const layers::LeafRow& row, layers::PartKind kind, bool cut, const npr::ColorScheme& scheme) {
    if (kind == layers::PartKind::Highlight) {
        return scheme.highlight;
    }
    const bool shows_cut = cut && kind == layers::PartKind::Solid;
    glm::vec4 color =
        kind == layers::PartKind::Background ? scheme.ghost : glm::vec4(shows_cut ? scheme.cut : scheme.face, 1);
    for (int i = 0; i < 4; ++i) {
        color[i] = row.color[i] >= 0 ? row.color[i] : color[i];
    }
    return color;
}

/// Which planes of the table triangles of a result lie in.
class FacePlanes {
  public:
    explicit FacePlanes(const csg::solid::Geometry& geometry) : geometry_(geometry) {}

    /// Of the leaf's planes the one that the triangle is nearest to.
    std::uint32_t of(std::uint32_t leaf, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        found_.clear();
        geometry_.planes.find_all(csg::solid::plane_through(a, b, c), a, b, c, found_);
        const std::vector<csg::solid::PlaneRef>& own = geometry_.leaves[leaf].planes;
        std::sort(found_.begin(), found_.end());
        found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
        std::uint32_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        const auto look_at = [&](std::uint32_t plane) {
            const csg::solid::Plane& p = geometry_.planes.planes()[plane];
            const auto away = [&](const glm::dvec3& corner) { return std::abs(glm::dot(p.normal, corner) - p.offset); };
            const double farthest = std::max({away(a), away(b), away(c)});
            if (farthest < least) {
                least = farthest;
                best = plane;
            }
        };
        for (const std::uint32_t plane : found_) {
            look_at(plane);
        }
        if (found_.empty()) {  // A sliver, whose corners do not tell its plane well.
            for (const csg::solid::PlaneRef& plane : own) {
                look_at(plane.index);
            }
        }
        return best;
    }

  private:
    const csg::solid::Geometry& geometry_;
    std::vector<std::uint32_t> found_;
};

}  // namespace

bool draws_sorted(const npr::Picture& picture) {
    return picture.transparency == npr::Transparency::Sorted &&
           (npr::follows_transparency(*picture.style) ||
            std::any_of(picture.part_styles.begin(), picture.part_styles.end(),
                        [](const npr::PartStyle& each) { return npr::follows_transparency(*each.style); }));
}

bool sorts_layers(const npr::Picture& picture) {
    return picture.style != npr::find_style("shaded") || !picture.part_styles.empty() || !picture.reveal.empty() ||
           !picture.sections.cuts.empty();
}

npr::ColoredMesh colored_mesh(const Model& model, const npr::ColorScheme& scheme, const std::stop_token& stop) {
    const auto table = goldfeather::surface_table(model.scene, model.geometry);
    const std::vector<char> cuts = subtracted(model.scene);
    npr::ColoredMesh result;
    FacePlanes planes(model.geometry);
    csg::Scene scene = model.scene;
    for (std::uint32_t part = 0; part < scene.parts.size(); ++part) {
        if (model.scene.parts[part].hidden) {
            continue;
        }
        for (std::uint32_t other = 0; other < scene.parts.size(); ++other) {
            scene.parts[other].kind = other == part ? csg::PartKind::Solid : csg::PartKind::Background;
        }
        csg::reference::Mesh mesh;
        try {
            mesh = csg::reference::make_mesh(scene, model.geometry, {.method = {}, .stop = stop}).mesh;
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const base::Stopped&) {
            throw;
        } catch (const std::exception& error) {
            throw ModelError("this --transparency needs a mesh: " + plain(error.what()));
        }
        const auto first = static_cast<std::uint32_t>(result.points.size());
        result.points.insert(result.points.end(), mesh.points.begin(), mesh.points.end());
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const std::uint32_t leaf = mesh.sources[i];
            result.triangles.push_back(mesh.triangles[i] + first);
            result.colors.push_back(color_of(table->leaves[leaf], table->parts[part].kind, cuts[leaf] != 0, scheme));
            result.parts.push_back(part);
            const auto corner = [&](int c) { return mesh.points[mesh.triangles[i][c]]; };
            result.faces.push_back({leaf, planes.of(leaf, corner(0), corner(1), corner(2)), cuts[leaf] != 0});
        }
    }
    return result;
}

const npr::ColoredMesh& PartMeshes::of(const Model& model, const npr::ColorScheme& scheme,
                                       const std::stop_token& stop) {
    if (!mesh_ || generation_ != model.generation || !(scheme_ == scheme)) {
        mesh_ = colored_mesh(model, scheme, stop);
        generation_ = model.generation;
        scheme_ = scheme;
    }
    return *mesh_;
}

}  // namespace ui
