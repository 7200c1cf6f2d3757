#include "tests/fuzz/random_solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "csg/tree/degrees.h"

namespace fuzz {
namespace {

using csg::NodeId;

constexpr std::size_t kMostLeaves = 6;
constexpr int kSide = 8;

/// A mesh by hand. Triangles here are counter-clockwise seen from outside.
class Mesh {
  public:
    std::uint32_t add(const glm::dvec3& p) {
        polyhedron_.points.push_back(p);
        return static_cast<std::uint32_t>(polyhedron_.points.size() - 1);
    }
    void face(std::vector<std::uint32_t> corners, bool reversed) {
        if (!reversed) {
            std::reverse(corners.begin(), corners.end());
        }
        polyhedron_.faces.push_back(std::move(corners));
    }
    void box(const glm::dvec3& lo, const glm::dvec3& hi, bool reversed) {
        std::uint32_t first = 0;
        for (int i = 0; i < 8; ++i) {
            const std::uint32_t p = add({i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
            first = i == 0 ? p : first;
        }
        constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces = {
            {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
        for (const auto& f : kFaces) {
            face({first + f[0], first + f[1], first + f[2], first + f[3]}, reversed);
        }
    }
    void tetrahedron(const std::array<glm::dvec3, 4>& corners, bool reversed) {
        std::array<std::uint32_t, 4> p{};
        std::transform(corners.begin(), corners.end(), p.begin(),
                       [&](const glm::dvec3& corner) { return add(corner); });
        face({p[0], p[2], p[1]}, reversed);
        face({p[0], p[1], p[3]}, reversed);
        face({p[1], p[2], p[3]}, reversed);
        face({p[2], p[0], p[3]}, reversed);
    }
    csg::LeafShape shape() { return std::make_shared<const csg::Polyhedron>(std::move(polyhedron_)); }

  private:
    csg::Polyhedron polyhedron_;
};

class Maker {
  public:
    explicit Maker(Bytes& bytes) : bytes_(bytes), mode_(bytes.below(4)) {
        noise_ = mode_ == 2 ? std::ldexp(1.0, -12 - bytes.below(44)) : 0;
    }

    SolidTree make() {
        const csg::Operation last = operation(bytes_.below(6));
        std::size_t leaves = 0;
        while (!bytes_.done() && leaves < kMostLeaves) {
            const int what = bytes_.below(16);
            if (what < 9 || stack_.empty()) {
                stack_.push_back(placed(leaf(what)));
                nodes_.push_back(stack_.back());
                ++leaves;
            } else if (what < 13) {
                combine(operation(what - 9));
            } else if (what == 13) {
                stack_.push_back(moved(nodes_[bytes_.next() % nodes_.size()]));
                ++leaves;
            } else {
                stack_.back() = turned(stack_.back());
            }
        }
        const NodeId root = builder_.combine(last, stack_, {});
        return {builder_.finish(root), of_unit_cubes_ && mode_ < 2};
    }

  private:
    static csg::Operation operation(int i) {
        return i % 3 == 0   ? csg::Operation::Union
               : i % 3 == 1 ? csg::Operation::Difference
                            : csg::Operation::Intersection;
    }
    int grid() { return bytes_.below(kSide + 1); }
    glm::dvec3 point() {
        const int x = grid(), y = grid();
        return {x, y, grid()};
    }

    void combine(csg::Operation operation) {
        if (stack_.size() < 2) {
            return;
        }
        const std::array<NodeId, 2> both{stack_[stack_.size() - 2], stack_.back()};
        stack_.pop_back();
        stack_.back() = builder_.combine(operation, both, {});
        nodes_.push_back(stack_.back());
    }
    NodeId transform(const glm::dmat4& m, NodeId node) { return builder_.transform(m, std::array{node}, {}); }
    /// A little off the grid, or turned, where the tree is of that kind.
    NodeId placed(NodeId node) {
        if (mode_ < 2) {
            return node;
        }
        const double a = bytes_.next() - 128.0, b = bytes_.next() - 128.0;
        glm::dmat4 m(1.0);
        if (mode_ == 2) {
            m[3] = {noise_ * a, noise_ * b, noise_ * (a - b), 1};
            m[0][1] = (bytes_.next() % 4) * noise_;
            m[1][2] = -(bytes_.next() % 4) * noise_;
        } else {
            const double angle = 90 * bytes_.below(4) + a * 0.7;
            m[0][0] = m[1][1] = csg::cos_degrees(angle);
            m[0][1] = csg::sin_degrees(angle);
            m[1][0] = -m[0][1];
            m[3] = {4, 4, b / 64, 1};
            glm::dmat4 back(1.0);
            back[3] = {-4, -4, 0, 1};
            m = m * back;
        }
        return transform(m, node);
    }
    NodeId moved(NodeId node) {
        glm::dmat4 m(1.0);
        const double x = bytes_.below(5) - 2, y = bytes_.below(5) - 2;
        m[3] = {x, y, bytes_.below(5) - 2, 1};
        return transform(m, node);
    }
    /// Axes exchanged and mirrored.
    NodeId turned(NodeId node) {
        const int how = bytes_.below(48);
        constexpr std::array<std::array<int, 3>, 6> kOrders = {
            {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
        glm::dmat4 m(0.0);
        m[3][3] = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const int to = kOrders[static_cast<std::size_t>(how % 6)][static_cast<std::size_t>(axis)];
            const bool mirrored = (how / 6 >> axis & 1) != 0;
            m[axis][to] = mirrored ? -1 : 1;
            m[3][to] = mirrored ? kSide : 0;
        }
        return transform(m, node);
    }

    NodeId leaf(int what) {
        switch (what) {
            case 0:
            case 1:
                return shells(1);
            case 2:
                of_unit_cubes_ = false;
                return tetrahedra(1 + bytes_.below(2));
            case 3:
                return prism();
            case 4:
                return revolution();
            case 5:
                return shells(2 + bytes_.below(2));
            case 6:
                return tube();
            case 7:
                return double_cone();
            default: {
                const int width = 1 + bytes_.below(kSide), depth = 1 + bytes_.below(kSide);
                return builder_.leaf(csg::Cube{glm::dvec3(width, depth, 2)}, {});
            }
        }
    }
    NodeId shells(int count) {
        Mesh mesh;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 a = point(), b = point();
            mesh.box(glm::min(a, b), glm::max(a, b), bytes_.below(4) == 0);
        }
        return builder_.leaf(mesh.shape(), {});
    }
    NodeId tetrahedra(int count) {
        Mesh mesh;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 a = point(), b = point(), c = point();
            mesh.tetrahedron({a, b, c, point()}, bytes_.below(4) == 0);
        }
        return builder_.leaf(mesh.shape(), {});
    }
    /// A corner is a byte; one of three may begin a new path.
    NodeId outline(int most_x) {
        csg::Polygon polygon;
        polygon.has_paths = true;
        polygon.paths.emplace_back();
        for (int i = 3 + bytes_.below(6); i > 0; --i) {
            const std::uint8_t b = bytes_.next();
            if (b >= 240 && polygon.paths.back().size() > 2) {
                polygon.paths.emplace_back();
            }
            polygon.paths.back().push_back(static_cast<std::uint32_t>(polygon.points.size()));
            polygon.points.emplace_back(b % (most_x + 1), b / (most_x + 1) % (kSide + 1));
        }
        return builder_.leaf(std::make_shared<const csg::Polygon>(std::move(polygon)), {});
    }
    NodeId prism() {
        csg::LinearExtrude how;
        how.height = 1 + bytes_.below(kSide);
        const int kind = bytes_.below(6);
        if (kind == 1) {
            how.scale = {bytes_.below(3), bytes_.below(3)};
        }
        if (kind == 2) {
            how.twist = 45.0 * (bytes_.below(16) - 8);
            how.slices = 1 + static_cast<unsigned>(bytes_.below(3));
        }
        of_unit_cubes_ = false;
        return builder_.mesh(how, std::array{outline(kSide)}, {});
    }
    NodeId revolution() {
        csg::RotateExtrude how;
        how.fineness.fn = 3 + bytes_.below(5);
        how.angle = bytes_.below(3) == 0 ? 60.0 + 60 * bytes_.below(5) : 360;
        how.start = 0;
        of_unit_cubes_ = false;
        glm::dmat4 m(1.0);
        m[3] = {4, 4, 0, 1};
        return transform(m, builder_.mesh(how, std::array{outline(4)}, {}));
    }
    /// A closed way of a square held in one of three positions; what it holds may wind any number of times.
    NodeId tube() {
        constexpr std::array<std::array<glm::dvec3, 4>, 3> kSquares = {
            {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
             {{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}},
             {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}}}};
        of_unit_cubes_ = false;
        Mesh mesh;
        const int rings = 3 + bytes_.below(4);
        const auto n = static_cast<std::uint32_t>(4 * rings);
        for (int i = 0; i < rings; ++i) {
            const glm::dvec3 at = glm::min(point(), glm::dvec3(kSide - 1));
            for (const glm::dvec3& corner : kSquares[static_cast<std::size_t>(bytes_.below(3))]) {
                mesh.add(at + corner);
            }
        }
        for (std::uint32_t i = 0; i < n; i += 4) {
            for (std::uint32_t k = 0; k < 4; ++k) {
                const std::uint32_t a = i + k, b = i + (k + 1) % 4, c = (a + 4) % n, d = (b + 4) % n;
                mesh.face({a, b, d}, false);
                mesh.face({a, d, c}, false);
            }
        }
        return builder_.leaf(mesh.shape(), {});
    }
    /// Two points joined with a closed way.
    NodeId double_cone() {
        of_unit_cubes_ = false;
        Mesh mesh;
        const std::uint32_t top = mesh.add(point()), bottom = mesh.add(point());
        const auto n = static_cast<std::uint32_t>(3 + bytes_.below(5));
        for (std::uint32_t i = 0; i < n; ++i) {
            mesh.add(point());
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = 2 + i, b = 2 + (i + 1) % n;
            mesh.face({a, b, top}, false);
            mesh.face({b, a, bottom}, false);
        }
        return builder_.leaf(mesh.shape(), {});
    }

    Bytes& bytes_;
    int mode_;
    double noise_ = 0;
    bool of_unit_cubes_ = true;
    csg::TreeBuilder builder_;
    std::vector<NodeId> stack_, nodes_;
};

}  // namespace

SolidTree solid_tree(Bytes& bytes) {
    return Maker(bytes).make();
}

}  // namespace fuzz
