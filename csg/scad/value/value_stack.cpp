#include "csg/scad/value/value_stack.h"

#include <algorithm>

namespace csg::scad {

void ValueStack::add_chunk(std::size_t size) {
    chunks_.push_back({std::make_unique<Value[]>(size), size});
    enter(chunks_.size() - 1);
}

void ValueStack::enter(std::size_t chunk) {
    chunk_ = chunk;
    top_ = chunks_[chunk].values.get();
    end_ = top_ + chunks_[chunk].size;
}

Value* ValueStack::move(Value* first, std::size_t count, std::size_t used) {
    do {
        if (chunk_ + 1 < chunks_.size()) {
            enter(chunk_ + 1);
        } else {
            add_chunk(std::max(count, std::min(2 * chunks_.back().size, kLargest)));
        }
    } while (count > static_cast<std::size_t>(end_ - top_));
    Value* const begin = top_;
    std::move(first, first + used, begin);
    top_ = begin + count;
    return begin;
}

ValueStack::Region::Region(ValueStack& stack, std::size_t count)
    : stack_(stack), mark_(stack.mark()), count_(count), data_(stack.take(count)) {
    std::fill_n(data_, count, Value::unset());
}

ValueStack::Region::~Region() {
    std::for_each_n(data_, count_, [](Value& v) { v.drop(); });
    stack_.restore(mark_);
}

}  // namespace csg::scad
