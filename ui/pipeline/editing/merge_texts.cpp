#include "ui/pipeline/editing/merge_texts.h"

#include <algorithm>
#include <cstdint>

#include "ui/pipeline/editing/statement_pieces.h"

namespace ui {

namespace {

using Pieces = std::vector<std::string_view>;

/// Pieces [begin, end) of the base, and what stands in their place.
struct Hunk {
    std::size_t begin = 0, end = 0;
    std::string text;
};

Pieces pieces_of(std::string_view text) {
    Pieces pieces;
    for (const csg::scad::ByteRange& bytes : statement_pieces(text)) {
        pieces.push_back(text.substr(bytes.begin, bytes.end - bytes.begin));
    }
    return pieces;
}

std::string joined(const Pieces& pieces, std::size_t begin, std::size_t end) {
    std::string text;
    for (std::size_t i = begin; i < end; ++i) {
        text += pieces[i];
    }
    return text;
}

/// Where pieces of `b` stand that are those of `a` in a longest common subsequence; kNowhere for others.
constexpr std::size_t kNowhere = ~std::size_t{0};
std::vector<std::size_t> places_of(const Pieces& a, const Pieces& b) {
    std::vector<std::size_t> places(a.size(), kNowhere);
    std::size_t head = 0, tail = 0;
    for (; head < a.size() && head < b.size() && a[head] == b[head]; ++head) {
        places[head] = head;
    }
    for (; tail < a.size() - head && tail < b.size() - head && a[a.size() - 1 - tail] == b[b.size() - 1 - tail];
         ++tail) {
        places[a.size() - 1 - tail] = b.size() - 1 - tail;
    }
    const std::size_t rows = a.size() - head - tail, columns = b.size() - head - tail;
    constexpr std::size_t kMost = 16'000'000;
    if (rows == 0 || columns == 0 || rows > kMost / columns) {
        return places;
    }
    // Of what is left from row i and column j on.
    std::vector<std::uint32_t> longest((rows + 1) * (columns + 1), 0);
    const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& { return longest[i * (columns + 1) + j]; };
    for (std::size_t i = rows; i-- > 0;) {
        for (std::size_t j = columns; j-- > 0;) {
            at(i, j) = a[head + i] == b[head + j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
        }
    }
    for (std::size_t i = 0, j = 0; i < rows && j < columns;) {
        if (a[head + i] == b[head + j]) {
            places[head + i++] = head + j++;
        } else if (at(i + 1, j) >= at(i, j + 1)) {
            ++i;
        } else {
            ++j;
        }
    }
    return places;
}

/// What `changed` has made of the base. As many pieces in the place of as many are a hunk each.
std::vector<Hunk> hunks_of(const Pieces& base, const Pieces& changed) {
    const std::vector<std::size_t> places = places_of(base, changed);
    std::vector<Hunk> hunks;
    std::size_t i = 0, j = 0;
    while (i < base.size() || j < changed.size()) {
        if (i < base.size() && places[i] == j) {
            ++i;
            ++j;
            continue;
        }
        std::size_t end = i;
        while (end < base.size() && places[end] == kNowhere) {
            ++end;
        }
        const std::size_t end_changed = end < base.size() ? places[end] : changed.size();
        if (end - i == end_changed - j) {
            for (; i < end; ++i, ++j) {
                hunks.push_back({i, i + 1, std::string(changed[j])});
            }
        } else {
            hunks.push_back({i, end, joined(changed, j, end_changed)});
        }
        i = end;
        j = end_changed;
    }
    return hunks;
}

/// Both replace something of it.
bool overlap(const Hunk& a, const Hunk& b) {
    return std::max(a.begin, b.begin) < std::min(a.end, b.end);
}

class Merger {
  public:
    Merger(const Pieces& base, const std::vector<Hunk>& ours, const std::vector<Hunk>& theirs)
        : base_(base), ours_(ours), theirs_(theirs) {}

    Merged merge() {
        while (our_ < ours_.size() || their_ < theirs_.size()) {
            if (our_ < ours_.size() && their_ < theirs_.size() && overlap(ours_[our_], theirs_[their_])) {
                clash();
            } else if (their_first()) {
                take(theirs_[their_++]);
            } else {
                take(ours_[our_++]);
            }
        }
        copy_to(base_.size());
        return std::move(result_);
    }

  private:
    [[nodiscard]] bool their_first() const {
        if (our_ == ours_.size() || their_ == theirs_.size()) {
            return our_ == ours_.size();
        }
        const Hunk &our = ours_[our_], &their = theirs_[their_];
        return std::pair(their.begin, their.end) <= std::pair(our.begin, our.end);
    }

    void copy_to(std::size_t piece) {
        result_.text += joined(base_, at_, piece);
        at_ = std::max(at_, piece);
    }

    void take(const Hunk& hunk) {
        // Both have put the same in.
        const bool again = hunk.begin == hunk.end && last_ && last_->begin == hunk.begin && last_->end == hunk.end &&
                           last_->text == hunk.text;
        copy_to(hunk.begin);
        if (!again) {
            result_.text += hunk.text;
        }
        at_ = hunk.end;
        last_ = &hunk;
    }

    /// All hunks that hang together by overlaps.
    void clash() {
        const std::size_t begin = std::min(ours_[our_].begin, theirs_[their_].begin);
        std::size_t end = std::max(ours_[our_].end, theirs_[their_].end);
        const std::size_t first_our = our_++, first_their = their_++;
        for (bool more = true; more;) {
            more = false;
            for (auto [hunks, next] : {std::pair(&ours_, &our_), std::pair(&theirs_, &their_)}) {
                for (; *next < hunks->size() && (*hunks)[*next].begin < end; ++*next) {
                    end = std::max(end, (*hunks)[*next].end);
                    more = true;
                }
            }
        }
        copy_to(begin);
        MergeConflict conflict{{},
                               joined(base_, begin, end),
                               side(ours_, first_our, our_, begin, end),
                               side(theirs_, first_their, their_, begin, end)};
        conflict.bytes = {result_.text.size(), result_.text.size() + conflict.ours.size()};
        result_.text += conflict.ours;
        at_ = end;
        if (conflict.ours != conflict.theirs) {
            result_.conflicts.push_back(std::move(conflict));
        }
    }

    /// The pieces [begin, end) as one side has them.
    [[nodiscard]] std::string side(const std::vector<Hunk>& hunks, std::size_t first, std::size_t last,
                                   std::size_t begin, std::size_t end) const {
        std::string text;
        for (std::size_t i = first; i < last; ++i) {
            text += joined(base_, begin, hunks[i].begin) + hunks[i].text;
            begin = hunks[i].end;
        }
        return text + joined(base_, begin, end);
    }

    const Pieces& base_;
    const std::vector<Hunk>&ours_, &theirs_;
    std::size_t our_ = 0, their_ = 0;  ///< Those that are next.
    std::size_t at_ = 0;               ///< Pieces of the base that are done.
    const Hunk* last_ = nullptr;       ///< That was taken last.
    Merged result_;
};

}  // namespace

Merged merged(std::string_view base, std::string_view ours, std::string_view theirs) {
    if (ours == theirs || base == theirs) {
        return {std::string(ours), {}};
    }
    if (base == ours) {
        return {std::string(theirs), {}};
    }
    const Pieces pieces = pieces_of(base);
    const std::vector<Hunk> our = hunks_of(pieces, pieces_of(ours)), their = hunks_of(pieces, pieces_of(theirs));
    return Merger(pieces, our, their).merge();
}

}  // namespace ui
