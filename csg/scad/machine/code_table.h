// Code of expressions by their number: most have none, so a table of those that do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "csg/scad/machine/instruction.h"

namespace csg::scad {

class CodeTable {
  public:
    /// Null where none was entered.
    [[nodiscard]] const Code* find(ExprId e) const { return slots_[slot_of(e)].code; }
    /// An expression that is not in the table. The code must outlive it.
    void enter(ExprId e, const Code& code) {
        if (2 * ++used_ > slots_.size()) {
            grow();
        }
        slots_[slot_of(e)] = {e, &code};
    }

  private:
    struct Slot {
        ExprId e = kNone;
        const Code* code = nullptr;
    };

    /// Of the expression, or the free one where it would go. The table is never full.
    [[nodiscard]] std::size_t slot_of(ExprId e) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = (e * 0x9e3779b1U >> 7U) & mask;
        while (slots_[at].code != nullptr && slots_[at].e != e) {
            at = (at + 1) & mask;
        }
        return at;
    }
    void grow() {
        std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
        for (const Slot& slot : old) {
            if (slot.code != nullptr) {
                slots_[slot_of(slot.e)] = slot;
            }
        }
    }

    std::vector<Slot> slots_ = std::vector<Slot>(64);  // A power of two of them.
    std::size_t used_ = 0;
};

}  // namespace csg::scad
