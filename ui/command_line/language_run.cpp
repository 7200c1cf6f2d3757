#include "ui/command_line/language_run.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/scad/syntax/appended_text.h"
#include "csg/scad/text/ast_text.h"
#include "csg/scad/text/csg_text.h"
#include "csg/scad/value/value.h"
#include "ui/command_line/files.h"
#include "ui/command_line/memory_limit.h"
#include "ui/command_line/parameters_json.h"
#include "ui/command_line/standard_streams.h"
#include "ui/pipeline/parameter_sets.h"
#include "ui/pipeline/picture/camera.h"

namespace ui {

Progress::Progress(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

void Progress::say(const char* stage) const {
    if (shown_) {
        say("\r\033[K");
        say(stage);
    }
}

void write_outputs(const Options& options, Format format, const std::string& bytes) {
    for (const Output& output : options.outputs) {
        if (output.format == format) {
            write_output(output.path, bytes);
        }
    }
}

LanguageRun::LanguageRun(const Options& options, TimeLimit& limit, std::shared_ptr<csg::scad::Measures> measures)
    : options_(options),
      limit_(limit),
      messages_(options.quiet),
      progress_(options.quiet),
      runner_(std::move(measures)) {}

bool LanguageRun::operator()() {
    if (only({Format::Ast, Format::Param})) {
        return write_syntax(true);  // Nothing needs to run.
    }
    if (wants(options_, Format::Ast) || wants(options_, Format::Param)) {
        (void)write_syntax(false);  // What is wrong with the text, evaluate() tells.
    }
    if (!evaluate()) {
        return only({Format::Echo}) && run_.evaluation.parsed && !run_.evaluation.stopped && !options_.hard_warnings;
    }
    if (wants(options_, Format::Csg)) {
        write_tree();
    }
    if (wants(options_, Format::Term)) {
        // All that OpenSCAD has ever written there: its terms are of meshes, which nobody makes for it.
        write_outputs(options_, Format::Term, "No top-level CSG object\n");
    }
    return true;
}

/// Outputs that need the text to be read only; none where it has errors.
bool LanguageRun::write_syntax(bool tell) {
    const std::shared_ptr<csg::scad::LoadedProgram> program = load();
    if (tell) {
        const csg::scad::SourceSet sources = program->sources();
        for (const csg::scad::Message& message : program->messages()) {
            messages_.add(message, sources);
        }
    }
    if (!program->well_formed() || (tell && options_.hard_warnings && messages_.warnings() != 0)) {
        return false;
    }
    if (wants(options_, Format::Ast)) {
        write_outputs(options_, Format::Ast, program->look_at_all(csg::scad::ast_text));
    }
    if (wants(options_, Format::Param)) {
        const std::string title = std::filesystem::path(options_.input).stem().string();
        write_outputs(options_, Format::Param,
                      program->look([&](const auto& syntax) { return parameters_json(syntax, title); }));
    }
    return true;
}

/// Whether nothing but outputs of these formats is asked for. (Where that is what the console shows, a failed
/// assertion is but a line of it.)
bool LanguageRun::only(std::initializer_list<Format> formats) const {
    return !options_.outputs.empty() && !options_.statistics && !options_.summary && !options_.summary_file &&
           !options_.dependencies &&
           std::all_of(options_.outputs.begin(), options_.outputs.end(), [&](const Output& output) {
               return std::find(formats.begin(), formats.end(), output.format) != formats.end();
           });
}

void LanguageRun::read() {
    request_.path = options_.input == "-" ? "<stdin>" : options_.input;
    request_.text = options_.input == "-" ? read_standard_input() : read_source(options_.input);
    request_.definitions = options_.definitions;
    request_.preview = options_.preview && !needs_geometry(options_);  // as OpenSCAD does
    request_.check_parameters = options_.check_parameters;
    request_.check_ranges = options_.check_ranges;
    request_.by_error = options_.by_error;
    request_.lazy_union = options_.lazy_union;
    request_.trace_parameters = options_.trace_parameters;
    request_.trace_depth = static_cast<std::size_t>(options_.trace_depth);
    if (!options_.make_command.empty()) {
        request_.make_missing = [this](const std::string& path) { make(path); };
    }
    if (options_.memory_limit != 0) {
        limit_memory();
    }
    if (!options_.parameter_file.empty() && !options_.parameter_set.empty()) {
        take_parameter_set();
    }
    const std::size_t own = request_.text->size();
    csg::scad::append_statements(*request_.text, request_.definitions);
    appended_ = request_.text->substr(own);
    if (options_.camera) {
        request_.view = scad_view(*options_.camera);
    }
}

void LanguageRun::set_time(double time) {
    request_.time = time;
    loaded_ = true;
}

/// Once for each file: it is not there at every call that names it.
void LanguageRun::make(const std::string& path) {
    if (made_.insert(path).second) {
        if (const std::string problem = run_make_command(options_.make_command, path); !problem.empty()) {
            messages_.warn(problem);
        }
    }
}

/// The kernel refuses more; lists say first, and with a place, that they are too long.
void LanguageRun::limit_memory() {
    const std::size_t bytes = static_cast<std::size_t>(options_.memory_limit) << 20;
    auto& most = request_.limits.list_elements;
    most = std::min(most, bytes / sizeof(csg::scad::Value) / 2);
    // The deep stack counts whole, although it is reserved and not used.
    constexpr std::size_t kShareOfStack = 4;
    auto& stack = request_.limits.stack_bytes;
    stack = std::min(stack, bytes / kShareOfStack);
    hold_memory_limit();
}

void LanguageRun::hold_memory_limit() const {
    if (options_.memory_limit != 0) {
        ui::limit_memory(static_cast<std::size_t>(options_.memory_limit) << 20);
    }
}

/// As OpenSCAD does, goes on with the file's own values where the set is not to be had. -D counts above a set.
void LanguageRun::take_parameter_set() {
    auto text = csg::scad::read_source_file(options_.parameter_file);
    if (const auto* error = std::get_if<csg::scad::ReadError>(&text)) {
        messages_.warn(fmt::format("Can't open parameter file: {}", error->text));
        return;
    }
    std::vector<std::string> statements;
    if (csg::scad::has_statements(request_.definitions)) {
        statements.swap(request_.definitions);  // They say nothing of parameters, and are no part of the file yet.
    }
    const auto sets = read_parameter_sets(std::get<std::string>(text));
    if (!sets) {
        messages_.warn(fmt::format("Parameter file '{}' holds no parameter sets", options_.parameter_file));
    } else if (const auto set = std::ranges::find(*sets, options_.parameter_set, &ParameterSet::name);
               set == sets->end()) {
        messages_.warn(
            fmt::format("There is no parameter set '{}' in '{}'", options_.parameter_set, options_.parameter_file));
    } else {
        const std::vector<std::string> definitions = load()->look(
            [&](const auto& syntax) { return definitions_of(csg::scad::customizer_parameters(syntax), *set); });
        request_.definitions.insert(request_.definitions.begin(), definitions.begin(), definitions.end());
    }
    request_.definitions.insert(request_.definitions.end(), std::make_move_iterator(statements.begin()),
                                std::make_move_iterator(statements.end()));
}

bool LanguageRun::evaluate() {
    progress_.say("Evaluating…");
    request_.stop = limit_.token();
    const auto show = [this](const auto& message, const auto& sources) {
        progress_.say("");
        messages_.add(message, sources);
        return messages_.warnings();
    };
    run_ = loaded_ ? runner_.run(request_, options_.hard_warnings, show)
                   : runner_.run_once(request_, options_.hard_warnings, show);
    if (limit_.passed() && run_.evaluation.stopped) {
        limit_.tell();
        return false;
    }
    if (options_.memory_limit != 0 && run_.evaluation.out_of_memory) {
        print_error(fmt::format("--memory-limit: the evaluation needs more than {} MiB", options_.memory_limit));
    }
    write_outputs(options_, Format::Echo, messages_.echo_text());
    return run_.good();
}

ProgramRun LanguageRun::run_at(double time) {
    csg::scad::Request request = request_;
    request.time = time;
    ProgramRun run = runner_.run(std::move(request), false, [this](const auto& message, const auto& sources) {
        if (message.severity == csg::scad::Severity::Error) {
            messages_.add(message, sources);
        }
        return messages_.warnings();
    });
    base::end_if_asked(limit_.token());
    return run;
}

std::shared_ptr<const csg::Tree> LanguageRun::evaluate_at(double time) {
    const ProgramRun run = run_at(time);
    return run.good() ? run.evaluation.tree : nullptr;
}

csg::scad::ViewSettings LanguageRun::view_at(double time) {
    return run_at(time).evaluation.view;
}

std::shared_ptr<const csg::Tree> LanguageRun::evaluate_text(const std::string& text) {
    csg::scad::Request request = request_;
    request.text = text + appended_;
    const ProgramRun run =
        runner_.run(std::move(request), false, [this](const auto&, const auto&) { return messages_.warnings(); });
    base::end_if_asked(limit_.token());
    return run.good() ? run.evaluation.tree : nullptr;
}

std::shared_ptr<const csg::Tree> LanguageRun::evaluate_other(const std::string& path) {
    csg::scad::Request request = request_;
    request.path = path;
    request.text = read_source(path);
    const ProgramRun other =
        runner_.run_once(std::move(request), options_.hard_warnings, [this](const auto& message, const auto& sources) {
            messages_.add(message, sources);
            return messages_.warnings();
        });
    if (limit_.passed() && other.evaluation.stopped) {
        limit_.tell();
        return nullptr;
    }
    return other.good() ? other.evaluation.tree : nullptr;
}

/// The text has been read: there is a program.
std::shared_ptr<csg::scad::LoadedProgram> LanguageRun::load() {
    loaded_ = true;
    return runner_.load(request_, {});
}

void LanguageRun::write_tree() const {
    for (const Output& output : options_.outputs) {
        if (output.format == Format::Csg) {
            OutputFile file(output.path);
            csg::scad::write_csg(*run_.evaluation.tree, [&file](std::string_view piece) { file.write(piece); });
            file.finish();
        }
    }
}

void LanguageRun::write_dependencies() const {
    if (options_.dependencies) {
        std::vector<std::string> targets;
        for (const Output& output : options_.outputs) {
            targets.push_back(output.path);
        }
        write_output(*options_.dependencies, dependency_rules(targets, run_.evaluation.files));
    }
}

namespace {

/// Of what pictures need, a run that makes none checks all the same, which the whole program does.
bool language_is_enough(const Options& options) {
    const Options untouched;
    const auto is_text = [](const Output& output) {
        return output.format == Format::Ast || output.format == Format::Param || output.format == Format::Echo ||
               output.format == Format::Csg || output.format == Format::Term;
    };
    const auto to_standard_output = [](const Output& output) { return output.path == "-"; };
    return !options.outputs.empty() && std::all_of(options.outputs.begin(), options.outputs.end(), is_text) &&
           std::count_if(options.outputs.begin(), options.outputs.end(), to_standard_output) <= 1 &&
           !options.input.empty() && options.input != "-" && !options.statistics && !options.summary &&
           !options.summary_file && !options.information && !options.pick && !options.measure && options.frames == 0 &&
           options.picture.layers == untouched.picture.layers && options.picture_texts == untouched.picture_texts;
}

/// Whatever is asked, another program must answer.
class MeasuresElsewhere final : public csg::scad::Measures {
  public:
    explicit MeasuresElsewhere(std::function<void()> hand_over) : hand_over_(std::move(hand_over)) {}
    std::optional<csg::TextMetrics> text(const csg::Text&, csg::scad::MeasureWarnings&) override {
        hand_over_();
        return std::nullopt;
    }
    std::optional<csg::FontMetrics> font(const csg::Text&, csg::scad::MeasureWarnings&) override {
        hand_over_();
        return std::nullopt;
    }
    std::optional<double> dimension(const csg::scad::DrawingQuery&, csg::scad::MeasureWarnings&) override {
        hand_over_();
        return std::nullopt;
    }
    std::optional<glm::dvec2> cross(const csg::scad::DrawingQuery&, csg::scad::MeasureWarnings&) override {
        hand_over_();
        return std::nullopt;
    }

  private:
    std::function<void()> hand_over_;
};

std::optional<int> run_or_throw(const std::vector<std::string>& arguments,
                                const std::function<void(std::size_t said)>& hand_over) {
    if (arguments.empty() || arguments[0] == "compare" || arguments[0] == "check" || arguments[0] == "move" ||
        arguments[0] == "motion") {
        return std::nullopt;
    }
    const CommandLine line = read_command_line(arguments);
    if (line.text) {
        write_output("-", *line.text);
        return 0;
    }
    if (!language_is_enough(line.options)) {
        return std::nullopt;
    }
    const Messages* said = nullptr;
    TimeLimit limit(line.options.time_limit);
    LanguageRun run(line.options, limit, std::make_shared<MeasuresElsewhere>([&] {
                        setenv(TimeLimit::kSpent, fmt::format("{}", limit.spent()).c_str(), 1);
                        hand_over(said->count());
                    }));
    said = &run.messages();
    run.read();
    if (!run()) {
        return 1;
    }
    run.write_dependencies();
    limit.end();
    return 0;
}

}  // namespace

std::optional<int> run_language(const std::vector<std::string>& arguments,
                                const std::function<void(std::size_t said)>& hand_over) {
    return or_error(arguments, [&] { return run_or_throw(arguments, hand_over); });
}

}  // namespace ui
