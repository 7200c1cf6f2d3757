#include "ui/pipeline/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "csg/solid/located.h"
#include "csg/tree/out_of_memory.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

ModelMesh make_mesh(const Model& model, const std::stop_token& stop) {
    need_whole(model);
    ModelMesh result;
    Stopwatch watch;
    try {
        auto found = csg::reference::make_mesh(model.scene, model.geometry, {.method = {}, .stop = stop});
        result.mesh = std::move(found.mesh);
        result.facts = found.facts;
        result.method = csg::reference::name(found.method);
        result.reason = std::move(found.reason);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const csg::reference::LeafError& error) {
        throw ModelError(csg::solid::located(*model.tree, model.scene.leaves[error.leaf()].where, plain(error.what())));
    } catch (const std::length_error&) {
        throw csg::OutOfMemory("the mesh");
    } catch (const std::exception& error) {
        throw ModelError(plain(error.what()));
    }
    result.boolean_ms = watch.lap();
    if (result.mesh.empty()) {
        throw ModelError("the model is empty: there is no solid to export");
    }
    return result;
}

namespace {

/// "part 2 (case.scad:14)": folders are left out, so that the bytes do not depend on where the files are.
std::string part_name(const Model& model, std::size_t number, csg::LeafId leaf) {
    const csg::SourceLocation& where = model.scene.leaves[leaf].where;
    const auto& files = model.tree->files();
    return where.known() && where.file < files.size()
               ? fmt::format("part {} ({}:{})", number,
                             printable(std::filesystem::path(files[where.file]).filename().string()), where.line)
               : fmt::format("part {}", number);
}

}  // namespace

std::string encode_mesh(const Model& model, const ModelMesh& mesh, MeshFormat format,
                        const csg::reference::ThreeMfOptions& three_mf, const csg::reference::PovView& view,
                        const std::stop_token& stop) {
    // One part of the file for each color, in the order of the leaves.
    csg::reference::MeshDocument document{mesh.mesh, {}, {}, three_mf, view};
    std::map<std::array<float, 4>, std::uint32_t> known;
    const csg::reference::MeshPart plain;
    std::vector<std::uint32_t> of_leaf(model.scene.leaves.size());
    std::vector<char> used(model.scene.leaves.size(), 0);
    for (const std::uint32_t leaf : mesh.mesh.sources) {
        used[leaf] = 1;
    }
    for (std::size_t leaf = 0; leaf < model.scene.leaves.size(); ++leaf) {
        if (used[leaf] == 0) {
            continue;
        }
        const csg::Rgba& c = model.scene.leaves[leaf].color;
        std::array<float, 4> rgba{c.r, c.g, c.b, c.a};
        for (std::size_t i = 0; i < rgba.size(); ++i) {
            rgba[i] = rgba[i] < 0 ? plain.rgba[i] : std::min(rgba[i], 1.0F);
        }
        const auto [at, added] = known.try_emplace(rgba, static_cast<std::uint32_t>(document.parts.size()));
        if (added) {
            document.parts.push_back(
                {part_name(model, document.parts.size() + 1, static_cast<csg::LeafId>(leaf)), rgba});
        }
        of_leaf[leaf] = at->second;
    }
    for (const std::uint32_t leaf : mesh.mesh.sources) {
        document.part_of.push_back(of_leaf[leaf]);
    }
    return csg::reference::encode(document, format, stop);
}

Json to_json(const ModelMesh& mesh) {
    const auto array = [](const glm::dvec3& v) { return Json{v.x, v.y, v.z}; };
    const auto& f = mesh.facts;
    Json json = {{"dimensions", 3},
                 {"facets", mesh.mesh.triangles.size()},
                 {"vertices", mesh.mesh.points.size()},
                 {"edges", mesh.mesh.triangles.size() / 2 * 3},
                 {"triangular", true},
                 {"simple", f.manifold},
                 {"self_intersecting", false},  // or there would be no mesh: see make_mesh
                 {"components", f.components},
                 {"genus", f.genus},
                 {"area", f.area},
                 {"volume", f.volume},
                 {"bounding_box", {{"min", array(f.box.lo)}, {"max", array(f.box.hi)}, {"size", array(f.box.size())}}},
                 {"method", mesh.method}};
    if (!mesh.reason.empty()) {
        json["reason"] = mesh.reason;
    }
    return json;
}

}  // namespace ui
