// What was computed lately, found again.
#pragma once

#include <cstdint>
#include <vector>

namespace npr {

/// Results of a function whose arguments are a number. Of those whose numbers fall together the last stays, so that
/// memory is bounded, and nothing but time depends on which are there.
template <typename Result, unsigned kBits>
class Memo {
  public:
    /// The function's result for `key`: what is remembered, or else compute(). `key`: below 2^64 - 1.
    template <typename Compute>
    Result of(std::uint64_t key, const Compute& compute) {
        Entry& entry = entries_[static_cast<std::size_t>(key * 0x9e3779b97f4a7c15U >> (64 - kBits))];
        if (entry.key != key) {
            entry.result = compute();
            entry.key = key;
        }
        return entry.result;
    }

  private:
    struct Entry {
        std::uint64_t key = ~std::uint64_t{0};
        Result result{};
    };
    std::vector<Entry> entries_ = std::vector<Entry>(std::size_t{1} << kBits);
};

}  // namespace npr
