#include "ui/pipeline/picture/center_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "csg/solid/surface_form.h"

namespace ui {
namespace {

constexpr double kBeyond = 2;   ///< Millimeters.
constexpr double kSame = 1e-6;  ///< Of the model's size: axes no farther apart are one.
constexpr int kCorners = 6;     ///< Circles of so many sides are asked to have corners.

/// Are the circles below a leaf its outlines, and not corners of something else?
bool circles_are_whole(const csg::Tree& tree, csg::NodeId leaf) {
    std::vector<csg::NodeId> open{leaf};
    while (!open.empty()) {
        const csg::NodeId id = open.back();
        open.pop_back();
        const csg::Operation operation = tree.node(id).operation;
        if (operation == csg::Operation::Intersection || (operation == csg::Operation::Mesh && id != leaf)) {
            return false;
        }
        if (operation == csg::Operation::Mesh) {
            const csg::MeshOperation& mesh = tree.mesh(id);
            const auto* turned = std::get_if<csg::RotateExtrude>(&mesh);
            if (!std::holds_alternative<csg::LinearExtrude>(mesh) &&
                (turned == nullptr || std::abs(turned->angle) < 360)) {
                return false;
            }
        }
        const auto children = tree.children(id);
        open.insert(open.end(), children.begin(), children.end());
    }
    return true;
}

/// What a whole turn about z makes has an axis, whatever it is that is turned.
std::optional<csg::solid::RoundShape> turned_shape(const csg::Tree& tree, const csg::LeafInstance& leaf) {
    if (tree.node(leaf.node).operation != csg::Operation::Mesh ||
        !std::holds_alternative<csg::RotateExtrude>(tree.mesh(leaf.node))) {
        return {};
    }
    const glm::dvec3 x(leaf.to_world[0]), y(leaf.to_world[1]), z(leaf.to_world[2]);
    const double least = 1e-9 * glm::dot(x, x);
    if (std::abs(glm::dot(x, y)) > least || std::abs(glm::dot(x, z)) > least || std::abs(glm::dot(y, z)) > least ||
        std::abs(glm::dot(x, x) - glm::dot(y, y)) > least) {
        return {};
    }
    csg::solid::RoundShape shape;
    shape.form.kind = csg::solid::FormKind::Torus;
    shape.form.point = glm::dvec3(leaf.to_world[3]);
    shape.form.direction = glm::normalize(z);
    return shape;
}

/// The stretch of a line within a box, both ends not beyond those given.
bool clip(const csg::Box& box, const glm::dvec3& point, const glm::dvec3& along, double& first, double& last) {
    for (int i = 0; i < 3; ++i) {
        if (std::abs(along[i]) < 1e-12) {
            if (point[i] < box.lo[i] || point[i] > box.hi[i]) {
                return false;
            }
            continue;
        }
        const double a = (box.lo[i] - point[i]) / along[i], b = (box.hi[i] - point[i]) / along[i];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first < last;
}

class Collector {
  public:
    explicit Collector(const Model& model) : model_(model), size_(glm::length(model.box.hi - model.box.lo)) {}

    void add_leaf(csg::LeafId id, const csg::Box& part) {
        const csg::LeafInstance& leaf = model_.scene.leaves[id];
        if (leaf.node == csg::kNoNode || !circles_are_whole(*model_.tree, leaf.node)) {
            return;
        }
        if (const auto turned = turned_shape(*model_.tree, leaf)) {
            add(*turned, model_.geometry.leaves[id].points, part);
            return;
        }
        std::string uneven;
        for (const csg::solid::RoundShape& shape : csg::solid::round_shapes(*model_.tree, leaf, uneven)) {
            if (shape.form.segments > kCorners) {
                add(shape, model_.geometry.leaves[id].points, part);
            }
        }
    }
    [[nodiscard]] std::vector<CenterLine> take() { return std::move(lines_); }

  private:
    void add(const csg::solid::RoundShape& shape, const std::vector<glm::dvec3>& points, const csg::Box& part) {
        using csg::solid::FormKind;
        const csg::solid::SurfaceForm& form = shape.form;
        if (form.kind == FormKind::Sphere) {
            put({form.point, form.point, form.radius});
            return;
        }
        double first = std::numeric_limits<double>::infinity(), last = -first, radius = 0;
        for (const glm::dvec3& p : points) {
            const double along = glm::dot(p - form.point, form.direction);
            first = std::min(first, along);
            last = std::max(last, along);
            radius = std::max(radius, glm::distance(p, form.point + along * form.direction));
        }
        if (clip(part, form.point, form.direction, first, last)) {
            put({form.point + first * form.direction, form.point + last * form.direction,
                 form.kind == FormKind::Cylinder ? form.radius : radius});
        }
    }

    /// Lines on one axis that touch are one.
    void put(CenterLine line) {
        for (std::size_t i = 0; i < lines_.size();) {
            if (joins(line, lines_[i])) {
                lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(i));
                i = 0;
            } else {
                ++i;
            }
        }
        lines_.push_back(line);
    }
    /// Makes `line` both of them where they are on one axis and touch.
    bool joins(CenterLine& line, const CenterLine& other) const {
        const double near = kSame * size_;
        const double length = glm::distance(line.from, line.to), length2 = glm::distance(other.from, other.to);
        if (length == 0 || length2 == 0) {
            if (length != length2 || glm::distance(line.from, other.from) > near) {
                return false;
            }
            line.radius = std::max(line.radius, other.radius);
            return true;
        }
        const glm::dvec3 along = (line.to - line.from) / length;
        double a = glm::dot(other.from - line.from, along), b = glm::dot(other.to - line.from, along);
        if (glm::distance(other.from, line.from + a * along) > near ||
            glm::distance(other.to, line.from + b * along) > near || std::max(a, b) < -near ||
            std::min(a, b) > length + near) {
            return false;
        }
        const glm::dvec3 from = line.from;
        line.from = from + std::min({0.0, a, b}) * along;
        line.to = from + std::max({length, a, b}) * along;
        line.radius = std::max(line.radius, other.radius);
        return true;
    }

    const Model& model_;
    double size_;
    std::vector<CenterLine> lines_;
};

/// Ink of long dashes and dots, whose middle is that of a dash, as wide as `width` pixels.
class Chain {
  public:
    Chain(base::Image& image, double width, std::uint8_t ink) : image_(image), width_(width), ink_(ink) {}

    /// Pixels from the upper left corner.
    void draw(const glm::dvec2& from, const glm::dvec2& to) const {
        const glm::dvec2 way = to - from;
        const double length = glm::length(way);
        if (!(length > 0) || !(length < 1e5)) {
            return;
        }
        const glm::dvec2 along = way / length, across(-along.y, along.x), middle = (from + to) / 2.0;
        const int major = std::abs(way.x) >= std::abs(way.y) ? 0 : 1, minor = 1 - major;
        const int reach = static_cast<int>(std::ceil(width_ / 2 / std::abs(along[major]))) + 1;
        const double least = std::min(from[major], to[major]) - 1, most = std::max(from[major], to[major]) + 1;
        const int end = major == 0 ? image_.width : image_.height;
        for (int i = std::max(static_cast<int>(least), 0); i < std::min(static_cast<int>(most) + 1, end); ++i) {
            const double at = middle[minor] + (i + 0.5 - middle[major]) * way[minor] / way[major];
            for (int j = static_cast<int>(std::floor(at)) - reach; j <= static_cast<int>(std::floor(at)) + reach; ++j) {
                const glm::ivec2 pixel = major == 0 ? glm::ivec2(i, j) : glm::ivec2(j, i);
                const glm::dvec2 p = glm::dvec2(pixel) + 0.5 - middle;
                const double place = glm::dot(p, along);
                const double beside = std::clamp(width_ / 2 + 0.5 - std::abs(glm::dot(p, across)), 0.0, 1.0);
                const double within = std::clamp(length / 2 + 0.5 - std::abs(place), 0.0, 1.0);
                blend(pixel, std::min(beside, 1.0) * within * pattern(place));
            }
        }
    }

  private:
    [[nodiscard]] double pattern(double place) const {
        const double dash = 24 * width_, gap = 3 * width_, dot = std::max(0.5 * width_, 1.0);
        const double period = dash + 2 * gap + dot;
        const double from_dash = std::abs(place - period * std::round(place / period));
        const double from_dot = period / 2 - from_dash;
        return std::max(std::clamp(dash / 2 + 0.5 - from_dash, 0.0, 1.0),
                        std::clamp(dot / 2 + 0.5 - from_dot, 0.0, 1.0));
    }
    void blend(const glm::ivec2& at, double share) const {
        if (share <= 0 || at.x < 0 || at.y < 0 || at.x >= image_.width || at.y >= image_.height) {
            return;
        }
        std::uint8_t* pixel =
            &image_.rgba[4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(image_.width) +
                              static_cast<std::size_t>(at.x))];
        const double before = pixel[3] / 255.0, alpha = share + (1 - share) * before;
        for (int i = 0; i < 3; ++i) {
            pixel[i] = static_cast<std::uint8_t>(std::lround((share * ink_ + (1 - share) * before * pixel[i]) / alpha));
        }
        pixel[3] = static_cast<std::uint8_t>(std::lround(255 * alpha));
    }

    base::Image& image_;
    double width_;
    std::uint8_t ink_;
};

bool is_dark(const base::Image& image) {
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const double alpha = image.rgba[i + 3];
        sum += alpha * (0.299 * image.rgba[i] + 0.587 * image.rgba[i + 1] + 0.114 * image.rgba[i + 2]);
        weight += alpha;
    }
    return weight > 0 && sum < 110 * weight;
}

/// Pixels.
double line_width(const npr::Picture& picture) {
    const auto width = picture.parameters.find("width");
    double outline = 1.8;
    if (width) {
        outline = static_cast<double>(std::get<float>(picture.parameters.at(*width))) *
                  (picture.parameters.in_millimeters(*width) ? picture.pixels_per_millimeter() : 1);
    }
    return std::max(0.5 * outline, 0.5);
}

}  // namespace

std::vector<CenterLine> center_lines(const Model& model) {
    if (model.empty() || model.tree == nullptr) {
        return {};
    }
    std::vector<csg::Box> boxes;
    boxes.reserve(model.geometry.leaves.size());
    for (const csg::solid::PlacedLeaf& leaf : model.geometry.leaves) {
        boxes.push_back(leaf.box);
    }
    Collector collector(model);
    for (const csg::Part& part : model.scene.parts) {
        if (part.kind != csg::PartKind::Solid || part.hidden) {
            continue;
        }
        const csg::Box box = csg::bounds(model.scene, part, boxes);
        for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
            collector.add_leaf(leaf, box);
        }
    }
    return collector.take();
}

void draw_center_lines(base::Image& image, const std::vector<CenterLine>& lines, const npr::Picture& picture,
                       const base::View& view) {
    constexpr double kEndOn = 0.99863;  // Cosine of 3 degrees.
    const Chain chain(image, line_width(picture), is_dark(image) ? 255 : 0);
    const glm::dmat4 clip = view.clip_from_world();
    const glm::dvec2 size(image.width, image.height);
    const double beyond = kBeyond * picture.pixels_per_millimeter();
    const glm::dvec3 right = glm::dvec3(glm::transpose(view.eye_from_world())[0]);
    const auto place = [&](const glm::dvec3& point) -> std::optional<glm::dvec2> {
        const glm::dvec4 p = clip * glm::dvec4(point, 1);
        return p.w > 1e-9 ? std::optional(0.5 * size * glm::dvec2(1 + p.x / p.w, 1 - p.y / p.w)) : std::nullopt;
    };
    for (const CenterLine& line : lines) {
        const glm::dvec3 middle = (line.from + line.to) / 2.0;
        const auto from = place(line.from), to = place(line.to), center = place(middle),
                   rim = place(middle + line.radius * right);
        if (!from || !to || !center || !rim) {
            continue;
        }
        const glm::dvec3 in_eye = glm::dvec3(view.eye_from_world() * glm::dvec4(middle, 1));
        const glm::dvec3 sight = view.orthographic() ? glm::dvec3(0, 0, -1) : glm::normalize(in_eye);
        const glm::dvec3 axis = glm::dmat3(view.eye_from_world()) * (line.to - line.from);
        const double length = glm::length(axis), radius = glm::distance(*center, *rim);
        if (radius < 2) {
            continue;
        }
        if (length == 0 || std::abs(glm::dot(axis, sight)) > kEndOn * length) {
            chain.draw(*center - glm::dvec2(radius + beyond, 0), *center + glm::dvec2(radius + beyond, 0));
            chain.draw(*center - glm::dvec2(0, radius + beyond), *center + glm::dvec2(0, radius + beyond));
        } else {
            const glm::dvec2 further = beyond * glm::normalize(*to - *from);
            chain.draw(*from - further, *to + further);
        }
    }
}

}  // namespace ui
