#include "csg/solid/node_geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "csg/solid/extrude.h"
#include "csg/solid/files.h"
#include "csg/solid/misplaced.h"
#include "csg/solid/prism_stack.h"
#include "csg/solid/text_outline.h"

namespace csg::solid {
namespace {

using Outlines = std::vector<std::shared_ptr<const Outline>>;
using Children = std::span<const NodeGeometry* const>;

std::shared_ptr<const Outline> share(Outline outline) {
    return std::make_shared<const Outline>(std::move(outline));
}

/// Throws GeometryError where a circle would have fewer segments than it is to have.
void check_fineness(const Fineness& fineness) {
    if (const std::string problem = too_fine(fineness); !problem.empty()) {
        throw GeometryError(problem);
    }
}

constexpr const char* kMeshes = "exact meshes";

/// The children that are outlines; of others see misplaced.h.
Outlines outlines_of(Children children) {
    Outlines outlines;
    for (const NodeGeometry* child : children) {
        if (child->outline) {
            outlines.push_back(child->outline);
        }
    }
    return outlines;
}

/// The pieces of all children that are solid.
std::vector<Piece> pieces_of(Children children) {
    std::vector<Piece> pieces;
    for (const NodeGeometry* child : children) {
        pieces.insert(pieces.end(), child->pieces.begin(), child->pieces.end());
    }
    return pieces;
}

unsigned depth_of(std::span<const Piece> pieces) {
    unsigned depth = 0;
    for (const Piece& piece : pieces) {
        if (piece.boolean) {
            depth = std::max(depth, piece.boolean->depth);
        }
    }
    return depth;
}

void add(NodeGeometry& result, std::shared_ptr<const Solid> solid) {
    result.warnings.insert(result.warnings.end(), solid->warnings.begin(), solid->warnings.end());
    result.failures.insert(result.failures.end(), solid->failures.begin(), solid->failures.end());
    if (!solid->triangles.empty()) {
        result.pieces.push_back({std::move(solid), nullptr, glm::dmat4(1.0)});
    }
}

/// A node that unites its children, under a matrix.
void unite(Children children, Dimension dimension, const glm::dmat4* matrix, NodeGeometry& result) {
    if (dimension == Dimension::Flat) {
        Outline all = combine(BooleanKind::Union, outlines_of(children));
        if (matrix != nullptr && !all.empty()) {
            Outline moved = transform(all, *matrix);
            if (moved.empty() && (*matrix)[0][0] * (*matrix)[1][1] != (*matrix)[1][0] * (*matrix)[0][1]) {
                throw GeometryError("its transformation is not finite, or takes it beyond all numbers");
            }
            all = std::move(moved);
        }
        result.outline = share(std::move(all));
        return;
    }
    result.pieces = pieces_of(children);
    if (matrix == nullptr) {
        return;
    }
    const double determinant = glm::determinant(glm::dmat3(*matrix));
    if (!std::isfinite(determinant) && !result.pieces.empty()) {
        throw GeometryError("its transformation is not finite");
    }
    if (determinant == 0) {
        result.pieces.clear();
        return;
    }
    for (Piece& piece : result.pieces) {
        piece.placed = *matrix * piece.placed;
    }
}

void combine_children(Children children, BooleanKind kind, Dimension dimension, NodeGeometry& result) {
    if (dimension == Dimension::Flat) {
        // A child that makes nothing, or a solid, is an operand all the same: an empty one.
        Outlines operands;
        for (const NodeGeometry* child : children) {
            operands.push_back(child->outline ? child->outline : share({}));
        }
        result.outline = share(combine(kind, operands));
        return;
    }
    auto node = std::make_shared<BooleanNode>();
    node->kind = kind;
    for (const NodeGeometry* child : children) {
        if (kind == BooleanKind::Difference && child->pieces.empty()) {
            if (node->operands.empty()) {
                return;  // Nothing minus anything.
            }
            continue;
        }
        node->operands.push_back(child->pieces);
        node->depth = std::max(node->depth, depth_of(child->pieces) + 1);
    }
    if (node->operands.size() == 1) {
        result.pieces = node->operands[0];
    } else if (!node->operands.empty() && std::none_of(node->operands.begin(), node->operands.end(),
                                                       [](const auto& operand) { return operand.empty(); })) {
        result.pieces.push_back({nullptr, std::move(node), glm::dmat4(1.0)});
    }
}

/// Nothing where they are not prisms along an axis, or outlines so large that they cannot be summed in the plane.
std::optional<std::vector<Mesh>> sum_of_prisms(std::span<const std::vector<Piece>> operands) {
    try {
        return minkowski_of_prisms(operands);
    } catch (const OutlineError&) {
        return {};
    }
}

/// The factors of resize().
glm::dvec3 factors(const Resize& how, const glm::dvec3& size) {
    glm::dvec3 factor(1.0);
    double largest = 1;
    int of = -1;
    for (int i = 0; i < 3; ++i) {
        if (how.size[i] > 0 && size[i] > 0) {
            factor[i] = how.size[i] / size[i];
            if (of < 0 || how.size[i] > how.size[of]) {
                of = i;
                largest = factor[i];
            }
        }
    }
    for (int i = 0; i < 3; ++i) {
        if (how.automatic[static_cast<std::size_t>(i)] && how.size[i] == 0) {
            factor[i] = largest;
        }
    }
    return factor;
}

glm::dmat4 scaling(const glm::dvec3& factor) {
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 3; ++i) {
        matrix[i][i] = factor[i];
    }
    return matrix;
}

class MeshMaker {
  public:
    MeshMaker(Children children, Dimension dimension, const Tools& tools, NodeGeometry& result)
        : children_(children), dimension_(dimension), tools_(tools), result_(result) {}

    void operator()(const LinearExtrude& how) const { add(result_, linear_extrude(flat_children(), how)); }
    void operator()(const RotateExtrude& how) const {
        check_fineness(how.fineness);
        add(result_, rotate_extrude(flat_children(), how));
    }
    void operator()(const Offset& how) const {
        if (how.corner == Offset::Corner::Round) {
            check_fineness(how.fineness);
        }
        result_.outline = share(offset(flat_children(), how));
    }
    void operator()(const Fill&) const { result_.outline = share(fill(flat_children())); }
    void operator()(const Render&) const { unite(children_, dimension_, nullptr, result_); }
    void operator()(const Roof& how) const {
        add(result_, to_solid(ask(need(tools_, kMeshes).roof(flat_children(), how, tools_.stop)), true));
    }

    void operator()(const Projection& how) const {
        const std::vector<Piece> pieces = pieces_of(children_);
        result_.outline = share(how.cut ? cut(pieces) : shadow(meshes_of(pieces, tools_)));
    }

    void operator()(const Hull&) const {
        if (dimension_ == Dimension::Flat) {
            std::vector<glm::dvec2> points;
            for (const auto& outline : outlines_of(children_)) {
                for (const Loop& loop : outline->loops) {
                    points.insert(points.end(), loop.begin(), loop.end());
                }
            }
            result_.outline = share(hull(points));
            return;
        }
        std::vector<glm::dvec3> points;
        for (const Mesh& mesh : meshes_of(pieces_of(children_), tools_)) {
            points.insert(points.end(), mesh.points.begin(), mesh.points.end());
        }
        if (!points.empty()) {
            add(result_, to_solid(ask(need(tools_, kMeshes).hull(points, tools_.stop)), true));
        }
    }

    void operator()(const Minkowski&) const {
        if (dimension_ == Dimension::Flat) {
            const Outlines operands = outlines_of(children_);
            // A sum with nothing but what makes no outline is empty, as in OpenSCAD.
            const bool none = operands.empty() || (operands.size() == 1 && children_.size() > 1);
            std::shared_ptr<const Outline> sum = none ? share({}) : operands[0];
            for (std::size_t i = 1; i < operands.size(); ++i) {
                sum = share(minkowski(*sum, *operands[i]));
            }
            result_.outline = sum;
            return;
        }
        // The sum of a union is the union of sums, so that pieces need not be united first.
        std::vector<std::vector<Piece>> unions;
        for (const NodeGeometry* child : children_) {
            if (!child->pieces.empty()) {
                unions.push_back(child->pieces);
            }
        }
        if (unions.size() > 1) {
            if (auto prisms = sum_of_prisms(unions)) {
                add(result_, to_solid(united(std::move(*prisms), tools_), true));
                return;
            }
        }
        std::vector<std::vector<Mesh>> operands;
        for (const std::vector<Piece>& pieces : unions) {
            if (auto meshes = meshes_of(pieces, tools_); !meshes.empty()) {
                operands.push_back(std::move(meshes));  // An empty operand does not count, as in OpenSCAD.
            }
        }
        if (operands.size() == 1) {
            add(result_, to_solid(united(std::move(operands[0]), tools_), false));
        } else if (!operands.empty()) {
            add(result_, to_solid(ask(need(tools_, kMeshes).minkowski(operands, tools_.stop)), true));
        }
    }

    void operator()(const Resize& how) const {
        unite(children_, dimension_, nullptr, result_);
        if (result_.outline) {
            const glm::dvec3 factor = factors(how, bounds_of(result_.outline->loops).size());
            result_.outline = share(transform(*result_.outline, scaling({factor.x, factor.y, 1.0})));
            return;
        }
        const Box box = bounds_of(meshes_of(result_.pieces, tools_));
        const glm::dmat4 matrix = scaling(factors(how, box.size()));
        for (Piece& piece : result_.pieces) {
            piece.placed = matrix * piece.placed;
        }
    }

  private:
    [[nodiscard]] Outline flat_children() const { return combine(BooleanKind::Union, outlines_of(children_)); }

    Children children_;
    Dimension dimension_;
    const Tools& tools_;
    NodeGeometry& result_;
};

void read_outline(const Import& import, NodeGeometry& result) {
    Remarks remarks;
    result.outline = share(import_outline(import, remarks));
    result.warnings = std::move(remarks.warnings);
    result.failures = std::move(remarks.failures);
}

void make_leaf(const LeafShape& shape, const Tools& tools, NodeGeometry& result) {
    if (const auto* square = std::get_if<Square>(&shape)) {
        result.outline = share(make_outline(*square));
    } else if (const auto* circle = std::get_if<Circle>(&shape)) {
        check_fineness(circle->fineness);
        result.outline = share(make_outline(*circle));
    } else if (const auto* polygon = std::get_if<std::shared_ptr<const Polygon>>(&shape)) {
        result.outline = share(make_outline(**polygon));
    } else if (const auto* text = std::get_if<std::shared_ptr<const Text>>(&shape)) {
        result.outline = share(text_outline(**text, tools.fonts));
    } else if (const auto* import = std::get_if<std::shared_ptr<const Import>>(&shape)) {
        if (is_flat(shape)) {
            read_outline(**import, result);
        } else {
            add(result, import_solid(**import));
        }
    } else if (const auto* surface = std::get_if<std::shared_ptr<const Surface>>(&shape)) {
        add(result, surface_solid(**surface));
    } else {
        add(result, tools.solid_of(shape));
    }
}

void make(const Tree& tree, NodeId id, Dimension dimension, Children children, const Tools& tools,
          NodeGeometry& result) {
    switch (tree.node(id).operation) {
        case Operation::Leaf:
            return make_leaf(tree.shape(id), tools, result);
        case Operation::Mesh:
            return std::visit(MeshMaker(children, dimension, tools, result), tree.mesh(id));
        case Operation::Difference:
            return combine_children(children, BooleanKind::Difference, dimension, result);
        case Operation::Intersection:
            return combine_children(children, BooleanKind::Intersection, dimension, result);
        case Operation::Transform:
            return unite(children, dimension, &tree.matrix(id), result);
        case Operation::Group:
        case Operation::Union:
        case Operation::Color:
            return unite(children, dimension, nullptr, result);
    }
}

std::string left_out(const GeometryError& error) {
    return std::string("this object is left out: ") + error.what();
}

}  // namespace

NodeGeometry make_geometry(const Tree& tree, NodeId id, Dimension dimension, Children children, const Tools& tools) {
    NodeGeometry result;
    result.dimension = dimension;
    result.misplaced = misplaced_children(tree, id, children);
    try {
        make(tree, id, dimension, children, tools, result);
    } catch (const GeometryError& error) {
        result.failures.push_back(left_out(error));
        result.pieces.clear();
        result.outline = nullptr;
    }
    if (dimension == Dimension::Flat && !result.outline) {
        result.outline = std::make_shared<Outline>();
    }
    return result;
}

std::shared_ptr<const Solid> as_solid(const NodeGeometry& geometry, const Tools& tools) {
    if (geometry.pieces.size() == 1 && geometry.pieces[0].solid && geometry.pieces[0].placed == glm::dmat4(1.0)) {
        return geometry.pieces[0].solid;
    }
    try {
        if (geometry.outline) {
            return slab(*geometry.outline);
        }
        const bool simple = std::all_of(geometry.pieces.begin(), geometry.pieces.end(),
                                        [](const Piece& piece) { return !piece.solid || piece.solid->simple; });
        return to_solid(united(meshes_of(geometry.pieces, tools), tools), simple);
    } catch (const GeometryError& error) {
        auto nothing = std::make_shared<Solid>();
        nothing->failures.push_back(left_out(error));
        return nothing;
    }
}

}  // namespace csg::solid
