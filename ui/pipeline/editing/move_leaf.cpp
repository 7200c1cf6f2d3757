#include "ui/pipeline/editing/move_leaf.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/scad/program/loaded_program.h"
#include "csg/scad/syntax/call_text.h"

namespace ui {

namespace {

/// World units: how near to where it was put the leaf must lie.
constexpr double kNear = 1e-6;
/// Numbers of one place that are tried together.
constexpr std::size_t kMostNumbers = 12;

using csg::scad::LiteralText;

/// x of least norm with J x = r for the columns J, by J^T (J J^T)^-1; nothing where r is not to be reached.
std::optional<std::vector<double>> solve(const std::vector<glm::dvec3>& columns, const glm::dvec3& r) {
    glm::dmat3 square(0.0);
    for (const glm::dvec3& c : columns) {
        square += glm::outerProduct(c, c);
    }
    // Directions that nothing moves along are given a little, so that there is an inverse; whether r has a part along
    // them is told by what is left.
    const double size = std::max({square[0][0], square[1][1], square[2][2]});
    if (!(size > 0) || !std::isfinite(size)) {
        return {};
    }
    const glm::dvec3 y = glm::inverse(square + 1e-9 * size * glm::dmat3(1.0)) * r;
    std::vector<double> x;
    glm::dvec3 reached(0.0);
    for (const glm::dvec3& c : columns) {
        x.push_back(glm::dot(c, y));
        reached += c * x.back();
    }
    return glm::distance(reached, r) <= 1e-3 * glm::length(r) ? std::optional(x) : std::nullopt;
}

class MoveFinder {
  public:
    MoveFinder(const csg::Tree& tree, const csg::Scene& scene, const csg::scad::LoadedProgram& program,
               const std::string& text, csg::LeafId leaf, const glm::dvec3& by, const TreeOfText& tree_of,
               const std::stop_token& stop)
        : tree_(tree),
          scene_(scene),
          program_(program),
          text_(text),
          leaf_(leaf),
          tree_of_(tree_of),
          stop_(stop),
          target_(scene.leaves[leaf].to_world) {
        target_[3] += glm::dvec4(by, 0);
    }

    std::vector<MoveWay> find() {
        std::vector<csg::OccurrenceId> path = path_to(scene_, scene_.leaves[leaf_].occurrence);
        csg::SourceLocation last;
        for (std::size_t i = path.size(); i-- > 0;) {
            const csg::NodeId node = scene_.occurrences[path[i]].node;
            const csg::SourceLocation where = tree_.node(node).where;
            if (where.known() && where != last && of_main_file(where)) {
                try_numbers(node);
                try_wrap(where, std::span(path).first(i));
            }
            last = where;
        }
        std::stable_sort(ways_.begin(), ways_.end(), [](const MoveWay& a, const MoveWay& b) {
            return std::tuple(a.changed, a.moved, a.kind) < std::tuple(b.changed, b.moved, b.kind);
        });
        return std::move(ways_);
    }

  private:
    [[nodiscard]] bool of_main_file(const csg::SourceLocation& where) const {
        return program_.look([&](const csg::scad::Program& p) {
            const std::string& name = p.sources[p.units[0].file].name();
            return where.file < tree_.files().size() && tree_.files()[where.file] == name;
        });
    }
    /// The same place as the program's sources have it.
    [[nodiscard]] csg::SourceLocation in_program(csg::SourceLocation where) const {
        where.file = program_.look([](const csg::scad::Program& p) { return p.units[0].file; });
        return where;
    }

    void try_numbers(csg::NodeId node) {
        const csg::SourceLocation where = tree_.node(node).where;
        const csg::SourceLocation place = in_program(where);
        const auto sources =
            program_.look([&](const csg::scad::Program& p) { return csg::scad::numbers_behind(p, place); });
        for (const auto& source : sources) {
            const bool tried = std::any_of(tried_.begin(), tried_.end(), [&](std::size_t begin) {
                return begin == source.numbers.front().bytes.begin;
            });
            if (source.numbers.size() > kMostNumbers || tried) {
                continue;
            }
            tried_.push_back(source.numbers.front().bytes.begin);
            if (auto way = solved(source.numbers)) {
                way->kind = source.variable.empty() ? MoveWay::Kind::Call : MoveWay::Kind::Variable;
                const csg::Statement* call = tree_.statement(node);
                way->name = !source.variable.empty() ? source.variable : call != nullptr ? call->name : "";
                way->where = where;
                ways_.push_back(std::move(*way));
            }
        }
    }

    /// Newton's method on the numbers, since how they lead to the place is not known: the program tells.
    std::optional<MoveWay> solved(const std::vector<LiteralText>& numbers) {
        std::vector<double> x;
        x.reserve(numbers.size());
        for (const LiteralText& n : numbers) {
            x.push_back(std::strtod(text_.substr(n.bytes.begin, n.bytes.end - n.bytes.begin).c_str(), nullptr));
        }
        const std::vector<double> first = x;
        std::optional<glm::dvec3> at = glm::dvec3(scene_.leaves[leaf_].to_world[3]);
        const glm::dvec3 wanted(target_[3]);
        for (int round = 0; round < 8 && glm::distance(*at, wanted) > 0.05 * kNear; ++round) {
            std::vector<glm::dvec3> columns;
            for (std::size_t i = 0; i < x.size(); ++i) {
                std::vector<double> moved = x;
                const double h = 1e-5 * std::max(1.0, std::abs(x[i]));
                moved[i] += h;
                const auto there = place(edits_to(numbers, moved, first, 0));
                columns.push_back(there ? (*there - *at) / h : glm::dvec3(0.0));
            }
            const auto step = solve(columns, wanted - *at);
            if (!step) {
                return {};
            }
            for (std::size_t i = 0; i < x.size(); ++i) {
                x[i] += (*step)[i];
            }
            at = place(edits_to(numbers, x, first, 0));
            if (!at) {
                return {};
            }
        }
        // With as few digits as do.
        for (const double tolerance : {0.2 * kNear, 0.01 * kNear, 0.0}) {
            MoveWay way;
            way.edits = edits_to(numbers, x, first, tolerance);
            if (holds(way)) {
                return way;
            }
        }
        return {};
    }

    static std::vector<TextEdit> edits_to(const std::vector<LiteralText>& numbers, const std::vector<double>& x,
                                          const std::vector<double>& first, double tolerance) {
        std::vector<TextEdit> edits;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (std::abs(x[i] - first[i]) > tolerance) {
                edits.push_back(
                    {numbers[i].bytes, tolerance > 0 ? short_number(x[i], tolerance) : fmt::format("{}", x[i])});
            }
        }
        return edits;
    }

    /// Where the leaf lies after the edits.
    std::optional<glm::dvec3> place(const std::vector<TextEdit>& edits) {
        if (edits.empty()) {
            return glm::dvec3(scene_.leaves[leaf_].to_world[3]);
        }
        const auto after = scene_after(edits);
        return after ? std::optional(glm::dvec3(after->second.leaves[leaf_].to_world[3])) : std::nullopt;
    }

    /// Nothing where there are not as many leaves as before.
    std::optional<std::pair<std::shared_ptr<const csg::Tree>, csg::Scene>> scene_after(
        const std::vector<TextEdit>& edits) {
        base::end_if_asked(stop_);
        auto tree = tree_of_(edited(text_, edits));
        if (tree == nullptr) {
            return {};
        }
        csg::Scene scene = csg::make_scene(*tree);
        if (scene.leaves.size() != scene_.leaves.size()) {
            return {};
        }
        return std::pair(std::move(tree), std::move(scene));
    }

    bool holds(MoveWay& way) {
        const auto after = scene_after(way.edits);
        if (!after) {
            return false;
        }
        const auto& [tree, scene] = *after;
        way.moved = way.changed = 0;
        for (csg::LeafId i = 0; i < scene.leaves.size(); ++i) {
            way.changed += tree->node(scene.leaves[i].node).hash != tree_.node(scene_.leaves[i].node).hash ? 1 : 0;
            way.moved += apart(scene.leaves[i].to_world, scene_.leaves[i].to_world) > kNear ? 1 : 0;
        }
        return tree->node(scene.leaves[leaf_].node).hash == tree_.node(scene_.leaves[leaf_].node).hash &&
               apart(scene.leaves[leaf_].to_world, target_) <= kNear;
    }

    static double apart(const glm::dmat4& a, const glm::dmat4& b) {
        double most = 0;
        for (int k = 0; k < 4; ++k) {
            const glm::dvec4 d = glm::abs(a[k] - b[k]);
            most = std::max({most, d.x, d.y, d.z});
        }
        return most;
    }

    void try_wrap(const csg::SourceLocation& where, std::span<const csg::OccurrenceId> above) {
        const csg::SourceLocation place = in_program(where);
        const auto call = program_.look([&](const csg::scad::Program& p) { return csg::scad::call_at(p, place); });
        glm::dmat3 linear(1.0);
        for (const csg::OccurrenceId o : above) {
            const csg::NodeId node = scene_.occurrences[o].node;
            if (tree_.node(node).operation == csg::Operation::Transform) {
                linear = linear * glm::dmat3(tree_.matrix(node));
            }
        }
        if (!call || std::abs(glm::determinant(linear)) < 1e-12) {
            return;
        }
        const glm::dvec3 by =
            glm::inverse(linear) * (glm::dvec3(target_[3]) - glm::dvec3(scene_.leaves[leaf_].to_world[3]));
        MoveWay way{MoveWay::Kind::Wrap, call->name, where, {}, 0, 0};
        const double tolerance = 0.1 * kNear;
        way.edits.push_back({{call->bytes.begin, call->bytes.begin},
                             fmt::format("translate([{}, {}, {}]) ", short_number(by.x, tolerance),
                                         short_number(by.y, tolerance), short_number(by.z, tolerance))});
        if (holds(way)) {
            ways_.push_back(std::move(way));
        }
    }

    const csg::Tree& tree_;
    const csg::Scene& scene_;
    const csg::scad::LoadedProgram& program_;
    const std::string& text_;
    csg::LeafId leaf_;
    const TreeOfText& tree_of_;
    const std::stop_token& stop_;
    glm::dmat4 target_;
    std::vector<std::size_t> tried_;  ///< Where numbers begin that have been tried.
    std::vector<MoveWay> ways_;
};

}  // namespace

std::vector<MoveWay> ways_to_move(const csg::Tree& tree, const csg::Scene& scene,
                                  const csg::scad::LoadedProgram& program, const std::string& text, csg::LeafId leaf,
                                  const glm::dvec3& by, const TreeOfText& tree_of, const std::stop_token& stop) {
    return MoveFinder(tree, scene, program, text, leaf, by, tree_of, stop).find();
}

}  // namespace ui
