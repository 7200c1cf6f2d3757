// What a click selects, and what the next one.
#include "ui/viewer/selection.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

std::vector<SelectedSurface> surfaces(int count) {
    std::vector<SelectedSurface> all(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        all[static_cast<std::size_t>(i)].title = std::to_string(i);
    }
    return all;
}

TEST(Selection, ClicksAtOnePlaceGoThroughTheLayers) {
    Selection selection;
    EXPECT_TRUE(selection.empty());
    selection.take(surfaces(3), {10, 10});
    EXPECT_EQ(selection.current().title, "0");
    selection.take(surfaces(3), {12, 9});
    EXPECT_EQ(selection.current().title, "1");
    selection.take(surfaces(3), {10, 10});
    selection.take(surfaces(3), {10, 10});
    EXPECT_EQ(selection.current().title, "0") << "and from the last to the first";
    selection.take(surfaces(3), {10, 10});
    selection.take(surfaces(3), {40, 10});
    EXPECT_EQ(selection.current().title, "0") << "another place";
    selection.take({}, {10, 10});
    EXPECT_TRUE(selection.empty());
}

TEST(Selection, StepsEndNowhere) {
    Selection selection;
    selection.step(1);
    selection.take(surfaces(3), {0, 0});
    selection.step(-1);
    EXPECT_EQ(selection.index(), 2U);
    selection.step(1);
    EXPECT_EQ(selection.index(), 0U);
}

}  // namespace
}  // namespace ui
