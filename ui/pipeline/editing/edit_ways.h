// Ways to edit a text so that one of its solids becomes what a hand made of it: the search that moving, turning and
// stretching have in common.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "ui/pipeline/editing/text_edit.h"
#include "ui/pipeline/model.h"

namespace ui {

/// The tree of the program with another text of its main file; null where it has an error.
using TreeOfText = std::function<std::shared_ptr<const csg::Tree>(const std::string& text)>;

/// A way to edit the main file so that a leaf is what it is to be.
struct MoveWay {
    enum class Kind : std::uint8_t {
        Call,      ///< Numbers of a call that leads to the leaf, or of several.
        Variable,  ///< Numbers that a variable is assigned, which such a call is made of.
        Wrap,      ///< Calls put before such a call.
    };
    Kind kind = Kind::Call;
    std::string name;           ///< Of the call or the variable; of several "for() and translate".
    csg::SourceLocation where;  ///< Of the call.
    std::vector<TextEdit> edits;
    std::string put;          ///< What is put before it: "translate()".
    std::size_t moved = 0;    ///< Leaves that lie elsewhere then, that one among them where it does.
    std::size_t changed = 0;  ///< Leaves that are of another shape then, that one not among them.
};

/// How many ways are looked for.
enum class Ways : std::uint8_t {
    All,
    First,  ///< One: numbers before calls that are put in, of them the nearest to the leaf.
};

/// What a leaf is to be. A functor for each: how gestures differ.
struct EditGoal {
    using Leaf = csg::LeafInstance;
    /// What is left to reach of three numbers; nothing where that cannot be told. Zero where it is reached.
    std::function<std::optional<glm::dvec3>(const csg::Tree&, const Leaf&)> left;
    /// It is what it is to be.
    std::function<bool(const csg::Tree&, const Leaf&)> reached;
    /// What is to be put before a call, and its name ("translate()"), in the coordinates that hold there; nothing where
    /// that does not help. Empty: never.
    std::function<std::optional<std::pair<std::string, std::string>>(const glm::dmat4& to_world)> put;
};

/// World units, and of the entries of matrices: how near to where it was put a leaf must lie.
inline constexpr double kNearEnough = 1e-6;

/// The largest difference of their entries.
[[nodiscard]] double apart(const glm::dmat4& a, const glm::dmat4& b);

/// All ways that hold when tried: after each the goal is reached and as many leaves are there as before. Those first
/// that change no other shapes and move least; of equal ones calls nearest to the leaf, then variables, then calls put
/// in. None where the leaf is made by no call of the main file. `text`: of the main file. Runs the program some five
/// times for each way. Throws base::Stopped.
[[nodiscard]] std::vector<MoveWay> edit_ways(const csg::Tree& tree, const csg::Scene& scene,
                                             const csg::scad::LoadedProgram& program, const std::string& text,
                                             csg::LeafId leaf, const EditGoal& goal, const TreeOfText& tree_of,
                                             const std::stop_token& stop, Ways wanted);

/// Why there is none, for people. Runs the program once.
[[nodiscard]] std::string why_no_way(const csg::Tree& tree, const csg::Scene& scene,
                                     const csg::scad::LoadedProgram& program, const std::string& text, csg::LeafId leaf,
                                     const TreeOfText& tree_of);

}  // namespace ui
