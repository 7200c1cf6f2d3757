#include "ui/pipeline/comparison/errors.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double kOneDegree = 0.99984769515639127;  // its cosine
constexpr double kCrease = 0.94;                    // of the first layer's edges: cosine of 20 degrees
constexpr double kWrongDepth = 1e-4;                // over the diagonal: a pixel that is off by more is shown as wrong
constexpr double kEdgeStep = 0.05;                  // over the diagonal: a larger step of the first layer is an edge

/// A surface as both sides tell it. The normal is to point out of the solid.
struct Sample {
    double distance;
    glm::dvec3 normal;
    bool leaving;
};
using Field = std::vector<std::vector<Sample>>;

bool alike(const Sample& a, const Sample& b) {
    return glm::dot(a.normal, b.normal) >= kOneDegree;
}

/// Does a ray enter and leave in turn?
bool in_turn(const std::vector<Sample>& surfaces) {
    return std::adjacent_find(surfaces.begin(), surfaces.end(), [](const Sample& a, const Sample& b) {
               return a.leaving == b.leaving;
           }) == surfaces.end();
}

double rms(double squares, std::size_t count) {
    return count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count));
}

class Comparer {
  public:
    Comparer(glm::ivec2 size, double diagonal) : size_(size), diagonal_(diagonal) {}

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
    }

    template <typename Visit>
    void around(int x, int y, Visit&& visit) const {
        for (int v = std::max(0, y - 1); v <= std::min(size_.y - 1, y + 1); ++v) {
            for (int u = std::max(0, x - 1); u <= std::min(size_.x - 1, x + 1); ++u) {
                visit(index(u, v));
            }
        }
    }

    /// Pixels with a silhouette or crease between them and a neighbor, in any layer.
    [[nodiscard]] std::vector<char> band(const Field& truth) const {
        std::vector<char> found(truth.size(), 0);
        for (int y = 0; y < size_.y; ++y) {
            for (int x = 0; x < size_.x; ++x) {
                const auto& here = truth[index(x, y)];
                around(x, y, [&](std::size_t other) {
                    const auto& there = truth[other];
                    if (!std::equal(here.begin(), here.end(), there.begin(), there.end(), alike)) {
                        found[index(x, y)] = 1;
                    }
                });
            }
        }
        return found;
    }

    /// Edge pixels of the first layer.
    [[nodiscard]] std::vector<char> edges(const Field& field) const {
        std::vector<char> found(field.size(), 0);
        for (int y = 0; y < size_.y; ++y) {
            for (int x = 0; x < size_.x; ++x) {
                const auto& here = field[index(x, y)];
                for (const auto& [u, v] : {std::pair(x + 1, y), std::pair(x, y + 1)}) {
                    if (u >= size_.x || v >= size_.y) {
                        continue;
                    }
                    const auto& there = field[index(u, v)];
                    if (here.empty() != there.empty() ||
                        (!here.empty() && (std::abs(glm::dot(here[0].normal, there[0].normal)) < kCrease ||
                                           std::abs(here[0].distance - there[0].distance) > kEdgeStep * diagonal_))) {
                        found[index(x, y)] = 1;
                    }
                }
            }
        }
        return found;
    }

    [[nodiscard]] Comparison compare(const Field& drawn, const Field& truth) const {
        Comparison result;
        result.wrong.assign(truth.size(), 0);
        result.wrong_layers.assign(truth.size(), 0);
        const std::vector<char> near = band(truth);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            if (drawn[i].empty() && truth[i].empty()) {
                continue;
            }
            Errors e;
            pixel(drawn[i], truth[i], e);
            const bool wrong = e.coverage_wrong + e.layers_wrong + e.order_wrong + e.normals_wrong > 0 ||
                               e.depth_largest > kWrongDepth;
            result.wrong_layers[i] =
                static_cast<std::uint16_t>(std::count_if(e.layer.begin(), e.layer.end(), [](const LayerErrors& l) {
                    return l.coverage_wrong + l.normals_wrong > 0 || l.depth_largest > kWrongDepth;
                }));
            result.wrong[i] = !wrong ? 0 : near[i] != 0 ? 1 : 2;
            result.all.add(e);
            if (near[i] == 0) {
                result.outside.add(e);
            }
        }
        const std::vector<char> a = edges(drawn), b = edges(truth);
        for (int y = 0; y < size_.y; ++y) {
            for (int x = 0; x < size_.x; ++x) {
                bool near_a = false, near_b = false;
                around(x, y, [&](std::size_t i) {
                    near_a = near_a || a[i] != 0;
                    near_b = near_b || b[i] != 0;
                });
                const std::size_t i = index(x, y);
                result.all.edges_drawn += a[i] != 0 ? 1 : 0;
                result.all.edges_true += b[i] != 0 ? 1 : 0;
                result.all.edges_matched += a[i] != 0 && near_b ? 1 : 0;
                result.all.edges_found += b[i] != 0 && near_a ? 1 : 0;
            }
        }
        return result;
    }

  private:
    void pixel(const std::vector<Sample>& drawn, const std::vector<Sample>& truth, Errors& e) const {
        e.pixels = 1;
        e.coverage_wrong = drawn.empty() != truth.empty() ? 1 : 0;
        e.layers_wrong = drawn.size() != truth.size() ? 1 : 0;
        e.order_wrong = in_turn(drawn) && in_turn(truth) ? 0 : 1;
        layer_by_layer(drawn, truth, e);
        if (e.layers_wrong != 0) {
            return;
        }
        for (std::size_t k = 0; k < truth.size(); ++k) {
            const double off = std::abs(drawn[k].distance - truth[k].distance) / diagonal_;
            e.depth_squares += off * off;
            e.depth_largest = std::max(e.depth_largest, off);
            e.normals_wrong += alike(drawn[k], truth[k]) ? 0 : 1;
            e.turned += drawn[k].leaving == truth[k].leaving ? 0 : 1;
            ++e.surfaces;
        }
    }

    /// The k-th surface with the k-th, whatever their numbers.
    void layer_by_layer(const std::vector<Sample>& drawn, const std::vector<Sample>& truth, Errors& e) const {
        e.layer.resize(std::max(drawn.size(), truth.size()));
        for (std::size_t k = 0; k < e.layer.size(); ++k) {
            LayerErrors& layer = e.layer[k];
            layer.pixels = 1;
            if (k >= drawn.size() || k >= truth.size()) {
                layer.coverage_wrong = 1;
                continue;
            }
            const double off = std::abs(drawn[k].distance - truth[k].distance) / diagonal_;
            layer.surfaces = 1;
            layer.normals_wrong = alike(drawn[k], truth[k]) ? 0 : 1;
            layer.turned = drawn[k].leaving == truth[k].leaving ? 0 : 1;
            layer.depth_squares = off * off;
            layer.depth_largest = off;
        }
    }

    glm::ivec2 size_;
    double diagonal_;
};

}  // namespace

glm::dvec3 normal_of(const csg::reference::Mesh& mesh, std::uint32_t triangle) {
    const glm::uvec3& t = mesh.triangles[triangle];
    return glm::normalize(glm::cross(mesh.points[t.y] - mesh.points[t.x], mesh.points[t.z] - mesh.points[t.x]));
}

double Errors::depth_rms() const {
    return rms(depth_squares, surfaces);
}

void LayerErrors::add(const LayerErrors& other) {
    pixels += other.pixels;
    coverage_wrong += other.coverage_wrong;
    surfaces += other.surfaces;
    normals_wrong += other.normals_wrong;
    turned += other.turned;
    depth_squares += other.depth_squares;
    depth_largest = std::max(depth_largest, other.depth_largest);
}

double Errors::edge_f_score() const {
    if (edges_drawn == 0 && edges_true == 0) {
        return 1;
    }
    const double precision = share(edges_matched, edges_drawn), recall = share(edges_found, edges_true);
    return precision + recall == 0 ? 0 : 2 * precision * recall / (precision + recall);
}

void Errors::add(const Errors& other) {
    LayerErrors::add(other);
    layers_wrong += other.layers_wrong;
    order_wrong += other.order_wrong;
    layer.resize(std::max(layer.size(), other.layer.size()));
    for (std::size_t k = 0; k < other.layer.size(); ++k) {
        layer[k].add(other.layer[k]);
    }
    edges_matched += other.edges_matched;
    edges_drawn += other.edges_drawn;
    edges_true += other.edges_true;
    edges_found += other.edges_found;
}

Comparison compare_layers(const layers::HostStack& stack, const csg::solid::Geometry& geometry,
                          const csg::reference::Mesh& mesh, const MeshLayers& truth, const base::View& view,
                          double diagonal) {
    Field drawn(truth.of.size()), expected(truth.of.size());
    const Comparer comparer(truth.size, diagonal);
    for (int y = 0; y < truth.size.y; ++y) {
        for (int x = 0; x < truth.size.x; ++x) {
            const std::size_t i = comparer.index(x, y);
            const glm::dvec3 ray = view.ray(x, y).direction;
            for (int layer = 0; layer < stack.layers && stack.at(layer, x, y).depth > 0; ++layer) {
                const layers::Surface& s = stack.at(layer, x, y);
                const glm::dvec3& normal = geometry.planes.planes()[s.plane].normal;
                drawn[i].push_back(
                    {view.distance(s.depth), (glm::dot(normal, ray) > 0) == s.leaving ? normal : -normal, s.leaving});
            }
            for (const MeshSurface& s : truth.of[i]) {
                const glm::dvec3 normal = normal_of(mesh, s.triangle);
                expected[i].push_back({s.distance, normal, glm::dot(normal, ray) > 0});
            }
        }
    }
    return comparer.compare(drawn, expected);
}

Json to_json(const Errors& e) {
    const auto share = [](std::size_t part, std::size_t whole) {
        return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
    };
    Json layers = Json::array();
    for (const LayerErrors& l : e.layer) {
        layers.push_back({{"pixels", l.pixels},
                          {"coverage_error", share(l.coverage_wrong, l.pixels)},
                          {"normal_error", share(l.normals_wrong, l.surfaces)},
                          {"orientation_error", share(l.turned, l.surfaces)},
                          {"depth_rms", rms(l.depth_squares, l.surfaces)},
                          {"depth_max", l.depth_largest}});
    }
    return {{"pixels", e.pixels},
            {"surfaces", e.surfaces},
            {"coverage_error", e.coverage()},
            {"layer_error", e.layers()},
            {"order_error", e.order()},
            {"normal_error", e.normals()},
            {"orientation_error", share(e.turned, e.surfaces)},
            {"depth_rms", e.depth_rms()},
            {"depth_max", e.depth_largest},
            {"edge_f_score", e.edge_f_score()},
            {"layers", layers}};
}

}  // namespace ui
