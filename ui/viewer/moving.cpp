#include "ui/viewer/moving.h"

#include <algorithm>
#include <exception>
#include <memory>

#include "base/stop.h"
#include "csg/scad/program/loaded_program.h"
#include "csg/tree/scene_edit.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/program_runner.h"

namespace ui {

namespace {

std::size_t no_message(const csg::scad::Message& /*message*/, const csg::scad::SourceSet& /*sources*/) {
    return 0;
}

/// Those at the call that was moved before others that do alike.
void prefer(std::vector<MoveWay>& ways, const csg::SourceLocation& call) {
    const auto rank = [&](const MoveWay& way) {
        const bool other = way.where.line != call.line || way.where.column != call.column;
        return std::tuple(way.changed, way.moved, way.kind, way.put.size(), other);
    };
    std::stable_sort(ways.begin(), ways.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

MoveAnswer find(const MoveQuestion& question, ProgramRunner& runner, const std::stop_token& stop) {
    MoveAnswer answer{question.text, {}, question.what, question.by, {}, question.turn};
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
    answer.ways = glm::length(question.turn) > 0
                      ? ways_to_turn(tree, scene, program, question.text, leaf, question.turn, tree_of, stop)
                      : ways_to_move(tree, scene, program, question.text, leaf, question.by, tree_of, stop);
    prefer(answer.ways, question.call);
    if (answer.ways.empty()) {
        answer.trouble = why_no_way(*run.evaluation.tree, scene, *run.evaluation.program, question.text, leaf, tree_of);
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
            return MoveAnswer{question.text, {}, question.what, question.by, error.what(), question.turn};
        }
    };
}

}  // namespace ui
