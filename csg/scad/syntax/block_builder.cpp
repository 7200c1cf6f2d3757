#include "csg/scad/syntax/block_builder.h"

namespace csg::scad {

std::optional<SourceRange> BlockBuilder::assign(const Argument& assignment) {
    if (keep_all_) {
        assignments_.push_back(assignment);
        return std::nullopt;
    }
    const auto [at, is_new] = places_.try_emplace(assignment.name, assignments_.size());
    if (is_new) {
        assignments_.push_back(assignment);
        return std::nullopt;
    }
    const std::size_t index = at->second;
    Argument& known = assignments_[index];
    const SourceRange first = overwritten_.try_emplace(index, known.where).first->second;
    known = assignment;
    return first;
}

PieceStatements BlockBuilder::take() {
    return {std::move(assignments_), std::move(functions_), std::move(modules_), std::move(instantiations_)};
}

BlockId BlockBuilder::finish(Program& program) {
    Block block;
    block.assignments = append_run(program.assignments, assignments_, 0);
    for (const auto& [index, place] : overwritten_) {
        program.first_places.emplace(block.assignments.first + static_cast<std::uint32_t>(index), place);
    }
    block.functions = append_run(program.functions, functions_, 0);
    block.modules = append_run(program.modules, modules_, 0);
    block.instantiations = append_run(program.instantiations, instantiations_, 0);
    program.blocks.push_back(block);
    return static_cast<BlockId>(program.blocks.size() - 1);
}

}  // namespace csg::scad
