#include "ui/viewer/view_state.h"

#include <tuple>

namespace ui {

PictureRequest ViewState::request(glm::ivec2 size) const {
    PictureRequest request;
    request.camera = camera;
    request.size = size;
    request.style = style_info().name;
    const npr::Parameters& values = style_parameters();
    for (std::size_t i = 0; i < values.list().size(); ++i) {
        const npr::Parameter& parameter = values.list()[i];
        if (const npr::Value& value = values.at(static_cast<int>(i)); value != parameter.initial) {
            request.settings.emplace_back(parameter.name, npr::text(parameter, value));
        }
    }
    request.scheme = color_scheme().name;
    request.layers = layers;
    request.samples = samples;
    request.engine = engine;
    return request;
}

ViewState view_state_of(const PictureRequest& request) {
    check_picture(request);
    ViewState state;
    state.camera = request.camera;
    for (const npr::StyleInfo& info : npr::styles()) {
        state.parameters.emplace_back(info.parameters());
    }
    state.style = static_cast<std::size_t>(npr::find_style(request.style) - npr::styles().data());
    for (const auto& [name, value] : request.settings) {
        state.style_parameters().set(name, value);
    }
    state.scheme = static_cast<std::size_t>(npr::find_color_scheme(request.scheme) - npr::color_schemes().data());
    state.layers = request.layers;
    state.engine = request.engine;
    state.samples = static_cast<int>(npr::sample_offsets(request.samples).size());
    return state;
}

bool same_picture(const PictureRequest& a, const PictureRequest& b) {
    const auto all = [](const PictureRequest& r) {
        return std::tie(r.camera, r.size, r.style, r.settings, r.scheme, r.layers, r.samples, r.transparent_background,
                        r.engine);
    };
    return all(a) == all(b);
}

}  // namespace ui
