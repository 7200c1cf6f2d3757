#include "ui/viewer/moving.h"

#include <algorithm>
#include <exception>
#include <memory>

#include "base/stop.h"
#include "csg/scad/program/loaded_program.h"
#include "csg/tree/scene_edit.h"
#include "ui/pipeline/editing/scale_leaf.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/program_runner.h"

namespace ui {

namespace {

std::size_t no_message(const csg::scad::Message& /*message*/, const csg::scad::SourceSet& /*sources*/) {
    return 0;
}

/// Those that take all of what is held along before others, and those at the call that was moved before others that do
/// alike.
void prefer(std::vector<MoveWay>& ways, const MoveQuestion& question) {
    // The leaf itself counts among neither those that move nor the others that change where its shape does.
    const std::size_t itself = question.held.side || question.held.scale != glm::dvec3(1.0) ? 1 : 0;
    const auto rank = [&](const MoveWay& way) {
        const bool other = way.where.line != question.call.line || way.where.column != question.call.column;
        const bool leaves_some = way.moved + way.changed + itself < question.leaves;
        return std::tuple(leaves_some, way.changed, way.moved, way.kind, way.put.size(), other);
    };
    std::stable_sort(ways.begin(), ways.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

MoveAnswer find(const MoveQuestion& question, ProgramRunner& runner, const std::stop_token& stop) {
    MoveAnswer answer{question.text, {}, question.what, question.held, {}};
    Source source = question.source;
    const auto request = [&](const std::string& text) {
        source.edited = text;
        csg::scad::Request asked = request_of(source, question.camera, stop);
        asked.definitions.insert(asked.definitions.end(), source.customized.begin(), source.customized.end());
        return asked;
    };
    // Runs of other texts must leave this program as it is.
    ProgramRunner first(make_measures());
    const ProgramRun run = first.run(request(question.text), false, no_message);
    if (!run.good()) {
        answer.trouble = "The text has errors.";
        return answer;
    }
    const csg::Scene scene = csg::make_scene(*run.evaluation.tree);
    csg::LeafId leaf = 0;
    while (leaf < scene.leaves.size() && name_of(*run.evaluation.tree, scene, leaf) != question.leaf) {
        ++leaf;
    }
    if (leaf == scene.leaves.size()) {
        answer.trouble = "It is not in what the text makes.";
        return answer;
    }
    const auto tree_of = [&](const std::string& text) -> std::shared_ptr<const csg::Tree> {
        const ProgramRun changed = runner.run(request(text), false, no_message);
        base::end_if_asked(stop);
        return changed.good() ? changed.evaluation.tree : nullptr;
    };
    const csg::Tree& tree = *run.evaluation.tree;
    const csg::scad::LoadedProgram& program = *run.evaluation.program;
    const HeldPart& held = question.held;
    answer.ways = held.side ? ways_to_stretch(tree, scene, program, question.text, leaf, held.side->axis,
                                              held.side->upper, held.side->by, tree_of, stop)
                  : held.scale != glm::dvec3(1.0)
                      ? ways_to_scale(tree, scene, program, question.text, leaf, held.scale, tree_of, stop)
                  : glm::length(held.turn) > 0
                      ? ways_to_turn(tree, scene, program, question.text, leaf, held.turn, tree_of, stop)
                      : ways_to_move(tree, scene, program, question.text, leaf, held.by, tree_of, stop);
    prefer(answer.ways, question);
    if (answer.ways.empty()) {
        answer.trouble =
            held.side ? "No number of the text moves that side."
                      : why_no_way(*run.evaluation.tree, scene, *run.evaluation.program, question.text, leaf, tree_of);
    }
    return answer;
}

}  // namespace

LeafName name_of(const csg::Tree& tree, const csg::Scene& scene, csg::LeafId leaf) {
    LeafName name;
    for (const csg::OccurrenceId occurrence : path_to(scene, scene.leaves[leaf].occurrence)) {
        const csg::SourceLocation& where = tree.node(scene.occurrences[occurrence].node).where;
        if (where.known()) {
            name.calls.emplace_back(tree.files()[where.file], where.line, where.column);
        }
    }
    name.to_world = scene.leaves[leaf].to_world;
    return name;
}

Gesture gesture_of(const HeldPart& held) {
    constexpr double kShown = 1e-6;
    if (held.side) {
        return {"stretch", "stretched by " + short_number(held.side->by, kShown)};
    }
    if (held.scale != glm::dvec3(1.0)) {
        return {"scale", "scaled by " + short_vector(held.scale, kShown)};
    }
    if (glm::length(held.turn) > 0) {
        return {"turn", "turned by " + short_vector(held.turn, kShown) + "°"};
    }
    return {"move", "moved by " + short_vector(held.by, kShown)};
}

std::size_t leaves_below(const csg::Scene& scene, csg::OccurrenceId occurrence) {
    const std::vector<char> below = csg::occurrences_below(scene, occurrence);
    return static_cast<std::size_t>(
        std::count_if(scene.leaves.begin(), scene.leaves.end(), [&](const csg::LeafInstance& leaf) {
            return leaf.occurrence != csg::kNoOccurrence && below[leaf.occurrence] != 0;
        }));
}

csg::LeafId first_leaf_below(const csg::Scene& scene, csg::OccurrenceId occurrence) {
    const std::vector<char> below = csg::occurrences_below(scene, occurrence);
    csg::LeafId leaf = 0;
    while (leaf < scene.leaves.size() &&
           (scene.leaves[leaf].occurrence == csg::kNoOccurrence || below[scene.leaves[leaf].occurrence] == 0)) {
        ++leaf;
    }
    return leaf;
}

csg::Box box_below(const Model& model, csg::OccurrenceId occurrence) {
    csg::Box box;
    if (occurrence >= model.scene.occurrences.size()) {
        return box;
    }
    const std::vector<char> below = csg::occurrences_below(model.scene, occurrence);
    for (csg::LeafId leaf = 0; leaf < model.scene.leaves.size(); ++leaf) {
        const csg::OccurrenceId own = model.scene.leaves[leaf].occurrence;
        if (own != csg::kNoOccurrence && below[own] != 0) {
            box = csg::enclose(box, model.geometry.leaves[leaf].box);
        }
    }
    return box;
}

FindWays make_find_ways() {
    return [runner = std::make_shared<ProgramRunner>(make_measures())](const MoveQuestion& question,
                                                                       const std::stop_token& stop) {
        try {
            return find(question, *runner, stop);
        } catch (const base::Stopped&) {
            return MoveAnswer{};
        } catch (const std::exception& error) {
            return MoveAnswer{question.text, {}, question.what, question.held, error.what()};
        }
    };
}

}  // namespace ui
