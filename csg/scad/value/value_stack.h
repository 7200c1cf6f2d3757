// Registers of activations and slots of frames, in chunks that never move.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "csg/scad/value/value.h"

namespace csg::scad {

/// Regions nest: what was taken last is given back first. Whoever gives back has dropped what the values share.
class ValueStack {
  public:
    struct Mark {
        std::size_t chunk;
        Value* top;
    };
    ValueStack() { add_chunk(kSmallest); }
    ValueStack(const ValueStack&) = delete;
    ValueStack& operator=(const ValueStack&) = delete;

    [[nodiscard]] Mark mark() const { return {chunk_, top_}; }
    void restore(const Mark& mark) {
        if (mark.chunk != chunk_) {
            enter(mark.chunk);
        }
        top_ = mark.top;
    }
    /// `count` values, whatever they are.
    [[nodiscard]] Value* take(std::size_t count) { return extend(top_, count, 0); }
    /// Makes `count` values from `first` on the innermost region; `first` lies in the one that was, or at its end.
    /// Where they do not fit the first `used` are moved to where they do.
    [[nodiscard]] Value* extend(Value* first, std::size_t count, std::size_t used) {
        if (count <= static_cast<std::size_t>(end_ - first)) {
            top_ = first + count;
            return first;
        }
        return move(first, count, used);
    }

    /// `count` values, all unset, until it is destroyed.
    class Region {
      public:
        Region(ValueStack& stack, std::size_t count);
        ~Region();
        Region(const Region&) = delete;
        Region& operator=(const Region&) = delete;
        [[nodiscard]] Value* data() const { return data_; }

      private:
        ValueStack& stack_;
        const Mark mark_;
        const std::size_t count_;
        Value* const data_;
    };

  private:
    static constexpr std::size_t kSmallest = 1024;  ///< Values of the first chunk; each has twice those before it.
    static constexpr std::size_t kLargest = std::size_t{1} << 16;

    [[nodiscard]] Value* move(Value* first, std::size_t count, std::size_t used);
    void add_chunk(std::size_t size);
    void enter(std::size_t chunk);

    struct Chunk {
        std::unique_ptr<Value[]> values;
        std::size_t size;
    };
    std::vector<Chunk> chunks_;
    std::size_t chunk_ = 0;
    Value* top_ = nullptr;
    Value* end_ = nullptr;
};

}  // namespace csg::scad
