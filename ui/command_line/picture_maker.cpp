#include "ui/command_line/picture_maker.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "npr/styles/radiograph.h"
#include "ui/command_line/standard_streams.h"
#include "ui/command_line/thin_places.h"
#include "ui/pipeline/mesh/outline.h"
#include "ui/pipeline/picture/center_lines.h"
#include "ui/pipeline/picture/flat_lines.h"
#include "ui/pipeline/picture/legend.h"
#include "ui/pipeline/picture/plan.h"
#include "ui/pipeline/picture/radiograph.h"
#include "ui/pipeline/picture/thickness_map.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

template <typename Value>
Value setting(const npr::Picture& picture, std::string_view name) {
    return std::get<Value>(picture.parameters.at(picture.parameters.find(name).value()));
}

bool draws_flat_lines(const Model& model, const npr::Picture& picture) {
    return extent_of(model) == Extent::Flat && is_flat_picture(model, picture) && picture.samples == 1;
}

}  // namespace

void PictureMaker::set_full_tone(const PictureSubject& of, npr::Picture& picture, Renderer& renderer) const {
    if (!is_radiograph(picture) || setting<float>(picture, "range") > 0) {
        return;
    }
    const double most = most_thickness(renderer, of.shown, PictureRequest(picture), limit_.token());
    if (most > 0) {
        picture.parameters.set("range", static_cast<float>(round_up(most)));
    }
}

PictureRequest PictureMaker::request_of(const PictureSubject& of, const npr::Picture& picture) {
    return PictureRequest(draws_flat_lines(of.model, picture) ? flat_picture(picture, false) : picture);
}

/// The picture without colors, tinted by what was measured.
base::Image PictureMaker::thickness_image(const PictureSubject& of, PictureRequest request, Renderer& renderer) {
    if (extent_of(of.model) == Extent::Flat) {
        throw UsageError("--thickness: an outline in the plane has no walls; extrude it first");
    }
    if (!request.reveal.empty()) {
        throw UsageError("--thickness measures what the model hides and what it does not; leave --reveal out");
    }
    const glm::vec3 background = request.scheme.background;
    request.scheme.face = request.scheme.cut = glm::vec3(1);
    const auto plain = without_colors(of.shown);
    base::Image image = renderer.render(*plain, request, limit_.token());
    const ThicknessMap map = thickness_map(renderer, of.model, *plain, request, *options_.thickness, limit_.token());
    draw_thickness(image, map, background);
    if (!options_.quiet) {
        language_.progress().say("");
        say(printable(thin_places_text(of.model, *language_.evaluation().sources, map)));
    }
    return image;
}

base::Image PictureMaker::plan_image(const PictureSubject& of, const PictureRequest& request, Renderer& renderer) {
    return draw_plan(options_.plan, request, of.box, [&](const PictureRequest& view) {
        base::Image image = renderer.render(of.shown, view, limit_.token());
        draw_centers(of, image, view);
        return image;
    });
}

base::Image PictureMaker::image(const PictureSubject& of, npr::Picture& picture, Renderer& renderer) {
    set_full_tone(of, picture, renderer);
    PictureRequest request = request_of(of, picture);
    for (npr::PartStyle& style : styles_of_glyphs(of.model.scene, depicting_.styles())) {
        request.part_styles.push_back(std::move(style));
    }
    const std::shared_ptr<const Model> annotated = depicting_.annotated(of.shown, picture, renderer);
    const Model& drawn = annotated ? *annotated : of.shown;
    base::Image image = options_.thickness      ? thickness_image(of, request, renderer)
                        : options_.plan.empty() ? renderer.render(drawn, request, limit_.token())
                                                : plan_image(of, request, renderer);
    if (draws_flat_lines(of.model, picture) && options_.plan.empty()) {
        draw_flat_lines(image, *builder_.outline(of.model, limit_.token()), picture.camera, picture.scheme.edge_2d);
    }
    if (is_radiograph(picture) && setting<bool>(picture, "legend")) {
        const auto colors = setting<int>(picture, "colors");
        draw_legend(image, setting<float>(picture, "range"),
                    [&](float share) { return npr::radiograph_tone(colors, share); });
    }
    if (options_.plan.empty()) {
        draw_centers(of, image, picture);
    }
    if (options_.marks.any()) {
        draw_marks(of, image, picture, renderer);
    }
    if (const std::string& fallback = renderer.statistics().walk.fallback; !fallback.empty()) {
        language_.messages().warn(fmt::format("lists-cpu has drawn instead of the engine meant: {}", fallback));
    }
    return image;
}

void PictureMaker::draw_centers(const PictureSubject& of, base::Image& image, const npr::Picture& picture) const {
    if (options_.marks.centers) {
        const csg::Box& box = of.shown.geometry.box;
        draw_center_lines(image, center_lines(of.shown), picture,
                          base::View(picture.camera, picture.size, box.lo, box.hi));
    }
}

void PictureMaker::draw_marks(const PictureSubject& of, base::Image& image, const npr::Picture& picture,
                              Renderer& renderer) const {
    const csg::solid::Geometry& geometry = of.shown.geometry;
    const base::View view(picture.camera, picture.size, geometry.box.lo, geometry.box.hi);
    MarkColors colors;
    const glm::vec3& b = picture.scheme.background;
    colors.axes = glm::vec3(b.r + b.g + b.b < 1.5F ? 1.0F : 0.0F);
    const auto first = of.shown.empty() ? nullptr : renderer.first_layer(of.shown, view);
    draw_view_marks(image, options_.marks, colors, view, geometry, first ? *first : layers::HostStack{});
}

}  // namespace ui
