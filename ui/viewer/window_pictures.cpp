// The pictures that the window asks for, and what becomes of them.
#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "ui/viewer/window_loop.h"

namespace ui {

namespace {

const char* state_name(DocumentState state) {
    switch (state) {
        case DocumentState::Evaluating:
            return "evaluating";
        case DocumentState::Good:
            return "good";
        case DocumentState::Failed:
            return "failed";
        case DocumentState::Gone:
            return "gone";
    }
    return "";
}

}  // namespace

void WindowLoop::save_picture(const WritePicture& what) {
    if (!wanted_model_) {
        save_form_.set_error("There is no model yet.");
        return;
    }
    note_ = "Saving the picture…";
    ++saving_;
    picture_.save(wanted_model_, with_glyph_styles(what.picture), session_.view().thickness, what.path,
                  wanted_annotations_);
}

/// Of the model that the document shows.
PictureRequest WindowLoop::with_glyph_styles(PictureRequest request) const {
    const Document& document = session_.document();
    if (document.model() && !document.glyphs().styles.empty()) {
        for (npr::PartStyle& style : styles_of_glyphs(document.model()->scene, document.glyphs().styles)) {
            request.part_styles.push_back(std::move(style));
        }
    }
    return request;
}

bool WindowLoop::receive() {
    const auto results = picture_.take();
    for (const PictureResult& result : results) {
        std::visit([this](const auto& each) { receive(each); }, result);
    }
    return !results.empty();
}

void WindowLoop::receive(const SavedPicture& saved) {
    --saving_;
    if (saved.error.empty()) {
        note_ = fmt::format("Saved {} ({}×{})", saved.path.string(), saved.size.x, saved.size.y);
        session_.perform(Action::Close);
    } else {
        note_ = "The picture is not saved";
        save_form_.set_error(saved.error);
    }
    plan_.replaced(seconds());
}

void WindowLoop::receive(const PickedPoint& picked) {
    if (picked.purpose == PickFor::Navigation) {
        navigator_.answer(picked.surface ? std::optional(picked.surface->point) : std::nullopt);
    } else if (picked.surface) {
        session_.look_at(picked.surface->point);
    }
}

void WindowLoop::receive(const ProbedPlace& probed) {
    asked_ = false;
    Commands commands;
    use_tools(
        [&](ToolContext& context) {
            toolbox_.answer(context, {probed.at, probed.surface, probed.face, probed.edge, probed.corner});
        },
        commands);
    for (const Command& command : commands) {
        perform(command);
    }
}

void WindowLoop::receive(const PickedSurfaces& picked) {
    if (picked.model == session_.document().model()) {
        session_.select(picked.surfaces, picked.at);
    }
}

void WindowLoop::receive(const DrawnStep& drawn) {
    drawing_.reset();
    if (drawn.stopped) {
        return;
    }
    const bool wanted = drawn.version == wanted_version_;
    if (!drawn.error.empty()) {
        if (wanted) {
            info_.error = drawn.error;
            plan_.give_up();
        }
        return;
    }
    wanted ? plan_.drawn(drawn.step, drawn.seconds) : plan_.measured(drawn.step, drawn.seconds);
    shown_version_ = drawn.version;
    picture_ms_ += 1000 * drawn.seconds;
    info_.samples = drawn.step.sample + 1;
    info_.wanted_samples = wanted_.samples;
    info_.divisor = drawn.step.divisor;
    info_.size = wanted_.size;
    info_.ms = 1000 * drawn.seconds;
    info_.engine = drawn.statistics.engine;
    info_.walk = drawn.statistics.walk;
    inspection_.see(wanted ? wanted_model_ : nullptr, drawn.thickness);
    if (wanted && drawn.step.divisor == 1) {
        session_.tell_unwritten(drawn.unwritten);
    }
    if (wanted && wanted_model_) {
        session_.see_layers(*wanted_model_, std::max(info_.walk.layers, wanted_.layers));
    }
}

void WindowLoop::plan_picture(glm::ivec2 size) {
    const PictureRequest request = with_glyph_styles(session_.view().request(size));
    const auto& model = session_.document().model();
    const bool other_model = model != wanted_model_;
    const bool other = (other_model && !session_.customizing()) || request.style != wanted_.style ||
                       request.layers != wanted_.layers || request.engine != wanted_.engine ||
                       session_.view().thickness.has_value() != wanted_thickness_.has_value();
    const ViewMarks marks = session_.shown().marks();
    const HeldPart& held = session_.held();
    if (!other && !other_model && request == wanted_ && marks == wanted_marks_ && held == wanted_held_ &&
        session_.view().thickness == wanted_thickness_ && session_.annotations() == wanted_annotations_) {
        return;
    }
    other ? plan_.replaced(seconds()) : plan_.moved(seconds());
    plan_.set_samples(request.samples);
    wanted_ = request;
    wanted_marks_ = marks;
    wanted_held_ = held;
    wanted_thickness_ = session_.view().thickness;
    wanted_annotations_ = session_.annotations();
    wanted_model_ = model;
    ++wanted_version_;
    info_.error.clear();
    if (drawing_ && plan_.hinders(*drawing_)) {
        picture_.stop_drawing();
    }
}

void WindowLoop::draw_picture() {
    // What is done is taken after asking whether something is being done: so nothing is begun on top of a picture
    // that was saved in between.
    const bool busy = picture_.busy();
    bool news = receive();
    if (!wanted_model_) {
        plan_.give_up();  // There is nothing to draw.
        return;
    }
    if (const auto step = busy ? std::nullopt : plan_.next(seconds())) {
        drawing_ = *step;
        picture_.draw(wanted_model_, wanted_, wanted_marks_, wanted_thickness_, *step, wanted_version_, wanted_held_,
                      wanted_annotations_);
        news |= receive();
    }
    if (news) {
        frames_to_draw_ = std::max(frames_to_draw_, 1);  // The status line tells of it.
    }
}

void WindowLoop::log(double frame_ms) {
    FrameRecord record;
    record.time = seconds();
    record.ms = frame_ms;
    record.picture_ms = std::exchange(picture_ms_, 0);
    record.samples = info_.samples;
    record.wanted_samples = wanted_.samples;
    record.current = wanted_model_ && shown_version_ == wanted_version_;
    record.divisor = info_.divisor;
    record.size = wanted_.size;
    record.generation = wanted_model_ ? wanted_model_->generation : 0;
    record.style = session_.view().picture.style->name;
    record.engine = info_.samples > 0 ? info_.engine.engine->name : "";
    record.state = state_name(session_.document().state());
    record.evaluating = session_.evaluating();
    record.selected = session_.selected_place();
    record.step = session_.animation().step();
    if (session_.shown().text && session_.text().text) {
        record.text_line = static_cast<int>(session_.text().range.line);
    }
    record.tool = toolbox_.info().name;
    record.edits = static_cast<int>(session_.editing().text().steps());
    record.unsaved = session_.editing().text().unsaved();
    record.found = toolbox_.text();
    record.inspection = inspection_.record();
    record.dynamics = session_.dynamics().record();
    record.dynamics.depictions =
        session_.document().glyphs().of ? static_cast<int>(session_.document().glyphs().of->depictions.size()) : 0;
    if (const auto& written = session_.annotations()) {
        record.dynamics.labels =
            static_cast<int>(written->labels.size() + written->bubbles.size() + written->frames.size());
    }
    record.camera = session_.view().picture.camera;
    log_.write(record);
}

}  // namespace ui
