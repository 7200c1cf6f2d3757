// Draws models: from a Model to a picture, in one OpenGL context.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gl/camera.h"
#include "gl/context.h"
#include "gl/image.h"
#include "npr/accumulate.h"
#include "npr/color_scheme.h"
#include "npr/style.h"
#include "peel/peeler.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/statistics.h"

namespace ui {

struct PictureRequest {
    gl::Camera camera;
    glm::ivec2 size{512, 512};
    std::string style = "shaded";
    std::vector<std::pair<std::string, std::string>> settings;  ///< Style parameters by name; the rest are defaults.
    std::string scheme = "Cornfield";
    int layers = -1;  ///< 0: all; below 0: what the style needs.
    int samples = 4;  ///< Per pixel.
    bool transparent_background = false;
};
