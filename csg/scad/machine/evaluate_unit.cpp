// Used files. Whoever looks one of their names up has the assignments at their top worked out anew, where the caller's
// `$` variables are seen; the `$` variables that the file sets end with its assignments. An evaluation is kept and
// serves again where that cannot be told: while all that it read of its callers is as it was.
#include <algorithm>

#include "csg/scad/machine/evaluator.h"

namespace csg::scad {

namespace {

constexpr std::size_t kMostKept = 16;

}  // namespace

const Frame* Evaluator::enter_unit(UnitId id) {
    Unit& unit = units_[id];
    if (unit.running != nullptr) {  // Files may use each other in circles.
        return &unit.running->frame;
    }
    const auto found = std::find_if(unit.kept.begin(), unit.kept.end(), [&](const UnitFrame* kept) {
        return std::all_of(kept->reads.begin(), kept->reads.end(),
                           [&](const auto& read) { return identical(dynamic_[read.first], read.second); });
    });
    if (found == unit.kept.end()) {
        return &evaluate_unit(id).frame;
    }
    for (const auto& read : (*found)->reads) {
        note_read(read.first);
    }
    std::rotate(unit.kept.begin(), found, found + 1);
    return &unit.kept.front()->frame;
}

Evaluator::UnitFrame& Evaluator::evaluate_unit(UnitId id) {
    Unit& unit = units_[id];
    resolver_.need_unit(id);
    const BlockId block = p_.units[id].block;
    UnitFrame& made = unit.frames.emplace_back();
    made.slots.assign(r_.frame_slots[block], Value::unset());
    made.frame = {nullptr, made.slots.data(), nullptr};
    unit.running = &made;
    const std::uint64_t effects = host_.effects;
    {
        const DynamicMark mark(*this);
        readings_.push_back({&made.reads, undo_.size()});
        run_assignments(p_.blocks[block], made.frame);
        readings_.pop_back();
    }
    unit.running = nullptr;
    if (host_.effects == effects) {
        unit.kept.resize(std::min(unit.kept.size(), kMostKept - 1));
        unit.kept.insert(unit.kept.begin(), &made);
    }
    return made;
}

/// Evaluations of files that are under way depend on the `$` variable, but those that have set it themselves.
void Evaluator::note_read_of(std::uint32_t index) {
    std::size_t top = undo_.size();
    for (auto reading = readings_.rbegin(); reading != readings_.rend(); ++reading) {
        for (; top > reading->mark; --top) {
            if (undo_[top - 1].index == index) {
                return;
            }
        }
        auto& reads = *reading->reads;
        if (std::none_of(reads.begin(), reads.end(), [&](const auto& read) { return read.first == index; })) {
            reads.emplace_back(index, dynamic_[index]);
        }
    }
}

}  // namespace csg::scad
