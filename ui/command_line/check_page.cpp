#include "ui/command_line/check_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "npr/style.h"
#include "ui/command_line/html.h"
#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/inspection/finding_text.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/sections.h"

namespace ui {

namespace {

constexpr glm::ivec2 kSize{360, 240};
constexpr std::size_t kMostPictures = 100;

constexpr const char* kHead = R"(<style>
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 70em; color: #222; }
.finding { display: flex; gap: 1.5em; align-items: start; margin-bottom: 1.5em; border-top: 1px solid #ddd; padding-top: 1em; }
pre { font-size: 13px; white-space: pre-wrap; color: #444; } h2 { font-size: 17px; margin: 0; }
</style>
)";

/// A pixel of the marks.
void dot(base::Image& image, double x, double y) {
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    if (column < 0 || row < 0 || column >= image.width || row >= image.height) {
        return;
    }
    const std::size_t at =
        4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column));
    constexpr std::uint8_t kRed[]{208, 0, 32, 255};
    std::copy(std::begin(kRed), std::end(kRed), image.rgba.begin() + static_cast<std::ptrdiff_t>(at));
}

/// In pixels from the upper left corner.
glm::dvec2 on_picture(const base::View& view, const glm::dvec3& point) {
    const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(point, 1);
    return (glm::dvec2(clip.x, -clip.y) / clip.w * 0.5 + 0.5) * glm::dvec2(view.size());
}

void draw_mark(base::Image& image, const base::View& view, const Finding& finding) {
    const glm::dvec2 from = on_picture(view, finding.point);
    const double length = finding.direction && finding.value ? *finding.value : 0;
    const glm::dvec2 to = length > 0 ? on_picture(view, finding.point + length * *finding.direction) : from;
    const glm::dvec2 middle = 0.5 * (from + to);
    const double radius = 0.5 * glm::length(to - from) + 10;
    for (int i = 0; i < 720; ++i) {
        const double angle = glm::radians(0.5 * i);
        for (const double r : {radius, radius + 1}) {
            dot(image, middle.x + r * std::cos(angle), middle.y + r * std::sin(angle));
        }
    }
    const int steps = static_cast<int>(glm::length(to - from)) * 2 + 1;
    for (int i = 0; i <= steps; ++i) {
        const glm::dvec2 at = from + (to - from) * (static_cast<double>(i) / steps);
        dot(image, at.x, at.y);
        dot(image, at.x + 1, at.y);
    }
}

/// An orthographic camera that looks at the point from the direction, `height` world units high.
base::Camera camera_at(const glm::dvec3& point, const glm::dvec3& from, double height) {
    base::Camera camera = base::camera_between(point + from, point);
    camera.projection = base::Projection::Orthographic;
    camera.distance = 0.5 * height / std::tan(glm::radians(0.5 * camera.fov));
    return camera;
}

class Pictures {
  public:
    Pictures(const std::shared_ptr<const Model>& model, const std::stop_token& stop)
        : model_(model), stop_(stop), renderer_({}, Painter::Cpu) {}

    base::Image draw(const Finding& finding) {
        PictureRequest request;
        request.size = kSize;
        const double diagonal = model_->box.diagonal();
        const bool measured = finding.direction && finding.value && finding.kind != FindingKind::Size;
        glm::dvec3 from = glm::normalize(glm::dvec3(1, -1.6, finding.kind == FindingKind::Overhang ? -1.2 : 1.2));
        double height = finding.kind == FindingKind::Size ? 1.1 * diagonal : 0.35 * diagonal;
        if (finding.kind == FindingKind::NoEffect) {  // Perhaps far from the model.
            height = diagonal + 2.2 * glm::length(finding.point - model_->box.center());
        }
        if (measured) {
            const glm::dvec3 up = std::abs(finding.direction->z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
            const glm::dvec3 across = glm::normalize(glm::cross(*finding.direction, up));
            const glm::dvec3 cut = glm::dot(across, from) < 0 ? -across : across;
            request.sections.cuts.push_back(
                {npr::PlaneSection{cut, glm::dot(cut, finding.point), npr::PlaneSection::Away::Beyond}, ""});
            from = glm::normalize(cut + 0.25 * up);
            height = std::clamp(12 * *finding.value, 0.05 * diagonal, diagonal);
        }
        glm::dvec3 middle = finding.point;
        if (measured) {
            middle += 0.5 * *finding.value * *finding.direction;
        }
        request.camera = camera_at(middle, from, height);
        const Model& cut = sectioned_.cut(model_, request.sections);
        if (!sectioned_.change().empty()) {
            renderer_.update(cut, sectioned_.change());  // The plane of the finding before has moved.
        }
        base::Image image = renderer_.render(cut, request, stop_);
        draw_mark(image, base::View(request.camera, kSize, model_->box.lo, model_->box.hi), finding);
        return image;
    }

  private:
    std::shared_ptr<const Model> model_;
    const std::stop_token& stop_;
    Renderer renderer_;
    SectionedModel sectioned_;
};

}  // namespace

std::string check_page(const CheckReport& report, const std::shared_ptr<const Model>& model,
                       const std::stop_token& stop) {
    const std::size_t count = report.result.findings.size();
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n{1}</head><body>\n"
        "<h1>{0}</h1>\n<p>{2}; faces looked at every {3:.3g} mm.</p>\n",
        html(report.input), kHead, count == 1 ? "1 finding" : fmt::format("{} findings", count), report.result.spacing);
    Pictures pictures(model, stop);
    for (std::size_t i = 0; i < count; ++i) {
        const Finding& finding = report.result.findings[i];
        const glm::dvec3& p = finding.point;
        page += fmt::format(
            "<div class=\"finding\">{}<div><h2>{}</h2><p>at [{:.6g}, {:.6g}, {:.6g}]</p><pre>{}</pre></div></div>\n",
            i < kMostPictures ? picture(pictures.draw(finding), "the place") : "",
            html(headline(report.model, finding)), p.x, p.y, p.z,
            html(calls_text(report.model, report.sources, steps_to(report.model, finding.occurrence))));
    }
    return page + "</body></html>\n";
}

}  // namespace ui
