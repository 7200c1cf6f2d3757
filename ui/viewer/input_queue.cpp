#include "ui/viewer/input_queue.h"

#include <algorithm>
#include <utility>

namespace ui {

void InputQueue::add(Input input) {
    pointer_.insert(pointer_.end(), input.pointer.begin(), input.pointer.end());
    keys_.insert(keys_.end(), input.keys.begin(), input.keys.end());
    dropped_.insert(dropped_.end(), input.dropped.begin(), input.dropped.end());
    latest_ = input.cursor;
    any_ |= input.any;
}

Input InputQueue::next() {
    Input frame;
    frame.any = std::exchange(any_, false);
    frame.dropped = std::exchange(dropped_, {});
    bool moved = false, pressed = false, scrolled = false;
    while (!pointer_.empty()) {
        const PointerEvent& event = pointer_.front();
        const bool button = event.kind == PointerKind::Press || event.kind == PointerKind::Release;
        const bool ends_drag = moved && event.kind == PointerKind::Release;
        if (pressed || ends_drag || (scrolled && event.kind != PointerKind::Scroll)) {
            break;
        }
        moved |= event.kind == PointerKind::Move;
        if (button) {
            held_[static_cast<int>(event.button)] = event.kind == PointerKind::Press;
            pressed = true;
        }
        scrolled |= event.kind == PointerKind::Scroll;
        cursor_ = event.position;
        frame.pointer.push_back(event);
        pointer_.pop_front();
    }
    while (!keys_.empty()) {
        const auto same = [&](const KeyEvent& other) { return other.key == keys_.front().key; };
        if (std::any_of(frame.keys.begin(), frame.keys.end(), same)) {
            break;
        }
        frame.keys.push_back(keys_.front());
        keys_.pop_front();
    }
    if (pointer_.empty()) {
        cursor_ = latest_;
    }
    frame.any |= !frame.pointer.empty() || !frame.keys.empty();
    frame.cursor = cursor_;
    return frame;
}

}  // namespace ui
