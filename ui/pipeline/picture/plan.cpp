#include "ui/pipeline/picture/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "ui/pipeline/picture/legend.h"

namespace ui {
namespace {

/// How a view looks at the model, and its place in the grid of two by two.
struct Look {
    std::string_view name;
    PlanView view;
    glm::dvec3 rotation;
    int column, row;
};
const double kIsometric = glm::degrees(std::atan(std::sqrt(2.0)));
const std::array kLooks{Look{"top", PlanView::Top, {0, 0, 0}, 0, 0}, Look{"front", PlanView::Front, {90, 0, 0}, 0, 1},
                        Look{"side", PlanView::Side, {90, 0, 90}, 1, 1},
                        Look{"iso", PlanView::Iso, {kIsometric, 0, 45}, 1, 0}};

const Look& look_of(PlanView view) {
    return *std::find_if(kLooks.begin(), kLooks.end(), [&](const Look& l) { return l.view == view; });
}

/// Of a turned box: width and height in the picture.
glm::dvec2 extent(const csg::Box& box, const glm::dvec3& rotation) {
    base::Camera camera;
    camera.rotation = rotation;
    const glm::dmat4 turn = camera.eye_from_world();
    const glm::dvec3 size = box.hi - box.lo;
    glm::dvec2 sum(0);
    for (int axis = 0; axis < 3; ++axis) {
        sum += glm::abs(glm::dvec2(turn[axis])) * size[axis];
    }
    return sum;
}

/// Two rows or columns, in pixels: what the views need and half of what is left each.
std::array<int, 2> divided(int whole, const std::array<double, 2>& needed) {
    if (needed[0] <= 0 || needed[1] <= 0) {
        return {needed[0] > 0 ? whole : 0, needed[0] > 0 ? 0 : whole};
    }
    const int first = static_cast<int>(std::lround(0.5 * (whole + needed[0] - needed[1])));
    return {first, whole - first};
}

/// Dashed, one pixel wide: along x or y, between two places.
void dashed_line(base::Image& image, bool across, int at, int from, int to, const glm::vec3& ink) {
    constexpr int kDash = 6, kPeriod = 9;
    const int last = across ? image.width : image.height, beside = across ? image.height : image.width;
    for (int i = std::max(from, 0); i < std::min(to, last) && at >= 0 && at < beside; ++i) {
        if ((i - from) % kPeriod >= kDash) {
            continue;
        }
        const int x = across ? i : at, y = across ? at : i;
        std::uint8_t* pixel = &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                               static_cast<std::size_t>(x))];
        const float covered = static_cast<float>(pixel[3]) / 255;
        for (int c = 0; c < 3; ++c) {
            const float ground = static_cast<float>(pixel[c]);
            pixel[c] = static_cast<std::uint8_t>(std::lround(glm::mix(255 * ink[c], ground, 0.55F * covered)));
        }
        pixel[3] = 255;
    }
}

const PlanCell* cell_of(const Plan& plan, PlanView view) {
    const auto found =
        std::find_if(plan.cells.begin(), plan.cells.end(), [&](const PlanCell& c) { return c.view == view; });
    return found == plan.cells.end() ? nullptr : &*found;
}

/// Lines between what two views have in common, from where the one ends to where the other does.
void align(base::Image& image, const Plan& plan, const csg::Box& box, const glm::vec3& ink) {
    const PlanCell* front = cell_of(plan, PlanView::Front);
    if (front == nullptr) {
        return;
    }
    const glm::dvec3 half = 0.5 * plan.pixels_per_unit * (box.hi - box.lo);
    const glm::dvec2 middle = front->middle;
    constexpr double kApart = 5;  // Pixels from the views.
    const auto pixel = [](double at) { return static_cast<int>(std::floor(at)); };
    for (const double side : {-1.0, 1.0}) {
        if (const PlanCell* top = cell_of(plan, PlanView::Top)) {
            const double above = top->middle.y + half.y;
            dashed_line(image, false, pixel(middle.x + side * half.x), pixel(above + kApart),
                        pixel(middle.y - half.z - kApart), ink);
        }
        if (const PlanCell* right = cell_of(plan, PlanView::Side)) {
            const double beside = right->middle.x - half.y;
            dashed_line(image, true, pixel(middle.y + side * half.z), pixel(middle.x + half.x + kApart),
                        pixel(beside - kApart), ink);
        }
    }
}

void put(base::Image& image, const base::Image& cell, glm::ivec2 corner) {
    for (int y = 0; y < cell.height; ++y) {
        const std::size_t row = static_cast<std::size_t>(corner.y + y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(corner.x);
        std::copy_n(cell.pixel(0, y), 4 * static_cast<std::size_t>(cell.width), &image.rgba[4 * row]);
    }
}

}  // namespace

Plan plan_of(const std::vector<PlanView>& views, glm::ivec2 size, const csg::Box& box, double margin) {
    std::array<double, 2> widths{}, heights{};
    for (const PlanView view : views) {
        const Look& look = look_of(view);
        const glm::dvec2 need = glm::max(extent(box, look.rotation), glm::dvec2(1e-9));
        double& width = widths[static_cast<std::size_t>(look.column)];
        double& height = heights[static_cast<std::size_t>(look.row)];
        width = std::max(width, need.x);
        height = std::max(height, need.y);
    }
    const auto count = [](const std::array<double, 2>& all) { return (all[0] > 0 ? 1 : 0) + (all[1] > 0 ? 1 : 0); };
    const int strip = bar_strip(size);
    size.y -= strip;
    Plan plan;
    plan.pixels_per_unit = std::min(size.x * (1 - 2 * margin * count(widths)) / (widths[0] + widths[1]),
                                    size.y * (1 - 2 * margin * count(heights)) / (heights[0] + heights[1]));
    for (std::size_t i = 0; i < 2; ++i) {
        widths[i] *= plan.pixels_per_unit;
        heights[i] *= plan.pixels_per_unit;
    }
    const std::array<int, 2> columns = divided(size.x, widths), rows = divided(size.y, heights);
    for (const PlanView view : views) {
        const Look& look = look_of(view);
        PlanCell cell;
        cell.view = view;
        cell.corner = {look.column == 0 ? 0 : columns[0], look.row == 0 ? 0 : rows[0]};
        cell.size = {columns[static_cast<std::size_t>(look.column)], rows[static_cast<std::size_t>(look.row)]};
        cell.middle = glm::dvec2(cell.corner) + 0.5 * glm::dvec2(cell.size);
        const bool lowest = cell.corner.y + cell.size.y == size.y;
        const double lower = lowest ? strip : 0;
        cell.size.y += static_cast<int>(lower);
        cell.camera.projection = base::Projection::Orthographic;
        cell.camera.rotation = look.rotation;
        const glm::dvec3 up = glm::transpose(cell.camera.eye_from_world())[1];
        cell.camera.target = box.center() - 0.5 * lower / plan.pixels_per_unit * up;
        const double half_height = 0.5 * cell.size.y / plan.pixels_per_unit;
        cell.camera.distance = half_height / std::tan(glm::radians(cell.camera.fov) / 2);
        plan.cells.push_back(cell);
    }
    return plan;
}

base::Image draw_plan(const std::vector<PlanView>& views, const PictureRequest& request, const csg::Box& box,
                      const std::function<base::Image(const PictureRequest&)>& render) {
    const Plan plan = plan_of(views, request.size, box);
    base::Image image{request.size.x, request.size.y, {}};
    image.rgba.resize(4 * static_cast<std::size_t>(request.size.x) * static_cast<std::size_t>(request.size.y));
    const auto draw = [&](glm::ivec2 corner, glm::ivec2 size, const base::Camera& camera) {
        PictureRequest each = request;
        each.size = size;
        each.camera = camera;
        put(image, render(each), corner);
    };
    std::array<bool, 4> drawn{};
    for (const PlanCell& cell : plan.cells) {
        draw(cell.corner, cell.size, cell.camera);
        drawn[static_cast<std::size_t>(cell.view)] = true;
    }
    // A corner without a view is ground, as far from the model as it may be.
    for (const Look& look : kLooks) {
        const PlanCell* beside = nullptr;
        const PlanCell* above = nullptr;
        for (const PlanCell& cell : plan.cells) {
            const Look& other = look_of(cell.view);
            beside = other.row == look.row ? &cell : beside;
            above = other.column == look.column ? &cell : above;
        }
        if (!drawn[static_cast<std::size_t>(look.view)] && beside != nullptr && above != nullptr) {
            base::Camera away = beside->camera;
            away.target += 1e3 * (glm::length(box.hi - box.lo) + 1) * glm::dvec3(1, 1, 1);
            draw({above->corner.x, beside->corner.y}, {above->size.x, beside->size.y}, away);
        }
    }
    const std::uint8_t* corner = image.pixel(0, image.height - 1);
    const bool dark = corner[3] > 127 && corner[0] + corner[1] + corner[2] < 384;
    const glm::vec3 ink(dark ? 1.0F : 0.0F);
    align(image, plan, box, ink);
    draw_scale_bar(image, plan.pixels_per_unit, ink);
    return image;
}

std::vector<PlanView> read_plan(std::string_view text) {
    std::vector<PlanView> views;
    while (true) {
        const std::size_t end = std::min(text.find(','), text.size());
        const std::string_view name = text.substr(0, end);
        const auto look = std::find_if(kLooks.begin(), kLooks.end(), [&](const Look& l) { return l.name == name; });
        if (look == kLooks.end()) {
            throw std::invalid_argument(
                fmt::format("\"{}\" is no view: top, front, side or iso, several with commas between", name));
        }
        if (std::find(views.begin(), views.end(), look->view) != views.end()) {
            throw std::invalid_argument(fmt::format("\"{}\" is there twice", name));
        }
        views.push_back(look->view);
        if (end == text.size()) {
            return views;
        }
        text.remove_prefix(end + 1);
    }
}

}  // namespace ui
