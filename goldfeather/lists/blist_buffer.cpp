#include "goldfeather/lists/blist_buffer.h"

#include <algorithm>

namespace goldfeather {

BlistBuffer::BlistBuffer(const gl::Functions& gl, const Blist& blist)
    : rows_(gl),
      leaves_(blist.leaves()),
      first_group_(static_cast<std::uint32_t>(2 * leaves_.size())),
      first_start_(first_group_ + static_cast<std::uint32_t>(2 * blist.groups().size())),
      parts_(static_cast<std::uint32_t>(blist.starts().size())) {
    static_assert(sizeof(Blist::Leaf) == 2 * sizeof(glm::uvec4));
    for (const Blist::Group& g : blist.groups()) {
        others_.emplace_back(g.start, g.last, g.when_true, g.when_false);
        others_.emplace_back(g.parent, g.operand, g.next, 0);
    }
    for (const std::uint32_t start : blist.starts()) {
        others_.emplace_back(start, 0, 0, 0);
    }
    upload();
}

void BlistBuffer::set_flags(std::span<const std::uint32_t> flags) {
    const auto same = [](const Blist::Leaf& row, std::uint32_t wanted) { return row.flags == wanted; };
    if (std::equal(leaves_.begin(), leaves_.end(), flags.begin(), flags.end(), same)) {
        return;
    }
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
        leaves_[i].flags = flags[i];
    }
    upload();
}

void BlistBuffer::upload() {
    std::vector<glm::uvec4> rows;
    rows.reserve(first_start_ + parts_);
    for (const Blist::Leaf& leaf : leaves_) {
        rows.emplace_back(leaf.inside, leaf.first, leaf.last, leaf.chain_end);
        rows.emplace_back(leaf.group, leaf.complement, leaf.rank, leaf.flags);
    }
    rows.insert(rows.end(), others_.begin(), others_.end());
    rows_.upload<glm::uvec4>(rows, GL_DYNAMIC_DRAW);
}

void BlistBuffer::bind(const gl::Program& program) const {
    rows_.bind(GL_SHADER_STORAGE_BUFFER, 6);
    program.set("first_group", first_group_);
    program.set("first_start", first_start_);
    program.set("part_count", parts_);
}

}  // namespace goldfeather
