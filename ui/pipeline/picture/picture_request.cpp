#include "ui/pipeline/picture/picture_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

template <typename Named>
[[noreturn]] void throw_unknown(std::string_view what, std::string_view name, std::span<const Named> known) {
    std::vector<std::string> names;
    for (const Named& each : known) {
        names.emplace_back(each.name);
    }
    throw std::runtime_error(fmt::format(
        "no {} \"{}\".{}", what, name, suggestion(name, names, fmt::format(" There are {}.", fmt::join(names, ", ")))));
}

constexpr std::string_view kFlatStyle = "edges";

bool drawn_flat(const PictureRequest& request, bool flat) {
    return flat && request.style == "shaded";
}

const npr::StyleInfo& style_of(const PictureRequest& request) {
    const npr::StyleInfo* info = npr::find_style(request.style);
    if (info == nullptr) {
        throw_unknown("style", request.style, npr::styles());
    }
    return *info;
}

const npr::ColorScheme& scheme_of(const PictureRequest& request) {
    const npr::ColorScheme* scheme = npr::find_color_scheme(request.scheme);
    if (scheme == nullptr) {
        throw_unknown("color scheme", request.scheme, npr::color_schemes());
    }
    return *scheme;
}

npr::Parameters parameters_of(const PictureRequest& request) {
    npr::Parameters parameters(style_of(request).parameters());
    for (const auto& [name, value] : request.settings) {
        try {
            parameters.set(name, value);
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error(fmt::format("style {}: {}", request.style, error.what()));
        }
    }
    return parameters;
}

npr::Parameters flat_parameters(const npr::ColorScheme& scheme, bool lines) {
    const float width = lines ? 2 : 0.25F;  // Those that are none are thin and of the faces' colour.
    npr::Parameters parameters(npr::find_style(kFlatStyle)->parameters());
    const auto set = [&](std::string_view name, const npr::Value& value) {
        parameters.set(parameters.find(name), value);
    };
    set("width", width);
    set("edge-color", lines ? scheme.edge_2d : scheme.face_2d);
    set("light", 0.0F);
    set("inner", 0.0F);
    set("smooth", false);
    return parameters;
}

}  // namespace

bool translucent(const csg::Scene& scene) {
    return std::any_of(scene.parts.begin(), scene.parts.end(),
                       [](const csg::Part& part) { return part.kind != csg::PartKind::Solid; }) ||
           std::any_of(scene.leaves.begin(), scene.leaves.end(),
                       [](const csg::LeafInstance& leaf) { return leaf.color.given() && leaf.color.a < 1; });
}

void check_picture(const PictureRequest& request) {
    (void)CheckedRequest(request);
}

CheckedRequest::CheckedRequest(const PictureRequest& request, bool flat)
    : style(drawn_flat(request, flat) ? *npr::find_style(kFlatStyle) : style_of(request)),
      scheme(scheme_of(request)),
      parameters(drawn_flat(request, flat) ? flat_parameters(scheme, request.flat_lines) : parameters_of(request)) {
    if (drawn_flat(request, flat)) {
        scheme.face = scheme.face_2d;
    }
}

int CheckedRequest::layers(const Model& model, const PictureRequest& request) const {
    return request.layers >= 0 ? request.layers : style.layers(translucent(model.scene));
}

npr::Picture CheckedRequest::picture(const Model& model, const PictureRequest& request,
                                     const std::stop_token& stop) const {
    return {request.camera,
            request.size,
            model.geometry.box.lo,
            model.geometry.box.hi,
            parameters,
            scheme,
            request.transparent_background,
            request.samples,
            stop};
}

}  // namespace ui
