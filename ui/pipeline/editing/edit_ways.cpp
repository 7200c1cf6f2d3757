#include "ui/pipeline/editing/edit_ways.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/scad/program/loaded_program.h"
#include "csg/scad/syntax/call_text.h"
#include "ui/pipeline/editing/sparse_step.h"

namespace ui {

namespace {

/// Numbers of one place that are tried together.
constexpr std::size_t kMostNumbers = 12, kMostTogether = 24;

using csg::scad::LiteralText;

bool of_main_file(const csg::Tree& tree, const csg::scad::LoadedProgram& program, const csg::SourceLocation& where) {
    return where.known() && where.file < tree.files().size() && program.look([&](const csg::scad::Program& p) {
        return tree.files()[where.file] == p.sources[p.units[0].file].name();
    });
}

class WayFinder {
  public:
    WayFinder(const csg::Tree& tree, const csg::Scene& scene, const csg::scad::LoadedProgram& program,
              const std::string& text, csg::LeafId leaf, const EditGoal& goal, const TreeOfText& tree_of,
              const std::stop_token& stop)
        : tree_(tree),
          scene_(scene),
          program_(program),
          text_(text),
          leaf_(leaf),
          goal_(goal),
          tree_of_(tree_of),
          stop_(stop) {}

    std::vector<MoveWay> find(Ways wanted) {
        std::vector<csg::OccurrenceId> path = path_to(scene_, scene_.leaves[leaf_].occurrence);
        std::vector<std::size_t> calls;  // Of the main file on that path, from the leaf upward.
        csg::SourceLocation last;
        for (std::size_t i = path.size(); i-- > 0;) {
            const csg::SourceLocation where = tree_.node(scene_.occurrences[path[i]].node).where;
            if (where != last && of_main_file(tree_, program_, where)) {
                calls.push_back(i);
            }
            last = where;
        }
        const auto enough = [&] { return wanted == Ways::First && !ways_.empty(); };
        for (std::size_t i = 0; i < calls.size() && !enough(); ++i) {
            try_numbers(scene_.occurrences[path[calls[i]]].node);
        }
        // An axis by one call, another by the next.
        if (numbers_.size() > 1 && numbers_.size() <= kMostTogether && !by_a_call_) {
            try_together();
        }
        for (std::size_t i = 0; i < calls.size() && goal_.put && !enough(); ++i) {
            const csg::SourceLocation where = tree_.node(scene_.occurrences[path[calls[i]]].node).where;
            try_wrap(where, std::span(path).first(calls[i]));
        }
        std::stable_sort(ways_.begin(), ways_.end(), [](const MoveWay& a, const MoveWay& b) {
            return std::tuple(a.changed, a.moved, a.kind) < std::tuple(b.changed, b.moved, b.kind);
        });
        return std::move(ways_);
    }

  private:
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
            if (source.variable.empty()) {
                numbers_.insert(numbers_.end(), source.numbers.begin(), source.numbers.end());
                const csg::Statement* call = tree_.statement(node);
                names_.resize(numbers_.size(), call != nullptr ? call->name : "");
                places_.resize(numbers_.size(), where);
            }
            if (auto way = solved(source.numbers)) {
                way->kind = source.variable.empty() ? MoveWay::Kind::Call : MoveWay::Kind::Variable;
                const csg::Statement* call = tree_.statement(node);
                way->name = !source.variable.empty() ? source.variable : call != nullptr ? call->name : "";
                way->where = where;
                by_a_call_ |= way->kind == MoveWay::Kind::Call;
                ways_.push_back(std::move(*way));
            }
        }
    }

    /// Numbers of all calls at once.
    void try_together() {
        auto way = solved(numbers_);
        if (!way) {
            return;
        }
        std::sort(way->edits.begin(), way->edits.end(),
                  [](const TextEdit& a, const TextEdit& b) { return a.bytes.begin < b.bytes.begin; });
        for (const TextEdit& edit : way->edits) {
            const auto at = std::find_if(numbers_.begin(), numbers_.end(),
                                         [&](const LiteralText& n) { return n.bytes.begin == edit.bytes.begin; });
            const auto i = static_cast<std::size_t>(at - numbers_.begin());
            if (way->where != places_[i]) {
                way->name += (way->name.empty() ? "" : "() and ") + names_[i];
                way->where = way->where.known() ? way->where : places_[i];
            }
        }
        ways_.push_back(std::move(*way));
    }

    /// Newton's method on as few of the numbers as do, since how they lead to the place is not known: the program
    /// tells.
    std::optional<MoveWay> solved(const std::vector<LiteralText>& numbers) {
        std::vector<double> x;
        x.reserve(numbers.size());
        for (const LiteralText& n : numbers) {
            x.push_back(std::strtod(text_.substr(n.bytes.begin, n.bytes.end - n.bytes.begin).c_str(), nullptr));
        }
        const std::vector<double> first = x;
        std::vector<std::size_t> used(x.size());  // Which of them, from the first step on.
        std::iota(used.begin(), used.end(), std::size_t{0});
        std::optional<glm::dvec3> left = left_after({});
        for (int round = 0; round < 8 && left && glm::length(*left) > 0.05 * kNearEnough; ++round) {
            std::vector<glm::dvec3> columns;
            std::vector<double> values;
            for (const std::size_t i : used) {
                std::vector<double> moved = x;
                const double h = 1e-5 * std::max(1.0, std::abs(x[i]));
                moved[i] += h;
                const auto then = left_after(edits_to(numbers, moved, first, 0));
                columns.push_back(then ? (*left - *then) / h : glm::dvec3(0.0));
                values.push_back(x[i]);
            }
            const auto step = sparse_step(columns, *left, values, 0.2 * kNearEnough);
            if (!step) {
                return {};
            }
            std::vector<std::size_t> chosen;
            for (const auto& [column, change] : *step) {
                chosen.push_back(used[column]);
                x[chosen.back()] += change;
            }
            used = std::move(chosen);
            left = left_after(edits_to(numbers, x, first, 0));
        }
        if (!left) {
            return {};
        }
        // With as few digits as do.
        for (const double tolerance : {0.2 * kNearEnough, 0.01 * kNearEnough, 0.0}) {
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

    /// What is left to reach after the edits.
    std::optional<glm::dvec3> left_after(const std::vector<TextEdit>& edits) {
        if (edits.empty()) {
            return goal_.left(tree_, scene_.leaves[leaf_]);
        }
        const auto after = scene_after(edits);
        return after ? goal_.left(*after->first, after->second.leaves[leaf_]) : std::nullopt;
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
            const bool same = tree->node(scene.leaves[i].node).hash == tree_.node(scene_.leaves[i].node).hash;
            way.changed += !same && i != leaf_ ? 1 : 0;
            way.moved += apart(scene.leaves[i].to_world, scene_.leaves[i].to_world) > kNearEnough ? 1 : 0;
        }
        return goal_.reached(*tree, scene.leaves[leaf_]);
    }

    void try_wrap(const csg::SourceLocation& where, std::span<const csg::OccurrenceId> above) {
        const csg::SourceLocation place = in_program(where);
        const auto call = program_.look([&](const csg::scad::Program& p) { return csg::scad::call_at(p, place); });
        glm::dmat4 to_world(1.0);
        for (const csg::OccurrenceId o : above) {
            const csg::NodeId node = scene_.occurrences[o].node;
            if (tree_.node(node).operation == csg::Operation::Transform) {
                to_world = to_world * tree_.matrix(node);
            }
        }
        if (!call || std::abs(glm::determinant(to_world)) < 1e-12) {
            return;
        }
        auto put = goal_.put(to_world);
        if (!put) {
            return;
        }
        MoveWay way{MoveWay::Kind::Wrap, call->name, where, {}, std::move(put->second), 0, 0};
        way.edits.push_back({{call->bytes.begin, call->bytes.begin}, std::move(put->first)});
        if (holds(way)) {
            ways_.push_back(std::move(way));
        }
    }

    const csg::Tree& tree_;
    const csg::Scene& scene_;
    const csg::scad::LoadedProgram& program_;
    const std::string& text_;
    csg::LeafId leaf_;
    const EditGoal& goal_;
    const TreeOfText& tree_of_;
    const std::stop_token& stop_;
    std::vector<std::size_t> tried_;  ///< Where numbers begin that have been tried.
    /// Those of calls, with the names and places of the calls.
    std::vector<LiteralText> numbers_;
    std::vector<std::string> names_;
    std::vector<csg::SourceLocation> places_;
    bool by_a_call_ = false;  ///< There is a way by numbers of one.
    std::vector<MoveWay> ways_;
};

}  // namespace

double apart(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0;
    for (int k = 0; k < 4; ++k) {
        const glm::dvec4 d = glm::abs(a[k] - b[k]);
        most = std::max({most, d.x, d.y, d.z});
    }
    return most;
}

std::vector<MoveWay> edit_ways(const csg::Tree& tree, const csg::Scene& scene, const csg::scad::LoadedProgram& program,
                               const std::string& text, csg::LeafId leaf, const EditGoal& goal,
                               const TreeOfText& tree_of, const std::stop_token& stop, Ways wanted) {
    return WayFinder(tree, scene, program, text, leaf, goal, tree_of, stop).find(wanted);
}

std::string why_no_way(const csg::Tree& tree, const csg::Scene& scene, const csg::scad::LoadedProgram& program,
                       const std::string& text, csg::LeafId leaf, const TreeOfText& tree_of) {
    const std::vector<csg::OccurrenceId> path = path_to(scene, scene.leaves[leaf].occurrence);
    if (std::none_of(path.begin(), path.end(), [&](csg::OccurrenceId o) {
            return of_main_file(tree, program, tree.node(scene.occurrences[o].node).where);
        })) {
        return "no call of this file leads to it";
    }
    const auto again = tree_of(text);
    if (again == nullptr || again->node(again->root()).hash != tree.node(tree.root()).hash) {
        return "each run of the program makes something else";
    }
    if (std::abs(glm::determinant(glm::dmat3(scene.leaves[leaf].to_world))) < 1e-12) {
        return "it is squeezed flat";
    }
    return "the program makes something else of it wherever it is changed";
}

}  // namespace ui
