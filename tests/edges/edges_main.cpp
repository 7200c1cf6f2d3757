// Prints the table of docs/EDGES.md: csgscope_edges [--size PIXELS] [--sobel] FILE...
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>

#include "tests/bench/subject.h"
#include "tests/edges/edge_points.h"

namespace {

using edges::Kind;
using edges::Point;
using edges::Score;

struct Direction {
    const char* name;
    glm::dvec3 rotation;
};
constexpr Direction kDirections[] = {{"oblique", {55, 0, 25}}, {"front", {90, 0, 0}}, {"top", {0, 0, 0}}};

std::string percent(const Score& s) {
    return fmt::format("{:.3f} {:.3f} {:.3f}", s.precision(), s.recall(), s.f());
}

std::string cell(const std::vector<Point>& truth, const std::vector<Point>& found, glm::ivec2 size, Kind kind) {
    // What is drawn as another kind is found all the same; what is drawn as this one is right near any.
    const auto of_kind = [&](const Point& p) { return p.kind == kind; };
    const Score drawn = edges::score(truth, edges::only(found, of_kind), size);
    const Score there = edges::score(edges::only(truth, of_kind), found, size);
    const Score s{drawn.drawn, drawn.right, there.points, there.found};
    return s.drawn + s.points == 0 ? "–" : percent(s);
}

void measure(const std::string& path, glm::ivec2 size, bool sobel) {
    const bench::Subject subject = bench::from_file(path);
    const ui::ModelMesh mesh = ui::make_mesh(*subject.model);
    for (const Direction& direction : kDirections) {
        base::Camera camera;
        camera.rotation = direction.rotation;
        camera.projection = direction.rotation.x == 55 ? base::Projection::Perspective : base::Projection::Orthographic;
        const csg::Box& box = subject.model->geometry.box;
        base::view_all(camera, box.lo, box.hi, true);
        const base::View view(camera, size, box.lo, box.hi);
        const auto truth = edges::true_points(*subject.model, mesh.mesh, view);
        const auto stack = edges::layers_of(*subject.model, view);
        const auto found = edges::found_points(stack, view);
        const auto visible = [](const Point& p) { return !p.hidden; };
        const auto hidden = [](const Point& p) { return p.hidden; };
        const auto seen = edges::only(truth, visible), drawn = edges::only(found, visible);
        // A hidden line may lie on a visible one, and is then drawn as that.
        const Score behind{
            edges::only(found, hidden).size(), edges::score(truth, edges::only(found, hidden), size).right,
            edges::only(truth, hidden).size(), edges::score(edges::only(truth, hidden), found, size).found};
        fmt::print("| {} | {} | {} | {} | {} | {} | {} |", subject.name, direction.name,
                   percent(edges::score(seen, drawn, size)), cell(seen, drawn, size, Kind::Silhouette),
                   cell(seen, drawn, size, Kind::Crease), cell(seen, drawn, size, Kind::Border), percent(behind));
        if (sobel) {
            for (const edges::Buffer buffer : {edges::Buffer::Depth, edges::Buffer::Normal, edges::Buffer::Id}) {
                fmt::print(" {:.3f} |", edges::sobel_score(stack, view, buffer, seen).f());
            }
        }
        fmt::print("\n");
        std::cout.flush();
    }
}

}  // namespace

int main(int argc, char** argv) {
    int size = 1024;
    bool sobel = false;
    int status = 0;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--size" && i + 1 < argc) {
            size = std::max(16, std::atoi(argv[++i]));
        } else if (word == "--sobel") {
            sobel = true;
        } else {
            try {
                measure(std::string(word), glm::ivec2(size), sobel);
            } catch (const std::exception& error) {
                std::cerr << word << ": " << error.what() << '\n';
                status = 1;
            }
        }
    }
    return status;
}
