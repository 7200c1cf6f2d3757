// The view and the picture that it asks for.
#include "ui/viewer/view_state.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ui {
namespace {

TEST(ViewState, ARequestComesBackAsItWas) {
    PictureRequest request;
    request.size = {320, 200};
    request.camera.distance = 7;
    request.style = "blueprint";
    request.settings = {{"width", "2.5"}, {"ground", "white"}};
    request.scheme = "Sunset";
    request.layers = 3;
    request.samples = 8;
    request.engine = goldfeather::EngineKind::Lists;
    const ViewState state = view_state_of(request);
    EXPECT_EQ(state.style_info().name, "blueprint");
    EXPECT_EQ(state.color_scheme().name, "Sunset");
    EXPECT_TRUE(same_picture(state.request(request.size), request));
}

TEST(ViewState, DefaultsAreNotSettings) {
    PictureRequest request;
    request.style = "blueprint";
    EXPECT_TRUE(view_state_of(request).request({10, 10}).settings.empty());
}

TEST(ViewState, EachStyleKeepsItsParameters) {
    PictureRequest request;
    request.style = "blueprint";
    request.settings = {{"width", "2.5"}};
    ViewState state = view_state_of(request);
    const std::size_t blueprint = state.style;
    state.style = 0;
    EXPECT_TRUE(state.request({10, 10}).settings.empty());
    state.style = blueprint;
    EXPECT_EQ(state.request({10, 10}).settings.size(), 1U);
}

TEST(ViewState, WhatDoesNotExistIsRefused) {
    PictureRequest request;
    request.style = "bluprint";
    EXPECT_THROW((void)view_state_of(request), std::runtime_error);
    request.style = "blueprint";
    request.settings = {{"width", "wide"}};
    EXPECT_THROW((void)view_state_of(request), std::runtime_error);
    request.settings.clear();
    request.scheme = "Cornfeld";
    EXPECT_THROW((void)view_state_of(request), std::runtime_error);
}

TEST(ViewState, EveryPartOfARequestCounts) {
    const PictureRequest a;
    const auto differs = [&](auto&& change) {
        PictureRequest b = a;
        change(b);
        return !same_picture(a, b);
    };
    EXPECT_TRUE(same_picture(a, a));
    EXPECT_TRUE(differs([](auto& b) { b.camera.rotation.z += 1e-9; }));
    EXPECT_TRUE(differs([](auto& b) { b.camera.projection = base::Projection::Orthographic; }));
    EXPECT_TRUE(differs([](auto& b) { b.size.y += 1; }));
    EXPECT_TRUE(differs([](auto& b) { b.style = "edges"; }));
    EXPECT_TRUE(differs([](auto& b) { b.settings.emplace_back("a", "b"); }));
    EXPECT_TRUE(differs([](auto& b) { b.scheme = "Sunset"; }));
    EXPECT_TRUE(differs([](auto& b) { b.layers = 0; }));
    EXPECT_TRUE(differs([](auto& b) { b.samples = 1; }));
    EXPECT_TRUE(differs([](auto& b) { b.transparent_background = true; }));
    EXPECT_TRUE(differs([](auto& b) { b.engine = goldfeather::EngineKind::ListsCpu; }));
}

}  // namespace
}  // namespace ui
