#include "ui/viewer/view_state.h"

#include <utility>

#include "npr/accumulate.h"

namespace ui {

ViewState::ViewState(const PictureRequest& first) : picture(first) {
    picture.transparent_background = false;
    picture.samples = static_cast<int>(npr::sample_offsets(first.samples).size());
    for (const npr::StyleInfo& info : npr::styles()) {
        kept_.emplace_back(info.parameters);
    }
}

PictureRequest ViewState::request(glm::ivec2 size) const {
    PictureRequest request = picture;
    request.size = size;
    return request;
}

std::size_t ViewState::style() const {
    return static_cast<std::size_t>(picture.style - npr::styles().data());
}

void ViewState::show_style(std::size_t style) {
    kept_[this->style()] = std::move(picture.parameters);
    picture.style = &npr::styles()[style];
    picture.parameters = kept_[style];
}

void ViewState::reset_parameters() {
    picture.draw_as(*picture.style);
}

}  // namespace ui
