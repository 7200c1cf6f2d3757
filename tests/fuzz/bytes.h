// What a fuzzer gives, one byte after the other; zeros from the end on.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fuzz {

class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    [[nodiscard]] bool done() const { return at_ >= size_; }
    std::uint8_t next() { return done() ? std::uint8_t{0} : data_[at_++]; }
    /// A number from 0 to count - 1.
    int below(int count) { return next() % count; }

  private:
    const std::uint8_t* data_;
    std::size_t size_, at_ = 0;
};

}  // namespace fuzz
