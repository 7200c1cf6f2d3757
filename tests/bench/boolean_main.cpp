// csgscope_boolean FILE.scad [LEAVES.json] [planes|exact]: what the boolean of a model's leaves costs, by the named
// method or by whichever decides, without reading, evaluating or placing them, as JSON; and the leaves with the
// expression over them, for other libraries to combine.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "csg/reference/boolean.h"
#include "csg/scad/scad.h"
#include "ui/pipeline/comparison/solid_scene.h"
#include "ui/pipeline/model.h"

namespace {

using Json = nlohmann::json;

/// Processor time of all threads, milliseconds.
double cpu_ms() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) / 1e6;
}

/// {"leaves": [{"points": [x, y, z, …], "triangles": [a, b, c, …]}, …], "expressions": [{"kind": …, "leaf": …,
/// "children": […]}, …]}: the last expression is the model.
Json leaves_json(const ui::SolidScene& solid) {
    Json leaves = Json::array(), expressions = Json::array();
    for (const auto& leaf : solid.geometry.leaves) {
        std::vector<double> points;
        std::vector<std::uint32_t> triangles;
        for (const glm::dvec3& p : leaf.points) {
            points.insert(points.end(), {p.x, p.y, p.z});
        }
        for (const glm::uvec3& t : leaf.triangles) {
            triangles.insert(triangles.end(), {t.x, t.y, t.z});
        }
        leaves.push_back({{"points", points}, {"triangles", triangles}});
    }
    constexpr const char* kinds[] = {"leaf", "union", "intersection", "difference"};
    for (const csg::Expression& e : solid.scene.expressions) {
        const auto children = solid.scene.children(e);
        expressions.push_back({{"kind", kinds[static_cast<std::size_t>(e.kind)]},
                               {"leaf", e.leaf},
                               {"children", std::vector<std::uint32_t>(children.begin(), children.end())}});
    }
    return {{"leaves", leaves}, {"expressions", expressions}};
}

int run(const std::string& file, const std::string& leaves_file, const csg::reference::BooleanRequest& how) {
    csg::scad::Request request;
    request.path = file;
    request.preview = false;
    const auto evaluation = csg::scad::evaluate(request, [](const auto&, const auto&) {});
    if (!evaluation.ok) {
        throw std::runtime_error(file + " has errors");
    }
    const auto model = ui::ModelBuilder().build(evaluation.tree);
    const ui::SolidScene solid = ui::solid_scene(model->scene, model->geometry);
    if (!leaves_file.empty()) {
        std::ofstream(leaves_file) << leaves_json(solid);
    }
    double best = 1e300;
    csg::reference::BooleanResult result;
    for (int i = 0; i < 3; ++i) {
        const double start = cpu_ms();
        result = csg::reference::make_mesh(solid.scene, solid.geometry, how);
        best = std::min(best, cpu_ms() - start);
    }
    fmt::print("{}\n", Json{{"cpu_ms", best},
                            {"leaves", solid.scene.leaves.size()},
                            {"triangles", result.mesh.triangles.size()},
                            {"volume", result.facts.volume},
                            {"components", result.facts.components},
                            {"genus", result.facts.genus},
                            {"method", csg::reference::name(result.method)},
                            {"reason", result.reason}}
                           .dump());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::string> files;
        csg::reference::BooleanRequest how;
        for (int i = 1; i < argc; ++i) {
            const std::string argument = argv[i];
            if (argument == "planes") {
                how.method = csg::reference::Method::Planes;
            } else if (argument == "exact") {
                how.method = csg::reference::Method::Exact;
            } else {
                files.push_back(argument);
            }
        }
        if (files.empty() || files.size() > 2) {
            throw std::runtime_error("usage: csgscope_boolean FILE.scad [LEAVES.json] [planes|exact]");
        }
        return run(files[0], files.size() == 2 ? files[1] : "", how);
    } catch (const std::exception& error) {
        fmt::print(stderr, "csgscope_boolean: {}\n", error.what());
        return 1;
    }
}
