#include "tests/random/random_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

#include "csg/tree/degrees.h"

namespace random_tree {
namespace {

using csg::Operation;

class Maker {
  public:
    Maker(std::mt19937_64& random, const Options& options) : random_(random), options_(options) {}

    Model make() {
        const int leaves = 2 + pick(options_.most_leaves - 1);
        Model root = tree(leaves, options_.depth);
        if (root.operation == Operation::Leaf || chance(3)) {
            root = {Operation::Union, {}, {}, glm::dmat4(1.0), {}, {root}};
        }
        return root;
    }

  private:
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    bool chance(int one_in) { return pick(one_in) == 0; }

    Model tree(int leaves, int depth) {
        if (leaves == 1 || depth == 0) {
            return decorated(leaf());
        }
        Model node;
        switch (pick(8)) {
            case 0:
            case 1:
                node.operation = Operation::Union;
                break;
            case 2:
                node.operation = Operation::Group;
                break;
            case 3:
            case 4:
                node.operation = Operation::Intersection;
                break;
            default:
                node.operation = Operation::Difference;
                break;
        }
        int rest = leaves;
        while (rest > 0) {
            const int share = 1 + pick(rest == leaves ? std::max(1, rest - 1) : rest);
            node.children.push_back(tree(share, depth - 1));
            rest -= share;
        }
        if (depth < 4 && chance(20)) {
            node.children.clear();
        }
        return decorated(node);
    }

    Model decorated(Model node) {
        const int placed = node.operation == Operation::Leaf ? 2 : 5;
        if (chance(placed)) {
            node = {Operation::Transform, {}, {}, matrix(), {}, {node}};
        }
        if (chance(6)) {
            const csg::Rgba color{0.25F * static_cast<float>(pick(5)), 0.5F, 1.0F,
                                  options_.modifiers && chance(3) ? 0.5F : 1.0F};
            node = {Operation::Color, {}, {}, glm::dmat4(1.0), color, {node}};
        }
        if (options_.modifiers && chance(25)) {
            (chance(2) ? node.modifiers.background : node.modifiers.highlight) = true;
        }
        return node;
    }

    Model leaf() {
        // Some leaves come again: the same face in other roles.
        Model node;
        if (!shapes_.empty() && chance(4)) {
            node = shapes_[static_cast<std::size_t>(pick(static_cast<int>(shapes_.size())))];
            return node;
        }
        node.operation = Operation::Leaf;
        node.shape = shape();
        if (chance(2)) {
            node = {Operation::Transform, {}, {}, translation(grid(), grid(), grid()), {}, {node}};
        }
        shapes_.push_back(node);
        return node;
    }

    double grid() { return static_cast<double>(pick(5) - 2); }
    double size() { return chance(30) ? 0.0 : static_cast<double>(1 + pick(4)); }

    csg::LeafShape shape() {
        const csg::Fineness fineness{static_cast<double>(3 + pick(10)), 12, 2};
        switch (pick(9)) {
            case 0:
            case 1:
            case 2:
            case 3:
                return csg::Cube{{size(), size(), size()}, chance(2)};
            case 4:
                return csg::Sphere{size(), fineness};
            case 5: {
                const double r = size();
                return csg::Cylinder{size(), r, r, chance(2), fineness};
            }
            case 6:
                return csg::Cylinder{size(), chance(2) ? 0.0 : size(), chance(3) ? 0.0 : size(), chance(2), fineness};
            default:
                return options_.wound ? wound() : polyhedron();
        }
    }

    /// Several shells, whose winding numbers are any.
    csg::LeafShape wound() {
        auto mesh = std::make_shared<csg::Polyhedron>();
        for (int shells = 1 + pick(3); shells > 0; --shells) {
            const csg::LeafShape shape = chance(4) ? csg::LeafShape(crossing_prism()) : polyhedron();
            const glm::dvec3 offset(grid(), grid(), grid());
            const bool reversed = chance(3);
            for (int times = chance(4) ? 2 : 1; times > 0; --times) {
                append(*mesh, *std::get<std::shared_ptr<const csg::Polyhedron>>(shape), offset, reversed);
            }
        }
        return mesh;
    }

    static void append(csg::Polyhedron& mesh, const csg::Polyhedron& shell, const glm::dvec3& offset, bool reversed) {
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (const glm::dvec3& p : shell.points) {
            mesh.points.push_back(p + offset);
        }
        for (std::vector<std::uint32_t> face : shell.faces) {
            for (std::uint32_t& index : face) {
                index += first;
            }
            if (reversed) {
                std::reverse(face.begin(), face.end());
            }
            mesh.faces.push_back(std::move(face));
        }
    }

    /// A prism over an outline that crosses itself: a bow, of winding numbers 1 and -1, or a star, of 1 and 2.
    std::shared_ptr<const csg::Polyhedron> crossing_prism() {
        static const std::vector<std::vector<glm::dvec2>> outlines{{{0, 0}, {3, 3}, {3, 0}, {0, 3}},
                                                                   {{0, 0}, {4, 3}, {0, 3}, {4, 0}, {2, 4}}};
        auto mesh = prism(outlines[static_cast<std::size_t>(pick(2))], size());
        const auto n = static_cast<std::uint32_t>(mesh->points.size() / 2);
        mesh->faces.erase(mesh->faces.begin(), mesh->faces.begin() + 2);
        for (std::uint32_t i = 2; i < n; ++i) {  // A triangulation that minds nothing but the border.
            mesh->faces.push_back({0, i - 1, i});
            mesh->faces.push_back({n, n + i, n + i - 1});
        }
        return mesh;
    }

    /// A prism over a polygon that need not be convex, or a tetrahedron, on the grid.
    csg::LeafShape polyhedron() {
        auto mesh = std::make_shared<csg::Polyhedron>();
        if (chance(3)) {
            mesh->points = {{0, 0, 0}, {size(), 0, 0}, {0, size(), 0}, {grid(), grid(), size()}};
            mesh->faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
            return mesh;
        }
        static const std::vector<std::vector<glm::dvec2>> outlines{
            {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},                  // L
            {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},  // U
            {{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 2}, {0, 2}},  // Z
            {{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 3}, {0, 2}}};                 // arrow
        const auto& outline = outlines[static_cast<std::size_t>(pick(static_cast<int>(outlines.size())))];
        return prism(outline, size());
    }

    static std::shared_ptr<csg::Polyhedron> prism(const std::vector<glm::dvec2>& outline, double height) {
        auto mesh = std::make_shared<csg::Polyhedron>();
        const auto n = static_cast<std::uint32_t>(outline.size());
        for (const double z : {0.0, height}) {
            for (const glm::dvec2& p : outline) {
                mesh->points.emplace_back(p, z);
            }
        }
        std::vector<std::uint32_t> bottom(n), top(n);  // clockwise seen from outside
        std::iota(bottom.begin(), bottom.end(), 0U);
        std::iota(top.rbegin(), top.rend(), n);
        mesh->faces = {bottom, top};
        for (std::uint32_t i = 0; i < n; ++i) {
            mesh->faces.push_back({i, n + i, n + (i + 1) % n, (i + 1) % n});
        }
        return mesh;
    }

    static glm::dmat4 translation(double x, double y, double z) {
        glm::dmat4 m(1.0);
        m[3] = {x, y, z, 1.0};
        return m;
    }

    glm::dmat4 rotation(double degrees, int axis) {
        const double s = csg::sin_degrees(degrees), c = csg::cos_degrees(degrees);
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::dmat4 m(1.0);
        m[u][u] = m[v][v] = c;
        m[u][v] = s;
        m[v][u] = -s;
        return m;
    }

    glm::dmat4 matrix() {
        glm::dmat4 m(1.0);
        switch (pick(8)) {
            case 0:
            case 1:
                return translation(grid(), grid(), grid());
            case 2:
            case 3:
                return rotation(90.0 * (1 + pick(3)), pick(3));
            case 4:
                return rotation(static_cast<double>(pick(3600)) / 10, pick(3)) *
                       rotation(static_cast<double>(pick(360)), pick(3));
            case 5:
                m[pick(3)] *= -1.0;
                return m;  // mirror
            case 6:
                for (int i = 0; i < 3; ++i) {
                    m[i] *= 0.5 * (1 + pick(4));
                }
                return m;  // scale
            default:
                m[pick(2)][2] = 0.5;
                return m;  // shear
        }
    }

    std::mt19937_64& random_;
    Options options_;
    std::vector<Model> shapes_;
};

csg::NodeId add(csg::TreeBuilder& builder, const Model& model, std::uint32_t& line) {
    const csg::SourceLocation where{0, ++line, 1};
    std::vector<csg::NodeId> children;
    for (const Model& child : model.children) {
        children.push_back(add(builder, child, line));
    }
    switch (model.operation) {
        case Operation::Leaf:
            return builder.leaf(model.shape, where, model.modifiers);
        case Operation::Transform:
            return builder.transform(model.matrix, children, where, model.modifiers);
        case Operation::Color:
            return builder.color(model.color, children, where, model.modifiers);
        default:
            return builder.combine(model.operation, children, where, model.modifiers);
    }
}

std::string vector_text(const glm::dvec3& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

struct ShapeText {
    std::string operator()(const csg::Cube& c) const {
        return fmt::format("cube({}, center = {})", vector_text(c.size), c.center);
    }
    std::string operator()(const csg::Sphere& s) const {
        return fmt::format("sphere(r = {}, $fn = {})", s.radius, s.fineness.fn);
    }
    std::string operator()(const csg::Cylinder& c) const {
        return fmt::format("cylinder(h = {}, r1 = {}, r2 = {}, center = {}, $fn = {})", c.height, c.radius1, c.radius2,
                           c.center, c.fineness.fn);
    }
    std::string operator()(const std::shared_ptr<const csg::Polyhedron>& p) const {
        std::string points, faces;
        for (const glm::dvec3& v : p->points) {
            points += (points.empty() ? "" : ", ") + vector_text(v);
        }
        for (const auto& face : p->faces) {
            faces += fmt::format("{}[{}]", faces.empty() ? "" : ", ", fmt::join(face, ", "));
        }
        return fmt::format("polyhedron(points = [{}], faces = [{}])", points, faces);
    }
    /// Shapes that no random model has.
    template <typename Shape>
    std::string operator()(const Shape&) const {
        return "group()";
    }
};

void print(const Model& model, int indent, std::string& text) {
    text += std::string(static_cast<std::size_t>(2 * indent), ' ');
    text += model.modifiers.background ? "%" : "";
    text += model.modifiers.highlight ? "#" : "";
    switch (model.operation) {
        case Operation::Leaf:
            text += std::visit(ShapeText{}, model.shape) + ";\n";
            return;
        case Operation::Union:
        case Operation::Group:
        case Operation::Mesh:
            text += "union()";
            break;
        case Operation::Difference:
            text += "difference()";
            break;
        case Operation::Intersection:
            text += "intersection()";
            break;
        case Operation::Transform: {
            text += "multmatrix([";
            for (int r = 0; r < 4; ++r) {
                text += fmt::format("{}[{}, {}, {}, {}]", r > 0 ? ", " : "", model.matrix[0][r], model.matrix[1][r],
                                    model.matrix[2][r], model.matrix[3][r]);
            }
            text += "])";
            break;
        }
        case Operation::Color:
            text += fmt::format("color([{}, {}, {}, {}])", model.color.r, model.color.g, model.color.b, model.color.a);
            break;
    }
    text += " {\n";
    for (const Model& child : model.children) {
        print(child, indent + 1, text);
    }
    text += std::string(static_cast<std::size_t>(2 * indent), ' ') + "}\n";
}

}  // namespace

Model make_model(std::mt19937_64& random, const Options& options) {
    return Maker(random, options).make();
}

base::Camera make_camera(std::mt19937_64& random, const glm::dvec3& lo, const glm::dvec3& hi) {
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    base::Camera camera;
    if (pick(3) == 0) {
        camera.projection = base::Projection::Orthographic;
    }
    if (pick(4) == 0) {
        camera.rotation = {90.0 * pick(4), 0, 90.0 * pick(4)};
    } else {
        camera.rotation = {pick(3600) / 10.0, pick(4) == 0 ? pick(360) : 0, pick(3600) / 10.0};
    }
    base::view_all(camera, lo, hi, true);
    if (!(lo.x <= hi.x)) {
        return camera;
    }
    const double size = glm::length(hi - lo);
    switch (pick(5)) {
        case 0:  // the eye among the leaves
            camera.distance = size * 0.02 * (1 + pick(20));
            camera.fov = 60;
            break;
        case 1:
            camera.distance *= 0.5;
            break;
        case 2:
            camera.target += size * 0.05 * glm::dvec3(pick(5) - 2, pick(5) - 2, pick(5) - 2);
            break;
        default:
            break;
    }
    return camera;
}

csg::Tree make_tree(const Model& model) {
    csg::TreeBuilder builder;
    static_cast<void>(builder.file("random.scad"));
    std::uint32_t line = 0;
    const csg::NodeId root = add(builder, model, line);
    return builder.finish(root);
}

std::vector<Model> simpler(const Model& model) {
    // First large steps: a child instead of the node; then a child less; then something simpler within.
    std::vector<Model> result = model.children;
    for (std::size_t i = 0; i < model.children.size(); ++i) {
        Model less = model;
        less.children.erase(less.children.begin() + static_cast<std::ptrdiff_t>(i));
        result.push_back(std::move(less));
    }
    if (!(model.modifiers == csg::Modifiers{})) {
        result.push_back(model);
        result.back().modifiers = {};
    }
    if (model.operation == Operation::Leaf && !std::holds_alternative<csg::Cube>(model.shape)) {
        result.push_back(model);
        result.back().shape = csg::Cube{{2, 2, 2}, false};
    }
    for (std::size_t i = 0; i < model.children.size(); ++i) {
        for (Model& child : simpler(model.children[i])) {
            Model inner = model;
            inner.children[i] = std::move(child);
            result.push_back(std::move(inner));
        }
    }
    return result;
}

std::string scad_text(const Model& model) {
    std::string text;
    print(model, 0, text);
    return text;
}

std::string camera_text(const base::Camera& camera) {
    return fmt::format("// $vpt = {}; $vpr = {}; $vpd = {}; $vpf = {}; {}\n", vector_text(camera.target),
                       vector_text(camera.rotation), camera.distance, camera.fov,
                       camera.projection == base::Projection::Orthographic ? "orthographic" : "perspective");
}

}  // namespace random_tree
