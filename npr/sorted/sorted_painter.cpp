#include "npr/sorted/sorted_painter.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/stop.h"
#include "npr/sorted/sorted_settings.h"
#include "npr/sorted/triangle_raster.h"
#include "npr/srgb.h"

namespace npr {
namespace {

/// As npr/surface_color.glsl lights them.
glm::vec4 lit(const glm::vec4& color, const glm::dvec3& normal_in_eye) {
    const glm::dvec3 toward_light = glm::dvec3(-1, 1, 1) / std::sqrt(3.0);
    const double length = glm::length(normal_in_eye);
    const double light = 0.2 + (length > 0 ? std::abs(glm::dot(normal_in_eye, toward_light)) / length : 0);
    return {glm::min(glm::vec3(color) * static_cast<float>(light), 1.0F), color.a};
}

/// Color and depth of a picture that is being drawn, in sRGB with OpenGL's alpha.
struct Buffers {
    glm::ivec2 size;
    std::vector<glm::vec4> color;
    std::vector<double> depth;  ///< Distance of what is nearest.
};

struct Triangle {
    std::array<glm::dvec3, 3> eye;
    std::array<RasterCorner, 3> at;
    glm::dvec3 normal;
    bool back;  ///< Faces away from the eye.
};

Triangle triangle_of(const ColoredMesh& mesh, std::uint32_t index, const base::View& view) {
    Triangle t{};
    for (int i = 0; i < 3; ++i) {
        const auto corner = static_cast<std::size_t>(i);
        t.eye[corner] = glm::dvec3(view.eye_from_world() * glm::dvec4(mesh.points[mesh.triangles[index][i]], 1.0));
        t.at[corner] = raster_corner(view, t.eye[corner]);
    }
    t.normal = glm::cross(t.eye[1] - t.eye[0], t.eye[2] - t.eye[0]);
    t.back = view.orthographic() ? t.normal.z <= 0 : glm::dot(t.normal, t.eye[0]) >= 0;
    return t;
}

}  // namespace

SortedPainter::SortedPainter(ColoredMesh mesh) : mesh_(std::move(mesh)) {
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
        if (mesh_.colors[i].a >= 1) {
            opaque_.push_back(i);
        } else if (mesh_.colors[i].a > 0) {
            clear_.push_back(i);
        }
    }
}

/// By the corner that is farthest from the eye's plane, as in the text.
void SortedPainter::sort(const Picture& picture, const base::View& view) {
    const auto order = static_cast<SortOrder>(transparency_settings<SortedSettings>(picture).order);
    std::vector<double> keys(clear_.size());
    std::vector<double> of_parts(mesh_.parts.empty() ? 0 : mesh_.parts.back() + 1,
                                 -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < clear_.size(); ++i) {
        double farthest = -std::numeric_limits<double>::infinity();
        for (int corner = 0; corner < 3; ++corner) {
            const glm::dvec3& p = mesh_.points[mesh_.triangles[clear_[i]][corner]];
            farthest = std::max(farthest, -(view.eye_from_world() * glm::dvec4(p, 1.0)).z);
        }
        keys[i] = farthest;
        double& part = of_parts[mesh_.parts[clear_[i]]];
        part = std::max(part, farthest);
    }
    if (order == SortOrder::None) {
        std::fill(keys.begin(), keys.end(), 0.0);
    } else if (order != SortOrder::Triangles) {
        // Parts one after the other: the place of the part is the larger piece of the key.
        IndexSort parts;
        parts.sort(of_parts);
        std::vector<std::size_t> places(of_parts.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[parts.order()[i]] = places.size() - i;
        }
        const auto [least, most] = std::minmax_element(keys.begin(), keys.end());
        const double from = keys.empty() ? 0 : *least, range = keys.empty() ? 1 : *most - *least + 1;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const auto place = static_cast<double>(places[mesh_.parts[clear_[i]]]);
            keys[i] = place * range + (order == SortOrder::Objects ? keys[i] - from : 0);
        }
    }
    counts_.push_back(by_distance_.sort(keys));
}

void SortedPainter::paint(const CpuFrame& frame, bool first) {
    const Picture& picture = frame.picture;
    const auto settings = transparency_settings<SortedSettings>(picture);
    if (first || by_distance_.order().size() != clear_.size()) {
        sort(picture, frame.view);
    }
    Buffers to{picture.size, {}, {}};
    const auto width = static_cast<std::size_t>(to.size.x), height = static_cast<std::size_t>(to.size.y);
    to.depth.assign(width * height, std::numeric_limits<double>::infinity());
    to.color.resize(width * height);
    for (std::size_t y = 0; y < height; ++y) {
        const float up =
            (static_cast<float>(y) + 0.5F + static_cast<float>(frame.view.jitter().y)) / static_cast<float>(to.size.y);
        const glm::vec3 background = glm::mix(picture.scheme.background_stop, picture.scheme.background, up);
        std::fill_n(&to.color[y * width], width,
                    picture.transparent_background ? glm::vec4(0) : glm::vec4(background, 1));
    }
    const auto draw = [&](std::uint32_t index, const auto& fragment) {
        const Triangle t = triangle_of(mesh_, index, frame.view);
        const glm::vec4 color = lit(mesh_.colors[index], t.normal);
        if (!t.back || color.a >= 1 || settings.back_faces) {
            rasterize(frame.view, t.eye, t.at, [&](int x, int y, double distance) {
                const std::size_t at = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
                if (distance < to.depth[at]) {
                    fragment(at, distance, color);
                }
            });
        }
    };
    for (const std::uint32_t index : opaque_) {
        draw(index, [&](std::size_t at, double distance, const glm::vec4& color) {
            to.depth[at] = distance;
            to.color[at] = color;
        });
    }
    base::end_if_asked(frame.stop);
    const Blending blending = settings.blending();
    for (const std::uint32_t i : by_distance_.order()) {
        draw(clear_[i], [&](std::size_t at, double distance, const glm::vec4& color) {
            to.color[at] = blend(blending, color, to.color[at]);
            to.depth[at] = settings.depth_writes ? distance : to.depth[at];
        });
    }
    const SrgbTables& srgb = SrgbTables::get();
    for (std::size_t i = 0; i < to.color.size(); ++i) {
        // The buffer's color has its alpha in it, as every color that was blended over nothing.
        const glm::vec4& c = to.color[i];
        const float alpha = c.a, straight = 1 / std::max(alpha, 1e-6F);
        frame.sum[i] += glm::vec4(srgb.linear(c.r * straight) * alpha, srgb.linear(c.g * straight) * alpha,
                                  srgb.linear(c.b * straight) * alpha, alpha);
    }
}

}  // namespace npr
