#include "ui/pipeline/picture/sorted_mesh.h"

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

}  // namespace

bool draws_sorted(const npr::Picture& picture) {
    return picture.transparency == npr::Transparency::Sorted && picture.part_styles.empty() && picture.reveal.empty() &&
           picture.style == npr::find_style("shaded");
}

npr::ColoredMesh colored_mesh(const Model& model, const npr::ColorScheme& scheme, const std::stop_token& stop) {
    const auto table = goldfeather::surface_table(model.scene, model.geometry);
    const std::vector<char> cuts = subtracted(model.scene);
    npr::ColoredMesh result;
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
            throw ModelError("--transparency sorted draws a mesh: " + plain(error.what()));
        }
        const auto first = static_cast<std::uint32_t>(result.points.size());
        result.points.insert(result.points.end(), mesh.points.begin(), mesh.points.end());
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const std::uint32_t leaf = mesh.sources[i];
            result.triangles.push_back(mesh.triangles[i] + first);
            result.colors.push_back(color_of(table->leaves[leaf], table->parts[part].kind, cuts[leaf] != 0, scheme));
            result.parts.push_back(part);
        }
    }
    return result;
}

}  // namespace ui
