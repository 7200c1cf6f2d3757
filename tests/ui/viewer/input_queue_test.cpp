#include "ui/viewer/input_queue.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

PointerEvent at(PointerKind kind, double x, Button button = Button::None) {
    PointerEvent event;
    event.kind = kind;
    event.position = {x, 0};
    event.button = button;
    return event;
}

Input input(std::vector<PointerEvent> pointer, std::vector<KeyEvent> keys = {}) {
    Input input;
    input.pointer = std::move(pointer);
    input.keys = std::move(keys);
    input.cursor = input.pointer.empty() ? glm::dvec2(0) : input.pointer.back().position;
    input.any = true;
    return input;
}

TEST(InputQueue, AClickWithinAFrameIsSeenDownAndUp) {
    InputQueue queue;
    queue.add(input({at(PointerKind::Move, 5), at(PointerKind::Press, 5, Button::Left),
                     at(PointerKind::Release, 5, Button::Left), at(PointerKind::Move, 90)}));
    Input frame = queue.next();
    EXPECT_EQ(frame.pointer.size(), 2U);
    EXPECT_TRUE(queue.held(Button::Left));
    EXPECT_EQ(frame.cursor.x, 5) << "not where the pointer has gone since";
    EXPECT_FALSE(queue.empty());
    frame = queue.next();
    EXPECT_FALSE(queue.held(Button::Left));
    EXPECT_EQ(frame.cursor.x, 5);
    frame = queue.next();
    EXPECT_EQ(frame.cursor.x, 90);
    EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, NothingIsLostAndNothingChangesPlaces) {
    InputQueue queue;
    std::vector<PointerEvent> events;
    for (int i = 0; i < 200; ++i) {
        events.push_back(at(PointerKind::Move, i));
        events.push_back(at(i % 2 == 0 ? PointerKind::Press : PointerKind::Release, i, Button::Left));
        events.push_back(at(PointerKind::Scroll, i));
    }
    queue.add(input(events));
    std::size_t seen = 0, changes = 0;
    for (bool held = false; !queue.empty();) {
        for (const PointerEvent& event : queue.next().pointer) {
            ASSERT_LT(seen, events.size());
            EXPECT_EQ(event.kind, events[seen].kind);
            EXPECT_EQ(event.position, events[seen].position);
            ++seen;
        }
        changes += queue.held(Button::Left) != held ? 1 : 0;
        held = queue.held(Button::Left);
    }
    EXPECT_EQ(seen, events.size());
    EXPECT_EQ(changes, 200U) << "each change of the button is a frame's";
}

TEST(InputQueue, ADragIsSeenWhereItEndsBeforeItEnds) {
    InputQueue queue;
    queue.add(input({at(PointerKind::Press, 5, Button::Left), at(PointerKind::Move, 50), at(PointerKind::Move, 90),
                     at(PointerKind::Release, 90, Button::Left)}));
    EXPECT_EQ(queue.next().cursor.x, 5);
    EXPECT_EQ(queue.next().cursor.x, 90);
    EXPECT_TRUE(queue.held(Button::Left));
    (void)queue.next();
    EXPECT_FALSE(queue.held(Button::Left));
}

TEST(InputQueue, MotionIsOneFramesWhateverItsLength) {
    InputQueue queue;
    queue.add(input({at(PointerKind::Move, 1), at(PointerKind::Move, 2), at(PointerKind::Move, 3)}));
    EXPECT_EQ(queue.next().pointer.size(), 3U);
    EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, AKeyPressedTwiceIsSeenTwice) {
    InputQueue queue;
    queue.add(input({}, {{{65, 0}, 65}, {{66, 0}, 66}, {{65, 0}, 65}}));
    EXPECT_EQ(queue.next().keys.size(), 2U);
    EXPECT_EQ(queue.next().keys.size(), 1U);
    EXPECT_TRUE(queue.empty());
    queue.add(Input{});
    EXPECT_TRUE(queue.empty()) << "nothing has happened";
}

}  // namespace
}  // namespace ui
