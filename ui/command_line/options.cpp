#include "ui/command_line/options.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "layers/limits.h"
#include "ui/command_line/medium_options.h"
#include "ui/command_line/option_declarations.h"
#include "ui/command_line/option_values.h"
#include "ui/command_line/section_text.h"
#include "ui/command_line/transparency_options.h"
#include "ui/pipeline/part_style_rule.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

constexpr int kLargestSide = 16384;

std::vector<std::pair<std::string, const goldfeather::EngineInfo*>> engine_names() {
    std::vector<std::pair<std::string, const goldfeather::EngineInfo*>> names{{"auto", nullptr}};
    for (const goldfeather::EngineInfo& engine : goldfeather::engines()) {
        names.emplace_back(engine.name, &engine);
    }
    return names;
}

void interpret_limits(Options& o, const RawOptions& raw) {
    constexpr int kMostMebibytes = 1 << 24, kDeepestTrace = 1'000'000;
    const auto on = [](const char* option, const std::string& text, bool otherwise) {
        return text.empty()
                   ? otherwise
                   : read_name<bool>(
                         option, text,
                         {{"on", true}, {"off", false}, {"true", true}, {"false", false}, {"1", true}, {"0", false}});
    };
    o.check_parameters = on("--check-parameters", raw.check_parameters, o.check_parameters);
    o.check_ranges = on("--check-parameter-ranges", raw.check_ranges, o.check_ranges);
    o.trace_parameters = on("--trace-usermodule-parameters", raw.trace_parameters, o.trace_parameters);
    const auto enabled = [&raw](std::string_view name) {
        return std::any_of(raw.features.begin(), raw.features.end(),
                           [name](const std::string& feature) { return feature == name || feature == "all"; });
    };
    o.by_error = enabled("discretization-by-error");
    o.lazy_union = enabled("lazy-union");
    if (!raw.trace_depth.empty()) {
        o.trace_depth = read_integer("--trace-depth", raw.trace_depth, 0, kDeepestTrace);
    }
    if (!raw.memory_limit.empty()) {
        o.memory_limit = read_integer("--memory-limit", raw.memory_limit, 1, kMostMebibytes);
    }
    if (!raw.time_limit.empty()) {
        constexpr double kLongest = 1e9;
        o.time_limit = read_numbers("--time-limit", raw.time_limit, {1}, "seconds")[0];
        if (o.time_limit <= 0 || o.time_limit > kLongest) {
            throw UsageError(fmt::format("--time-limit {}: the time must be above 0 and at most {:.0f} seconds",
                                         raw.time_limit, kLongest));
        }
    }
}

double read_in_range(const std::string& option, const std::string& text, double least, double most) {
    const double number = read_numbers(option, text, {1}, "a number")[0];
    if (!(number >= least && number <= most)) {
        throw UsageError(fmt::format("{} {}: a number from {} to {}", option, text, least, most));
    }
    return number;
}

void interpret_engine(Options& o, const RawOptions& raw) {
    o.engine.engine = read_name<const goldfeather::EngineInfo*>("--engine", raw.engine, engine_names());
    o.context = read_name<std::optional<gl::ContextKind>>("--context", raw.context,
                                                          {{"auto", gl::ContextKind::Auto},
                                                           {"egl", gl::ContextKind::Egl},
                                                           {"osmesa", gl::ContextKind::Osmesa},
                                                           {"none", std::nullopt}});
    if (!raw.memory_budget.empty()) {
        constexpr int kMostMebibytes = 1 << 20;
        o.engine.memory_budget =
            static_cast<std::size_t>(read_integer("--memory-budget", raw.memory_budget, 1, kMostMebibytes)) << 20;
    }
    if (!raw.minimal_fraction.empty()) {
        o.engine.minimal_fraction = read_numbers("--minimal-fraction", raw.minimal_fraction, {1}, "a share")[0];
        if (o.engine.minimal_fraction < 0 || o.engine.minimal_fraction > 1) {
            throw UsageError(fmt::format("--minimal-fraction {}: a share is from 0 to 1", raw.minimal_fraction));
        }
    }
}

PickOptions read_pick(const RawOptions& raw, glm::ivec2 size) {
    PickOptions pick;
    const auto n = read_numbers("--at", raw.at, {2}, "x,y");
    for (int i = 0; i < 2; ++i) {
        const double pixel = n[static_cast<std::size_t>(i)];
        if (pixel != std::floor(pixel) || pixel < 0 || pixel >= size[i]) {
            throw UsageError(
                fmt::format("--at {}: expected whole numbers, from 0,0 to {},{} in a picture of {} × {} "
                            "pixels (--imgsize)",
                            raw.at, size.x - 1, size.y - 1, size.x, size.y));
        }
        pick.at[i] = static_cast<int>(pixel);
    }
    pick.json = !raw.format.empty() && read_name<bool>("--format", raw.format, {{"text", false}, {"json", true}});
    return pick;
}

/// The frames of this run's share: as many as of the others, or one more or less.
void interpret_animation(Options& o, const RawOptions& raw) {
    constexpr int kMostFrames = 10'000'000;
    if (raw.animate.empty() && raw.turntable.empty()) {
        if (!raw.sharding.empty()) {
            throw UsageError("--animate_sharding: there is no --animate");
        }
        return;
    }
    if (!raw.animate.empty() && !raw.turntable.empty()) {
        throw UsageError("--turntable and --animate are two films; write one after the other");
    }
    o.turntable = !raw.turntable.empty();
    const char* const option = o.turntable ? "--turntable" : "--animate";
    o.frames = read_integer(option, o.turntable ? raw.turntable : raw.animate, 1, kMostFrames);
    o.end_frame = o.frames;
    if (!raw.sharding.empty()) {
        const std::size_t slash = raw.sharding.find('/');
        if (slash == std::string::npos) {
            throw UsageError(fmt::format("--animate_sharding {}: expected I/M", raw.sharding));
        }
        const int shares = read_integer("--animate_sharding", raw.sharding.substr(slash + 1), 1, kMostFrames);
        const int share = read_integer("--animate_sharding", raw.sharding.substr(0, slash), 1, shares);
        o.first_frame = static_cast<int>(std::int64_t{o.frames} * (share - 1) / shares);
        o.end_frame = static_cast<int>(std::int64_t{o.frames} * share / shares);
    }
    if (o.outputs.empty() ||
        std::any_of(o.outputs.begin(), o.outputs.end(), [](const auto& a) { return a.path == "-"; })) {
        throw UsageError(fmt::format("{}: frames go to files, which -o is to name", option));
    }
    if (o.turntable &&
        std::any_of(o.outputs.begin(), o.outputs.end(), [](const auto& a) { return !is_picture(a.format); })) {
        throw UsageError("--turntable: frames are pictures, -o FILE.png or a film, -o FILE.apng");
    }
    if (!raw.sharding.empty() &&
        std::any_of(o.outputs.begin(), o.outputs.end(), [](const auto& a) { return is_film(a.format); })) {
        throw UsageError("--animate_sharding: a film is one file; share out frames, -o FILE.png");
    }
}

void interpret_motion(Options& o, const RawOptions& raw) {
    if (!raw.frame_rate.empty()) {
        o.frames_per_second = read_numbers("--fps", raw.frame_rate, {1}, "a number")[0];
        if (!(o.frames_per_second >= 0.02 && o.frames_per_second <= 1000)) {
            throw UsageError(fmt::format("--fps {}: expected a number from 0.02 to 1000", raw.frame_rate));
        }
    }
    if (!raw.time.empty()) {
        if (!raw.animate.empty()) {
            throw UsageError("--time: the frames of --animate have their own times");
        }
        o.time = read_numbers("--time", raw.time, {1}, "a number")[0];
    }
    if (!raw.storyboard.empty()) {
        constexpr int kMostPanels = 100;
        o.storyboard = read_integer("--storyboard", raw.storyboard, 1, kMostPanels);
        if (o.frames != 0 || !raw.time.empty()) {
            throw UsageError("--storyboard has times of its own; leave --animate, --turntable and --time out");
        }
        if (o.outputs.empty() ||
            std::any_of(o.outputs.begin(), o.outputs.end(), [](const auto& a) { return a.format != Format::Png; })) {
            throw UsageError("--storyboard is of pictures, -o FILE.png");
        }
    }
    for (const std::string& text : raw.depictions) {
        try {
            o.depictions.push_back(read_depiction(text));
        } catch (const std::runtime_error& problem) {
            throw UsageError(fmt::format("--depict: {}", problem.what()));
        }
    }
}

/// After the outputs.
void check_annotations(const Options& o) {
    if (!o.annotations.any()) {
        return;
    }
    if (!o.plan.empty() || o.thickness) {
        throw UsageError(
            "--label, --callouts and --arrow are for one view of the model; leave --plan and --thickness out");
    }
    if (!o.outputs.empty() &&
        std::none_of(o.outputs.begin(), o.outputs.end(), [](const auto& a) { return is_picture(a.format); })) {
        throw UsageError("--label, --callouts and --arrow are of pictures: write one with -o FILE.png");
    }
}

/// After all else that a plan does not go with.
void interpret_plan(Options& o, const RawOptions& raw) {
    if (raw.plan.empty()) {
        return;
    }
    try {
        o.plan = read_plan(raw.plan);
    } catch (const std::invalid_argument& e) {
        throw UsageError(fmt::format("--plan: {}", e.what()));
    }
    if (o.camera || o.turntable || o.storyboard != 0 || o.thickness || o.pick || o.marks.any()) {
        throw UsageError(
            "--plan has views of its own; leave out --camera, --turntable, --storyboard, --thickness, pick, and --view "
            "but for centers");
    }
    if (o.outputs.empty() ||
        std::any_of(o.outputs.begin(), o.outputs.end(), [](const auto& a) { return a.format == Format::Exr; })) {
        throw UsageError("--plan is of pictures, -o FILE.png");
    }
}

/// OpenSCAD's view options.
void interpret_view(Options& o, const RawOptions& raw) {
    for (std::size_t begin = 0; begin < raw.view.size();) {
        const std::size_t end = std::min(raw.view.find(',', begin), raw.view.size());
        using Show = void (*)(Options&);
        read_name<Show>("--view", raw.view.substr(begin, end - begin),
                        {{"axes", [](Options& to) { to.marks.axes = true; }},
                         {"centers", [](Options& to) { to.marks.centers = true; }},
                         {"crosshairs", [](Options& to) { to.marks.crosshairs = true; }},
                         {"edges", [](Options& to) { to.marks.edges = true; }},
                         {"scales", [](Options& to) { to.marks.scales = true; }}})(o);
        begin = end + 1;
    }
}

void interpret_transparency(npr::Picture& picture, const RawOptions& raw) {
    read_transparency(picture, raw.transparency);
    read_blend(picture, raw.blend);
    for (const std::string& medium : raw.media) {
        picture.media.push_back(read_medium(medium));
    }
    if (!raw.medium_light.empty()) {
        picture.medium_light = read_medium_light(raw.medium_light);
    }
    if (picture.transparency != npr::Transparency::Volume && !(raw.media.empty() && raw.medium_light.empty())) {
        throw UsageError("--medium and --medium-light are for --transparency volume");
    }
}

ThicknessRequest read_thickness(const std::string& text) {
    const std::size_t equals = text.find('=');
    using What = ThicknessRequest::What;
    auto request = read_name<ThicknessRequest>("--thickness", text.substr(0, equals),
                                               {{"wall", {What::Wall, false, {}}},
                                                {"gap", {What::Gap, false, {}}},
                                                {"wall-along-view", {What::Wall, true, {}}},
                                                {"gap-along-view", {What::Gap, true, {}}}});
    if (equals != std::string::npos) {
        request.range = read_numbers("--thickness range", text.substr(equals + 1), {1}, "a length")[0];
        if (*request.range <= 0) {
            throw UsageError(fmt::format("--thickness {}: the range is above 0", text));
        }
    }
    return request;
}

/// What is written or read by that name, whatever links lead there.
std::filesystem::path file_behind(const std::string& path) {
    std::error_code error;
    std::filesystem::path file = std::filesystem::absolute(path, error);
    if (!error) {
        file = std::filesystem::weakly_canonical(file, error);
    }
    return error ? std::filesystem::path(path).lexically_normal() : file;
}

/// Two outputs of one name would be one of them.
void refuse_equal_outputs(const Options& o) {
    std::vector<std::string> paths;
    for (const Output& output : o.outputs) {
        paths.push_back(output.path);
    }
    for (const auto& path : {o.statistics, o.summary_file, o.dependencies}) {
        if (path) {
            paths.push_back(*path);
        }
    }
    std::set<std::filesystem::path> known;
    for (const std::string& path : paths) {
        if (path != "-" && !path.starts_with("/dev/") && !known.insert(file_behind(path)).second) {
            throw UsageError(fmt::format("{} is to be written twice", path));
        }
    }
    if (!o.input.empty() && known.contains(file_behind(o.input))) {
        throw UsageError(fmt::format("{} is the input and an output", o.input));
    }
}

void interpret(Options& o, const RawOptions& raw) {
    if (raw.inputs.size() > 1) {
        throw UsageError(fmt::format("one input file is expected, not {} (\"{}\" and \"{}\")", raw.inputs.size(),
                                     raw.inputs[0], raw.inputs[1]));
    }
    const auto is_python = [](const std::string& path) { return path.ends_with(".py"); };
    if (raw.trust_python || std::any_of(raw.inputs.begin(), raw.inputs.end(), is_python)) {
        throw UsageError("models in Python are not supported: csgscope runs .scad files only");
    }
    interpret_limits(o, raw);
    o.input = raw.inputs.empty() ? "" : raw.inputs[0];
    for (const std::string& path : raw.outputs) {
        o.outputs.push_back(read_output(path, raw.export_format));
    }
    const auto split = [](const char* option, const std::string& text) {
        const std::size_t equals = text.find('=');
        if (equals == 0 || equals == std::string::npos) {
            throw UsageError(fmt::format("{} {}: expected name=value", option, text));
        }
        return std::pair(text.substr(0, equals), text.substr(equals + 1));
    };
    for (const std::string& setting : raw.settings) {
        o.picture_texts.settings.push_back(split("--set", setting));
    }
    if (!raw.size.empty()) {
        o.picture.size = read_size(raw.size, {2}, 1, kLargestSide);
    }
    o.projection = read_name<base::Projection>("--projection", raw.projection,
                                               {{"p", base::Projection::Perspective},
                                                {"o", base::Projection::Orthographic},
                                                {"perspective", base::Projection::Perspective},
                                                {"ortho", base::Projection::Orthographic},
                                                {"orthographic", base::Projection::Orthographic}});
    if (!raw.camera.empty()) {
        o.camera = read_camera(raw.camera, o.view_all);
        o.camera->projection = o.projection;
    }
    if (!raw.scheme.empty()) {
        o.picture_texts.scheme = raw.scheme;
    }
    if (!raw.layers.empty()) {
        o.picture.layers =
            raw.layers == "all" ? npr::kAllLayersWanted : read_integer("--layers", raw.layers, 1, layers::kMostLayers);
    }
    if (!raw.parts.empty()) {
        o.parts = read_parts(raw.parts);
    }
    o.picture.sections = read_sections(raw.sections, raw.uncut, raw.hatching);
    std::vector<std::string> named = o.picture_texts.part_styles;
    named.insert(named.end(), o.picture_texts.reveal.begin(), o.picture_texts.reveal.end());
    for (const std::string& label : o.annotations.labels) {
        named.push_back(split_label(label).first);
    }
    if (raw.parts.empty() && (!named.empty() || o.annotations.callouts)) {
        o.parts = parts_of_styles(named);
    } else if (raw.parts.empty() && !o.picture.sections.cuts.empty()) {
        o.parts.kind = csg::PartRule::Kind::Color;  // Cut faces have the color of what was cut.
    }
    if (!raw.at.empty()) {
        o.pick = read_pick(raw, o.picture.size);
    }
    if (o.measure) {
        o.measure = read_measure(raw.of, raw.between, raw.other, raw.value, raw.format, o.picture.size);
    }
    if (!raw.dpi.empty()) {
        o.picture.dots_per_inch = read_in_range("--dpi", raw.dpi, 1, 100'000);
    }
    if (!raw.margin.empty()) {
        o.margin = read_in_range("--margin", raw.margin, 0, 45) / 100;
    }
    if (!raw.samples.empty()) {
        o.picture.samples = read_name<int>("--samples", raw.samples,
                                           {{"1", 1}, {"4", 4}, {"8", 8}, {"16", 16}, {"64", 64}, {"256", 256}});
    }
    if (!raw.thickness.empty()) {
        o.thickness = read_thickness(raw.thickness);
    }
    interpret_transparency(o.picture, raw);
    interpret_engine(o, raw);
    interpret_animation(o, raw);
    interpret_motion(o, raw);
    interpret_view(o, raw);
    interpret_plan(o, raw);
    check_annotations(o);
    const auto given = [](const std::string& path) { return path.empty() ? std::nullopt : std::optional(path); };
    o.statistics = given(raw.statistics);
    o.summary_file = given(raw.summary_file);
    o.dependencies = given(raw.dependencies);
    refuse_equal_outputs(o);
    o.summary = !raw.summary.empty();
    o.summary_parts = read_summary_parts(raw.summary);
    if (!raw.precision.empty()) {
        o.precision = read_numbers("--precision", raw.precision, {1}, "a share")[0];
        if (o.precision <= 0 || o.precision > 1) {
            throw UsageError(fmt::format("--precision {}: a share is above 0 and at most 1", raw.precision));
        }
    }
    o.exports = read_export_options(raw.export_options);
    o.preview = raw.render.empty() || !raw.preview.empty();
    if (raw.samples.empty() && !o.preview && o.picture_texts.style == "shaded") {
        o.picture.samples = 1;  // As OpenSCAD's.
    }
}

/// Of a command line that holds nothing but paths, outputs after -o; false, and nothing, of another. To set up the
/// table of all options takes as long as to evaluate a small model.
bool read_paths(const std::vector<std::string>& arguments, RawOptions& raw) {
    const auto is_path = [](const std::string& argument) { return !argument.empty() && argument[0] != '-'; };
    RawOptions read;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool output = arguments[i] == "-o" && ++i < arguments.size();
        if (i == arguments.size() || !is_path(arguments[i])) {
            return false;
        }
        (output ? read.outputs : read.inputs).push_back(arguments[i]);
    }
    raw = std::move(read);
    return true;
}

/// The first argument, where it is one.
struct Command {
    std::string name;
    const char* text;  ///< For the help.
    void (*declare)(OptionTable&, Options&, RawOptions&, const std::string&);
};

const Command& command_of(const std::vector<std::string>& arguments) {
    static const Command kCommands[]{
        {"pick",
         "csgscope pick tells which surfaces lie behind a pixel of the model's picture, and from where in the text "
         "each comes.",
         declare_pick},
        {"measure",
         "csgscope measure tells distances, angles, radii and diameters of faces, edges and points of a model.",
         declare_measure},
        {"",
         "csgscope draws OpenSCAD models: shaded, as a blueprint, as a sketch or as an X-ray.\n"
         "csgscope pick tells what lies behind a pixel, csgscope measure distances and radii, csgscope check looks "
         "for faults, csgscope motion tells what moves, csgscope move moves a solid in the text, csgscope compare "
         "compares with a mesh: each has a --help of "
         "its own.",
         declare}};
    return *std::find_if(std::begin(kCommands), std::end(kCommands) - 1,
                         [&](const Command& command) { return !arguments.empty() && arguments[0] == command.name; });
}

}  // namespace

csg::PartRule read_parts(const std::string& text) {
    constexpr int kDeepest = 1'000'000;
    const std::size_t equals = text.find('=');
    const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
    csg::PartRule rule;
    if (text.starts_with("depth=")) {
        rule.kind = csg::PartRule::Kind::Depth;
        rule.depth = static_cast<unsigned>(read_integer("--parts depth", value, 1, kDeepest));
    } else if (text.starts_with("module=")) {
        rule.kind = csg::PartRule::Kind::Module;
        rule.modules = names_of(value);
        if (rule.modules.empty()) {
            throw UsageError(fmt::format("--parts {}: expected module=NAME[,NAME]", text));
        }
    } else {
        rule.kind = read_name<csg::PartRule::Kind>("--parts", text,
                                                   {{"model", csg::PartRule::Kind::Model},
                                                    {"top", csg::PartRule::Kind::Depth},
                                                    {"color", csg::PartRule::Kind::Color},
                                                    {"depth=N", csg::PartRule::Kind::Depth},
                                                    {"module=NAME[,NAME]", csg::PartRule::Kind::Module}});
    }
    return rule;
}

bool wants(const Options& options, Format format) {
    return std::any_of(options.outputs.begin(), options.outputs.end(),
                       [&](const Output& output) { return output.format == format; });
}

bool needs_geometry(const Options& options) {
    const bool told = options.summary || options.summary_file;
    return wants(options, Format::Mesh) || wants(options, Format::Drawing) ||
           (told && (options.summary_parts.needs_geometry() || (options.summary_parts.all && options.outputs.empty())));
}

CommandLine read_command_line(const std::vector<std::string>& arguments, const std::string& styles) {
    CommandLine line;
    RawOptions raw;
    const Command& command = command_of(arguments);
    if (command.name.empty() && read_paths(arguments, raw)) {
        interpret(line.options, raw);
        return line;
    }
    OptionTable table(command.text, command.name.empty() ? "csgscope" : fmt::format("csgscope {}", command.name));
    table.lay_out_help("Other", 34);
    command.declare(table, line.options, raw, styles);
    if (command.name == "measure") {
        line.options.measure.emplace();
    }
    try {
        if (!table.read({arguments.begin() + (command.name.empty() ? 0 : 1), arguments.end()})) {
            if (!styles.empty()) {
                line.text = table.help();
            }
            return line;
        }
    } catch (const UnknownOption& unknown) {
        throw UsageError(fmt::format("unknown option {}.{}", unknown.name(),
                                     suggestion(unknown.name(), table.long_names(), " See csgscope --help.")));
    }
    table.refuse_empty_values();
    if (raw.version) {
        line.text = "csgscope version " CSGSCOPE_VERSION "\n";
        return line;
    }
    if (raw.help_export) {
        line.text = export_options_help();
        return line;
    }
    interpret(line.options, raw);
    return line;
}

}  // namespace ui
