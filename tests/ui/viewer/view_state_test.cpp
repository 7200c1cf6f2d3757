// The view and the picture that it asks for.
#include "ui/viewer/view_state.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

PictureRequest blueprint() {
    PictureRequest request;
    request.draw_as(*npr::find_style("blueprint"));
    request.parameters.set("width", 2.5F);
    request.parameters.set("ground", 1);
    return request;
}

TEST(ViewState, ARequestComesBackAsItWas) {
    PictureRequest request = blueprint();
    request.size = {320, 200};
    request.camera.distance = 7;
    request.scheme = *npr::find_color_scheme("Sunset");
    request.layers = 3;
    request.samples = 8;
    request.engine = goldfeather::find_engine("lists");
    const ViewState state(request);
    EXPECT_EQ(npr::styles()[state.style()].name, "blueprint");
    EXPECT_EQ(state.request(request.size), request);
}

TEST(ViewState, ColorsKeepAllTheirBits) {
    PictureRequest request;
    request.draw_as(*npr::find_style("edges"));
    const glm::vec3 color(0.1234567F, 1 / 3.0F, 0.9999F);
    request.parameters.set("edge-color", color);
    const PictureRequest back = ViewState(request).request({10, 10});
    EXPECT_EQ(std::get<glm::vec3>(back.parameters.at(*back.parameters.find("edge-color"))), color);
}

TEST(ViewState, AWindowHasABackground) {
    PictureRequest request;
    request.transparent_background = true;
    EXPECT_FALSE(ViewState(request).request({10, 10}).transparent_background);
}

TEST(ViewState, EachStyleKeepsItsParameters) {
    ViewState state(blueprint());
    const std::size_t style = state.style();
    state.show_style(1);
    EXPECT_EQ(state.picture.style, &npr::styles()[1]);
    EXPECT_EQ(state.picture.parameters, npr::Parameters(npr::styles()[1].parameters));
    state.show_style(style);
    EXPECT_EQ(state.picture, blueprint());
    state.show_style(style);
    EXPECT_EQ(state.picture, blueprint()) << "shown again";
    state.reset_parameters();
    EXPECT_EQ(state.picture.parameters, npr::Parameters(state.picture.style->parameters));
}

TEST(PictureRequest, EveryPartCounts) {
    const PictureRequest a;
    const auto differs = [&](auto&& change) {
        PictureRequest b = a;
        change(b);
        return !(a == b);
    };
    EXPECT_EQ(a, a);
    EXPECT_TRUE(differs([](auto& b) { b.camera.rotation.z += 1e-9; }));
    EXPECT_TRUE(differs([](auto& b) { b.camera.projection = base::Projection::Orthographic; }));
    EXPECT_TRUE(differs([](auto& b) { b.size.y += 1; }));
    EXPECT_TRUE(differs([](auto& b) { b.draw_as(*npr::find_style("edges")); }));
    EXPECT_TRUE(differs([](auto& b) { b.scheme = *npr::find_color_scheme("Sunset"); }));
    EXPECT_TRUE(differs([](auto& b) { b.layers = 0; }));
    EXPECT_TRUE(differs([](auto& b) { b.samples = 1; }));
    EXPECT_TRUE(differs([](auto& b) { b.transparent_background = true; }));
    EXPECT_TRUE(differs([](auto& b) { b.engine = goldfeather::find_engine("lists-cpu"); }));
    PictureRequest other = blueprint();
    EXPECT_EQ(other, blueprint());
    other.parameters.set("width", 2.25F);
    EXPECT_NE(other, blueprint());
}

}  // namespace
}  // namespace ui
