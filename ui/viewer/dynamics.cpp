#include "ui/viewer/dynamics.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/scad/source/source.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/part_names.h"
#include "ui/pipeline/program_runner.h"

namespace ui {

namespace {

/// What moves in the program of a source; throws as find_motion does.
Motion motion_of(const Source& source, const std::pair<double, double>& interval, const csg::scad::View& camera,
                 ProgramRunner& runner, const std::stop_token& stop) {
    csg::scad::Request request = request_of(source, camera, stop);
    request.definitions.insert(request.definitions.end(), source.customized.begin(), source.customized.end());
    MotionRequest wanted;
    wanted.from = interval.first;
    wanted.to = interval.second;
    wanted.derivatives = false;
    return find_motion(
        [&](double time) -> std::shared_ptr<const csg::Tree> {
            request.time = time;
            const ProgramRun run = runner.run(request, false, [](const auto&, const auto&) { return std::size_t{0}; });
            base::end_if_asked(stop);
            return run.good() ? run.evaluation.tree : nullptr;
        },
        wanted, stop);
}

/// "--label x: expected …" without what the panel shows anyway.
std::string reason(const std::string& error, const std::string& option) {
    return error.starts_with(option) ? error.substr(option.size()) : error;
}

}  // namespace

Dynamics::Dynamics(std::function<void()> wake)
    : runner_(std::make_shared<ProgramRunner>(make_measures())), job_(std::move(wake)) {}

void Dynamics::set(GlyphTexts texts) {
    const bool other_rules = texts.rules_file != texts_.rules_file;
    texts_ = std::move(texts);
    if (other_rules) {
        read_rules();
    }
    depictions_.clear();
    depiction_text_.clear();
    depiction_forms_.assign(texts_.depictions.size(), {});
    for (std::size_t i = 0; i < texts_.depictions.size(); ++i) {
        try {
            const Depiction read = read_depiction(texts_.depictions[i]);
            (void)style_of(read);
            depictions_.push_back(read);
            depiction_text_.push_back(i);
        } catch (const std::runtime_error& error) {
            depiction_forms_[i] = error.what();
        }
    }
    depictions_.insert(depictions_.end(), rules_.begin(), rules_.end());
    read_ = {};
    read_.callouts = texts_.annotations.callouts;
    label_text_.clear();
    label_forms_.assign(texts_.annotations.labels.size(), {});
    for (std::size_t i = 0; i < label_forms_.size(); ++i) {
        const std::string& text = texts_.annotations.labels[i];
        try {
            read_.labels.push_back(read_label(text));
            label_text_.push_back(i);
        } catch (const std::runtime_error& error) {
            label_forms_[i] = reason(error.what(), fmt::format("--label {}: ", text));
        }
    }
    errors_.arrows.assign(texts_.annotations.arrows.size(), {});
    for (std::size_t i = 0; i < errors_.arrows.size(); ++i) {
        const std::string& text = texts_.annotations.arrows[i];
        try {
            read_.arrows.push_back(read_arrow(text));
        } catch (const std::runtime_error& error) {
            errors_.arrows[i] = reason(error.what(), fmt::format("--arrow {}: ", text));
        }
    }
    errors_.depictions = depiction_forms_;
    errors_.labels = label_forms_;
    errors_.picture.clear();
}

void Dynamics::read_rules() {
    rules_.clear();
    errors_.rules.clear();
    if (texts_.rules_file.empty()) {
        return;
    }
    const auto text = csg::scad::read_source_file(texts_.rules_file);
    if (const auto* read = std::get_if<std::string>(&text)) {
        try {
            rules_ = read_depiction_rules(*read, texts_.rules_file);
        } catch (const std::runtime_error& error) {
            errors_.rules = error.what();
        }
    } else {
        errors_.rules = fmt::format("{} cannot be read", texts_.rules_file);
    }
}

std::pair<double, double> Dynamics::interval() const {
    std::pair<double, double> all{0, 1};
    for (const Depiction& d : depictions_) {
        if (d.times) {
            all = {std::min(all.first, d.times->first), std::max(all.second, d.times->second)};
        }
    }
    return all;
}

void Dynamics::look(const Document& document, const csg::scad::View& camera) {
    const auto& model = document.model();
    if (!model || !model->program || document.state() == DocumentState::Failed) {
        return;
    }
    const ProgramState wanted{model->program, document.source().customized, interval()};
    if (wanted == known_.of || wanted == canceled_ || (wanted == sought_ && job_.busy())) {
        return;
    }
    sought_ = wanted;
    known_ = {};
    canceled_ = {};
    ++searches_;
    began_ = std::chrono::steady_clock::now();
    job_.start([=, runner = runner_, source = document.source()](const std::stop_token& stop) {
        MotionAnswer answer{wanted, nullptr, {}};
        try {
            answer.motion = std::make_shared<const Motion>(motion_of(source, wanted.interval, camera, *runner, stop));
        } catch (const base::Stopped&) {
            // Nobody waits for it.
        } catch (const std::exception& error) {
            answer.error = error.what();
        }
        return answer;
    });
}

void Dynamics::cancel() {
    if (job_.busy()) {
        job_.cancel();
        canceled_ = std::exchange(sought_, {});
    }
}

bool Dynamics::update() {
    auto answer = job_.take();
    if (!answer) {
        return false;
    }
    sought_ = {};
    known_ = *std::move(answer);
    return true;
}

std::optional<int> Dynamics::looking_for() const {
    using std::chrono::duration_cast, std::chrono::seconds;
    return sought_.program ? std::optional(static_cast<int>(
                                 duration_cast<seconds>(std::chrono::steady_clock::now() - began_).count()))
                           : std::nullopt;
}

std::shared_ptr<const DepictedMotion> Dynamics::depicted(double aspect) const {
    if (depictions_.empty() || !known_.motion) {
        return nullptr;
    }
    return std::make_shared<const DepictedMotion>(DepictedMotion{depictions_, known_.motion, known_.of, aspect});
}

std::shared_ptr<const Annotations> Dynamics::annotations(const Document& document) {
    errors_.depictions = depiction_forms_;
    const Document::Glyphs& glyphs = document.glyphs();
    for (std::size_t i = 0; i < depiction_text_.size() && i < glyphs.problems.size(); ++i) {
        // Of the texts as they were then.
        if (glyphs.of->depictions[i].text == depictions_[i].text) {
            errors_.depictions[depiction_text_[i]] = glyphs.problems[i];
        }
    }
    errors_.labels = label_forms_;
    auto all = std::make_shared<Annotations>(read_);
    all->labels.clear();
    for (std::size_t i = 0; i < read_.labels.size() && document.model(); ++i) {
        try {
            (void)parts_selected(document.model()->scene, "label", read_.labels[i].of);
            all->labels.push_back(read_.labels[i]);
        } catch (const ModelError& error) {
            errors_.labels[label_text_[i]] = reason(error.what(), "label: ");
        }
    }
    all->bubbles = glyphs.bubbles;
    all->frames = glyphs.frames;
    return all->any() ? all : nullptr;
}

std::vector<std::string> Dynamics::options() const {
    std::vector<std::string> all;
    const auto add = [&](const char* option, const std::vector<std::string>& texts,
                         const std::vector<std::string>& errors) {
        for (std::size_t i = 0; i < texts.size(); ++i) {
            if (i >= errors.size() || errors[i].empty()) {
                all.insert(all.end(), {option, texts[i]});
            }
        }
    };
    add("--depict", texts_.depictions, errors_.depictions);
    add("--label", texts_.annotations.labels, errors_.labels);
    add("--arrow", texts_.annotations.arrows, errors_.arrows);
    if (!texts_.rules_file.empty() && errors_.rules.empty()) {
        all.insert(all.end(), {"--depict-rules", texts_.rules_file});
    }
    if (texts_.annotations.callouts) {
        all.emplace_back("--callouts");
    }
    return all;
}

FrameRecord::Dynamics Dynamics::record() const {
    FrameRecord::Dynamics record;
    record.searches = searches_;
    record.bodies = known_.motion ? static_cast<int>(known_.motion->bodies.size()) : -1;
    for (const auto* errors : {&errors_.depictions, &errors_.labels, &errors_.arrows}) {
        for (const std::string& error : *errors) {
            record.error = record.error.empty() ? error : record.error;
        }
    }
    for (const std::string* error : {&errors_.rules, &errors_.picture, &known_.error}) {
        record.error = record.error.empty() ? *error : record.error;
    }
    return record;
}

}  // namespace ui
