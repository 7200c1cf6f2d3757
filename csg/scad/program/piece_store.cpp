#include "csg/scad/program/piece_store.h"

namespace csg::scad {

std::shared_ptr<const Piece> PieceStore::get(const SharedSource& file, bool edited) {
    const auto [at, is_new] = entries_.try_emplace(file);
    Entry& entry = at->second;
    const bool again = !is_new && entry.used != round_;
    entry.used = round_;
    if (!entry.tried && (!edited || again)) {
        entry.piece = make_piece(file);
        entry.tried = true;
        ++made_;
    }
    return entry.piece;
}

void PieceStore::trim() {
    ++round_;
    std::erase_if(entries_, [this](const auto& entry) { return round_ - entry.second.used > kKept; });
}

}  // namespace csg::scad
