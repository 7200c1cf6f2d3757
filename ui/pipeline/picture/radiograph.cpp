#include "ui/pipeline/picture/radiograph.h"

#include <algorithm>
#include <utility>

namespace ui {

namespace {

/// By pixel, rows from bottom to top.
std::vector<glm::vec4> drawn(Renderer& renderer, const Model& model, const PictureRequest& request,
                             const std::stop_token& stop) {
    const auto samples = static_cast<int>(npr::sample_offsets(request.samples).size());
    for (int sample = 0; sample < samples; ++sample) {
        renderer.draw_sample(model, request, sample, stop);
    }
    return renderer.light();
}

/// A component of all pixels, rows from top to bottom.
base::FloatImage::Channel channel(std::string name, const std::vector<glm::vec4>& pixels, glm::ivec2 size,
                                  int component) {
    base::FloatImage::Channel result{std::move(name), {}};
    result.values.reserve(pixels.size());
    for (int y = size.y - 1; y >= 0; --y) {
        for (int x = 0; x < size.x; ++x) {
            const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x);
            result.values.push_back(pixels[pixel + static_cast<std::size_t>(x)][component]);
        }
    }
    return result;
}

PictureRequest in_millimeters(PictureRequest request) {
    request.parameters.read("colors", "values");
    return request;
}

}  // namespace

bool is_radiograph(const npr::Picture& picture) {
    return picture.style->name == "radiograph";
}

base::FloatImage thickness(Renderer& renderer, const Model& model, const PictureRequest& request,
                           const std::stop_token& stop) {
    PictureRequest values = in_millimeters(request);
    const glm::ivec2 size = request.size;
    base::FloatImage image{size.x, size.y, {channel("Y", drawn(renderer, model, values, stop), size, 0)}};
    std::vector<std::size_t> measured;
    for (std::size_t i = 0; i < model.scene.parts.size(); ++i) {
        const csg::PartKind kind = model.scene.parts[i].kind;
        if (kind == csg::PartKind::Solid || kind == csg::PartKind::Translucent) {
            measured.push_back(i);
        }
    }
    const bool all = std::get<int>(values.parameters.at(*values.parameters.find("part"))) == 0;
    if (!all || measured.size() < 2) {
        return image;
    }
    for (const std::size_t part : measured) {
        values.parameters.set("part", static_cast<int>(part) + 1);
        std::string name = model.scene.parts[part].name;
        std::replace(name.begin(), name.end(), '.', '_');
        constexpr std::size_t kLongestName = 255;
        name.resize(std::min(name.size(), kLongestName));
        image.channels.push_back(channel(name, drawn(renderer, model, values, stop), size, 0));
    }
    return image;
}

double most_thickness(Renderer& renderer, const Model& model, const PictureRequest& request,
                      const std::stop_token& stop) {
    PictureRequest values = in_millimeters(request);
    values.samples = 1;
    float most = 0;
    for (const glm::vec4& pixel : drawn(renderer, model, values, stop)) {
        most = std::max(most, pixel.r);
    }
    return most;
}

base::FloatImage light(Renderer& renderer, const Model& model, const PictureRequest& request,
                       const std::stop_token& stop) {
    const std::vector<glm::vec4> pixels = drawn(renderer, model, request, stop);
    base::FloatImage image{request.size.x, request.size.y, {}};
    for (int c = 0; c < 4; ++c) {
        image.channels.push_back(channel(std::string(1, "RGBA"[c]), pixels, request.size, c));
    }
    return image;
}

}  // namespace ui
