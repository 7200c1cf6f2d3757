#include <algorithm>
#include <utility>

#include "csg/scad/evaluator.h"

namespace csg::scad {

namespace {
constexpr std::size_t kChunk = std::size_t{1} << 14;
}

Value* ValueStack::take(std::size_t count) {
    while (chunk_ < chunks_.size() && top_ + count > chunks_[chunk_].size) {
        ++chunk_;
        top_ = 0;
    }
    if (chunk_ == chunks_.size()) {
        const std::size_t size = std::max(kChunk, count);
        chunks_.push_back({std::make_unique<Value[]>(size), size});
    }
    Value* const data = chunks_[chunk_].values.get() + top_;
    top_ += count;
    std::fill_n(data, count, Value::unset());
    return data;
}

ValueStack::Region::Region(ValueStack& stack, std::size_t count)
    : stack_(stack), chunk_(stack.chunk_), top_(stack.top_), count_(count), data_(stack.take(count)) {}

ValueStack::Region::~Region() {
    if (data_ != nullptr) {
        release();
    }
}

void ValueStack::Region::release() {
    std::fill_n(data_, count_, Value());
    stack_.chunk_ = chunk_;
    stack_.top_ = top_;
    data_ = nullptr;
}

void ValueStack::Region::replace(Region& newer) {
    if (newer.count_ <= count_) {
        std::move(newer.data_, newer.data_ + newer.count_, data_);
        std::fill(data_ + newer.count_, data_ + count_, Value::unset());
        return;
    }
    std::vector<Value> values(std::make_move_iterator(newer.data_),
                              std::make_move_iterator(newer.data_ + newer.count_));
    newer.release();
    release();
    count_ = values.size();
    data_ = stack_.take(count_);
    std::move(values.begin(), values.end(), data_);
}

}  // namespace csg::scad
