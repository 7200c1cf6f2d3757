// A solid that is moved by hand, as edits of the text that made it.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "ui/pipeline/editing/text_edit.h"
#include "ui/pipeline/model.h"

namespace ui {

/// The tree of the program with another text of its main file; null where it has an error.
using TreeOfText = std::function<std::shared_ptr<const csg::Tree>(const std::string& text)>;

/// A way to edit the main file so that a leaf lies where it was put.
struct MoveWay {
    enum class Kind {
        Call,      ///< Numbers of a call that leads to the leaf.
        Variable,  ///< Numbers that a variable is assigned, which such a call is made of.
        Wrap,      ///< A translate() before such a call.
    };
    Kind kind = Kind::Call;
    std::string name;           ///< Of the call or the variable.
    csg::SourceLocation where;  ///< Of the call.
    std::vector<TextEdit> edits;
    std::size_t moved = 0;    ///< Leaves that lie elsewhere then, that one among them.
    std::size_t changed = 0;  ///< Leaves that are of another shape then.
};

/// How many ways are looked for.
enum class Ways {
    All,
    First,  ///< One: numbers before translate(), of them the nearest to the leaf.
};

/// All ways that hold when tried: after each the leaf is what it was and lies within 1e-6 of where it was put (world
/// units), and as many leaves are there as before. Those first that change no shapes and move least; of equal ones
/// calls nearest to the leaf, then variables, then translate(). None where the leaf is made by no call of the main
/// file. `text`: of the main file. `by`: world units. Runs the program some five times for each way. Throws
/// base::Stopped.
[[nodiscard]] std::vector<MoveWay> ways_to_move(const csg::Tree& tree, const csg::Scene& scene,
                                                const csg::scad::LoadedProgram& program, const std::string& text,
                                                csg::LeafId leaf, const glm::dvec3& by, const TreeOfText& tree_of,
                                                const std::stop_token& stop = {}, Ways wanted = Ways::All);

/// Why there is none, for people. Runs the program once.
[[nodiscard]] std::string why_not_moved(const csg::Tree& tree, const csg::Scene& scene,
                                        const csg::scad::LoadedProgram& program, const std::string& text,
                                        csg::LeafId leaf, const TreeOfText& tree_of);

}  // namespace ui
