#include "ui/viewer/tools/view_cube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/viewer/camera_control.h"
#include "ui/viewer/tool.h"
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

constexpr double kHalf = 25, kFromCorner = 56;  // Of the cube, and of its middle from the picture's corner, in units.
constexpr double kRim = 0.6;                    // What is farther from a face's middle, of 1, is an edge or a corner.
constexpr double kCubeClickDistance = 3;
constexpr double kLeastPictureForCube = 240;  // A smaller one has no room for it.

struct Face {
    glm::dvec3 normal, right, up;  ///< As it is read.
    const char* name;
};
constexpr std::array<Face, 6> kFaces{{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, "Top"},
                                      {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}, "Bottom"},
                                      {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, "Left"},
                                      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, "Right"},
                                      {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, "Front"},
                                      {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, "Back"}}};

/// The cube as it is seen: parallel, whatever the camera's projection.
class Look {
  public:
    Look(const base::Camera& camera, const glm::dvec2& middle, double half)
        : turn_(camera.eye_from_world()), middle_(middle), half_(half) {}

    /// Of a point of the cube from -1 to 1.
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& p) const {
        const glm::dvec3 in_eye = turn_ * p;
        return middle_ + half_ * glm::dvec2(in_eye.x, -in_eye.y);
    }
    /// How much of a face is turned to the eye.
    [[nodiscard]] double facing(const Face& face) const { return (turn_ * face.normal).z; }

    /// Where in the face a place lies, right and up, -1 to 1; nothing where it lies beside.
    [[nodiscard]] std::optional<glm::dvec2> inside(const Face& face, const glm::dvec2& at) const {
        const glm::dvec2 origin = place(face.normal);
        const glm::dmat2 axes(place(face.normal + face.right) - origin, place(face.normal + face.up) - origin);
        const glm::dvec2 in_face = glm::inverse(axes) * (at - origin);
        return std::max(std::abs(in_face.x), std::abs(in_face.y)) <= 1 ? std::optional(in_face) : std::nullopt;
    }

  private:
    glm::dmat3 turn_;
    glm::dvec2 middle_;
    double half_;
};

constexpr double kVisible = 0.03;  // Faces seen more steeply are none.

/// -1, 0 or 1
double third(double x) {
    return x < -kRim ? -1 : x > kRim ? 1 : 0;
}

/// Text in a plane of the cube: as it is laid out flat, then each of its vertices moved.
void write(const ToolPainter& painter, const Look& look, const Face& face, double half, ImU32 color) {
    const ImFont& font = *painter.fonts.bold;
    const double size = 0.52 * half;
    const ImVec2 extent = font.CalcTextSizeA(static_cast<float>(size), FLT_MAX, 0, face.name);
    const int first = painter.list.VtxBuffer.Size;
    painter.list.AddText(&font, static_cast<float>(size), {0, 0}, color, face.name);
    for (int i = first; i < painter.list.VtxBuffer.Size; ++i) {
        ImVec2& at = painter.list.VtxBuffer[i].pos;
        const glm::dvec2 flat(at.x - 0.5F * extent.x, 0.5F * extent.y - at.y);
        at = window_point(look.place(face.normal + (flat.x * face.right + flat.y * face.up) / half));
    }
}

class ViewCube : public Tool {
  public:
    bool hover(ToolContext& context, const std::optional<glm::dvec2>& at) override {
        const auto side = at ? side_at(context, *at) : std::nullopt;
        return std::exchange(side_, side) != side;
    }

    bool press(ToolContext& context, const PointerEvent& event) override {
        pressed_ = event.button == Button::Left ? side_at(context, event.position) : std::nullopt;
        from_ = last_ = event.position;
        turns_ = false;
        return pressed_.has_value();
    }

    void drag(ToolContext& context, const glm::dvec2& at) override {
        turns_ = turns_ || glm::distance(at, from_) > kCubeClickDistance;
        if (turns_) {
            orbit(context.camera, at - std::exchange(last_, at));
        }
    }

    void release(ToolContext& context, const glm::dvec2& /*at*/) override {
        if (!turns_) {
            context.commands.emplace_back(LookFrom{*pressed_});
        }
    }

    void draw(const ToolContext& context, const ToolPainter& painter) const override {
        if (!shown(context)) {
            return;
        }
        const double half = kHalf * static_cast<double>(painter.scale);
        const Look look = look_of(context, painter.scale);
        for (const Face& face : kFaces) {
            const double facing = look.facing(face);
            if (facing < kVisible) {
                continue;
            }
            const auto quad = [&](double left, double right, double low, double high, ImU32 color) {
                const auto corner = [&](double x, double y) {
                    return window_point(look.place(face.normal + x * face.right + y * face.up));
                };
                painter.list.AddQuadFilled(corner(left, low), corner(right, low), corner(right, high),
                                           corner(left, high), color);
            };
            const int gray = 96 + static_cast<int>(96 * facing);
            quad(-1, 1, -1, 1, IM_COL32(gray, gray, gray + 6, 225));
            if (side_) {
                highlight(face, quad);
            }
            if (facing > 0.25) {
                write(painter, look, face, half, IM_COL32(20, 22, 26, 255));
            }
            const std::array<ImVec2, 4> rim{window_point(look.place(face.normal - face.right - face.up)),
                                            window_point(look.place(face.normal + face.right - face.up)),
                                            window_point(look.place(face.normal + face.right + face.up)),
                                            window_point(look.place(face.normal - face.right + face.up))};
            painter.list.AddPolyline(rim.data(), 4, IM_COL32(40, 42, 48, 255), ImDrawFlags_Closed, painter.scale);
        }
    }

  private:
    static bool shown(const ToolContext& context) {
        return context.session.shown().cube && context.picture.size.x >= kLeastPictureForCube &&
               context.picture.size.y >= kLeastPictureForCube;
    }

    static Look look_of(const ToolContext& context, float scale) {
        const double s = static_cast<double>(scale);
        return {
            context.camera,
            glm::dvec2(context.picture.corner) + glm::dvec2(context.picture.size.x - kFromCorner * s, kFromCorner * s),
            kHalf * s};
    }

    /// The piece of the face that belongs to the side under the pointer.
    template <typename Quad>
    void highlight(const Face& face, Quad&& quad) const {
        if (glm::dot(*side_, face.normal) != 1) {
            return;
        }
        const auto range = [](double third) {
            return third < 0 ? std::pair(-1.0, -kRim) : third > 0 ? std::pair(kRim, 1.0) : std::pair(-kRim, kRim);
        };
        const auto [left, right] = range(glm::dot(*side_, face.right));
        const auto [low, high] = range(glm::dot(*side_, face.up));
        quad(left, right, low, high, IM_COL32(76, 148, 240, 255));
    }

    /// The direction of the face, edge or corner that lies there, its coordinates -1, 0 or 1.
    static std::optional<glm::dvec3> side_at(const ToolContext& context, const glm::dvec2& at) {
        if (!shown(context)) {
            return std::nullopt;
        }
        const Look look = look_of(context, context.scale);
        for (const Face& face : kFaces) {
            if (look.facing(face) < kVisible) {
                continue;
            }
            if (const auto in_face = look.inside(face, at)) {
                return face.normal + third(in_face->x) * face.right + third(in_face->y) * face.up;
            }
        }
        return std::nullopt;
    }

    std::optional<glm::dvec3> side_, pressed_;  ///< Under the pointer, and where it was pressed.
    glm::dvec2 from_{0}, last_{0};
    bool turns_ = false;  ///< The drag is no click any more.
};

}  // namespace

std::unique_ptr<Tool> make_view_cube() {
    return std::make_unique<ViewCube>();
}

}  // namespace ui
