// Files that are parsed by themselves, kept as long as programs are made of them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "csg/scad/syntax/piece.h"

namespace csg::scad {

/// Not to be called by two threads at a time.
class PieceStore {
  public:
    /// The file as a piece; null where it is none, or not worth it. `edited`: it may well be another the next time, and
    /// is parsed by itself only once it has been asked for before.
    [[nodiscard]] std::shared_ptr<const Piece> get(const SharedSource& file, bool edited);
    /// Lets go of files that nobody has asked for since `kKept` calls of this.
    void trim();
    /// How many files were parsed to be pieces.
    [[nodiscard]] std::size_t made() const { return made_; }

    static constexpr std::uint32_t kKept = 16;

  private:
    struct Entry {
        bool tried = false;
        std::shared_ptr<const Piece> piece;
        std::uint32_t used = 0;
    };
    std::map<SharedSource, Entry> entries_;
    std::uint32_t round_ = 0;
    std::size_t made_ = 0;
};

}  // namespace csg::scad
