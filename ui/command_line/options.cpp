#include "ui/command_line/options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

constexpr int kLargestSide = 16384;
constexpr int kMostLayers = 65535;
using csg::solid::DrawingFormat;
struct NamedFormat {
    std::string_view name;
    Format format;
    MeshFormat mesh = MeshFormat::AsciiStl;
    DrawingFormat drawing = DrawingFormat::Svg;
};
const std::array<NamedFormat, 16> kFormats{{{"png", Format::Png},
                                            {"stl", Format::Mesh},
                                            {"asciistl", Format::Mesh},
                                            {"binstl", Format::Mesh, MeshFormat::BinaryStl},
                                            {"off", Format::Mesh, MeshFormat::Off},
                                            {"obj", Format::Mesh, MeshFormat::Obj},
                                            {"amf", Format::Mesh, MeshFormat::Amf},
                                            {"3mf", Format::Mesh, MeshFormat::ThreeMf},
                                            {"wrl", Format::Mesh, MeshFormat::Wrl},
                                            {"svg", Format::Drawing},
                                            {"dxf", Format::Drawing, {}, DrawingFormat::Dxf},
                                            {"pdf", Format::Drawing, {}, DrawingFormat::Pdf},
                                            {"csg", Format::Csg},
                                            {"ast", Format::Ast},
                                            {"echo", Format::Echo},
                                            {"param", Format::Param}}};
constexpr const char* kFormatNames =
    "png, stl, asciistl, binstl, off, obj, amf, 3mf, wrl, svg, dxf, pdf, csg, ast, echo and param";

/// The numbers of "1,2.5,-3", `counts` of them; the decimal point does not depend on the locale.
std::vector<double> read_numbers(std::string_view option, std::string_view text,
                                 std::initializer_list<std::size_t> counts, std::string_view meaning) {
    std::vector<double> numbers;
    bool good = true;
    for (const char *at = text.data(), *end = at + text.size(); good;) {
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        good = error == std::errc{} && std::isfinite(value) && (next == end || *next == ',');
        numbers.push_back(value);
        if (!good || next == end) {
            break;
        }
        at = next + 1;
    }
    if (!good || std::find(counts.begin(), counts.end(), numbers.size()) == counts.end()) {
        throw UsageError(fmt::format("{} {}: expected {}", option, text, meaning));
    }
    return numbers;
}

int read_integer(std::string_view option, std::string_view text, int lowest, int highest) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < lowest || value > highest) {
        throw UsageError(fmt::format("{} {}: expected a whole number from {} to {}", option, text, lowest, highest));
    }
    return value;
}

template <typename Value>
Value read_name(std::string_view option, const std::string& text,
                const std::vector<std::pair<std::string, Value>>& values) {
    std::vector<std::string> names;
    for (const auto& [name, value] : values) {
        if (name == text) {
            return value;
        }
        names.push_back(name);
    }
    throw UsageError(
        fmt::format("{} {}: expected {}.{}", option, text, fmt::join(names, ", "), suggestion(text, names)));
}

Output read_format(std::string_view option, const std::string& path, const std::string& text) {
    std::string name = text;
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const NamedFormat& known : kFormats) {
        if (name == known.name) {
            return {path, known.format, known.mesh, known.drawing};
        }
    }
    throw UsageError(fmt::format("{}: format \"{}\" is not supported; there are {}", option, text, kFormatNames));
}

Output read_output(const std::string& path, const std::string& export_format) {
    if (path.empty()) {
        throw UsageError("-o: the file's name is empty");
    }
    if (!export_format.empty()) {
        return read_format("--export-format", path, export_format);
    }
    if (path == "-") {
        throw UsageError("-o -: say the format of standard output with --export-format png, stl, csg, …");
    }
    const std::size_t dot = path.rfind('.');
    const std::size_t slash = path.rfind('/');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) {
        throw UsageError(fmt::format("-o {}: a suffix must tell the format: .png, .stl, .off, .3mf, .csg, …", path));
    }
    return read_format(fmt::format("-o {}", path), path, path.substr(dot + 1));
}

gl::Camera camera_of_numbers(std::string_view text) {
    const auto n = read_numbers("--camera", text, {6, 7},
                                "6 numbers eye_x,y,z,center_x,y,z or 7 numbers translate_x,y,z,rot_x,y,z,distance");
    if (n.size() == 6) {
        if (n[0] == n[3] && n[1] == n[4] && n[2] == n[5]) {
            throw UsageError(fmt::format("--camera {}: the eye and the centre are the same point", text));
        }
        return gl::camera_between({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
    }
    if (n[6] <= 0) {
        throw UsageError(fmt::format("--camera {}: the distance must be above 0", text));
    }
    gl::Camera camera;
    camera.target = {n[0], n[1], n[2]};
    camera.rotation = {n[3], n[4], n[5]};
    camera.distance = n[6];
    return camera;
}

/// The options as texts, as CLI11 gives them.
struct Raw {
    std::vector<std::string> inputs, outputs, settings, export_options;
    std::string export_format, camera, size, layers, samples, view, csg_limit, backend, render, preview, scheme;
    std::string check_parameters, check_ranges, trace_parameters, trace_depth, time_limit, memory_limit, memory_budget,
        minimal_fraction;
    std::string projection = "p", context = "auto", engine = "auto", statistics, summary_file, dependencies;
    std::vector<std::string> summary, features;
    bool version = false, help_export = false;
};

void declare(CLI::App& app, Options& o, Raw& raw) {
    // Values may hold commas and begin with '-': every option takes exactly the argument after it.
    const auto text = [&](const char* names, std::string& value, const char* help, const char* type,
                          const char* group) {
        return app.add_option(names, value, help)
            ->type_name(type)
            ->group(group)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    };
    const auto list = [&](const char* names, std::vector<std::string>& values, const char* help, const char* type,
                          const char* group) {
        return app.add_option(names, values, help)
            ->type_name(type)
            ->group(group)
            ->expected(1)
            ->allow_extra_args(false)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    const char* const in = "Input and output";
    app.add_option("file", raw.inputs, "The .scad file; - reads standard input")->type_name("");
    list("-o,--o", raw.outputs,
         "Write FILE: .png, .stl, .off, .obj, .amf, .3mf, .wrl, .svg, .dxf, .pdf, .csg, .ast, .echo or .param; - is "
         "standard output. May be repeated. Without it a window opens",
         "FILE", in);
    text("--export-format", raw.export_format,
         "The format of the outputs, whatever their suffix; also asciistl, binstl", "FORMAT", in);
    list("-O,--O", raw.export_options, "Set an option of a file format; may be repeated (--help-export)",
         "SECTION/KEY=VALUE", in);
    text("--cache", o.cache, "Keep meshes in this folder, and take them from there", "DIR", in);
    list("-D,--D", o.definitions, "Set a variable of the file: -D 'size=[1,2]'", "NAME=VALUE", in);
    text("-p,--p", o.parameter_file, "A file of parameter sets, as OpenSCAD's customizer writes it", "FILE", in);
    text("-P,--P", o.parameter_set, "The parameter set of that file to take", "NAME", in);
    text("-d,--d", raw.dependencies, "Write the files read as a rule for make", "FILE", in);
    text("-m,--m", o.make_command, "Run COMMAND FILE for each file that the model names and that is not there",
         "COMMAND", in);
    text("--stats", raw.statistics, "Write figures of the run as JSON; - is standard output", "FILE", in);
    text("--summary-file", raw.summary_file, "Write what --summary names (all) as JSON; - is standard output", "FILE",
         in);
    list("--summary", raw.summary, "Print all, cache, time, camera, geometry, bounding-box, area or volume", "WHAT",
         in);
    app.add_flag("-q,--quiet", o.quiet, "Print errors only")->group(in);
    app.add_flag("--hardwarnings", o.hard_warnings, "Stop at the first warning")->group(in);

    const char* const checks = "Limits and checks";
    text("--time-limit", raw.time_limit, "End evaluation and drawing with an error after that time", "SECONDS", checks);
    text("--memory-limit", raw.memory_limit, "End with an error where more memory would be needed", "MIB", checks);
    text("--check-parameters", raw.check_parameters,
         "Warn of arguments that user-defined functions and modules do not take: on or off (on)", "BOOL", checks);
    text("--check-parameter-ranges", raw.check_ranges, "Warn of dimensions that make nothing: on or off (off)", "BOOL",
         checks);
    text("--trace-depth", raw.trace_depth, "Steps shown at either end of a trace (12)", "N", checks);
    text("--trace-usermodule-parameters", raw.trace_parameters, "Parameters in traces: on or off (on)", "BOOL", checks);

    const char* const picture = "Picture";
    text("--imgsize", raw.size, "Width and height in pixels, 1 to 16384 (512,512)", "W,H", picture);
    text("--style", o.style, "shaded, edges, blueprint, xray or sketch (shaded)", "STYLE", picture);
    list("--set", raw.settings, "Set a parameter of the style; may be repeated", "NAME=VALUE", picture);
    text("--colorscheme", raw.scheme, "OpenSCAD's colour scheme (Cornfield)", "NAME", picture);
    text("--layers", raw.layers, "The first N surfaces behind each pixel, or all (what the style needs)", "N|all",
         picture);
    text("--samples", raw.samples,
         "Samples per pixel: 1, 4, 8 or 16 (4; as OpenSCAD 1, where it is to draw a shaded --render)", "N", picture);
    app.add_flag("--transparent-background", o.transparent_background, "No background")->group(picture);
    app.add_flag("--render", raw.render,
                 "Draw the result: $preview false, neither % nor # parts, outlines flat, framed exactly")
        ->group(picture);
    app.add_flag("--preview", raw.preview, "Evaluate with $preview true (default)")->group(picture);

    const char* const camera = "Camera";
    text("--camera", raw.camera, "x,y,z,rotx,roty,rotz,distance or eyex,y,z,centerx,y,z", "NUMBERS", camera);
    text("--projection", raw.projection, "o (orthographic) or p (perspective, default)", "o|p", camera);
    app.add_flag("--viewall", o.view_all, "Move the camera so that all is seen")->group(camera);
    app.add_flag("--autocenter", o.autocenter, "Look at the centre of the model")->group(camera);

    const char* const engine = "Engine";
    text("--engine", raw.engine, "auto, goldfeather, lists, lists-cpu or scs (auto)", "NAME", engine);
    text("--context", raw.context, "OpenGL from: auto, egl, osmesa or none (auto)", "NAME", engine);
    text("--memory-budget", raw.memory_budget, "Per-pixel state of the engines on OpenGL at once (128)", "MIB", engine);
    text("--minimal-fraction", raw.minimal_fraction,
         "Leave out layers that fewer than this share of the pixels have (0)", "SHARE", engine);
    text("--log-frames", o.frames_log, "Write one line of JSON for each frame that the window shows", "FILE", engine);

    const char* const other = "Other";
    app.add_flag("--help-export", raw.help_export, "Print the options of file formats")->group(other);
    app.add_flag("-v,--version", raw.version, "Print the version")->group(other);
    app.add_flag("--info", o.information, "Print version and OpenGL")->group(other);
    const char* const accepted = "Accepted for OpenSCAD's sake, without effect";
    text("--csglimit", raw.csg_limit, "Nothing is left out, however large the model", "N", accepted);
    text("--view", raw.view, "View options of OpenSCAD's window", "WHAT", accepted);
    text("--backend", raw.backend, "Geometry backend", "NAME", accepted);
    list("--enable", raw.features, "Features of OpenSCAD's language are always on", "FEATURE", accepted);
}

void interpret_limits(Options& o, const Raw& raw) {
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
    if (!raw.trace_depth.empty()) {
        o.trace_depth = read_integer("--trace-depth", raw.trace_depth, 0, kDeepestTrace);
    }
    if (!raw.memory_limit.empty()) {
        o.memory_limit = read_integer("--memory-limit", raw.memory_limit, 1, kMostMebibytes);
    }
    if (!raw.time_limit.empty()) {
        o.time_limit = read_numbers("--time-limit", raw.time_limit, {1}, "seconds")[0];
        if (o.time_limit <= 0 || o.time_limit > 1e9) {
            throw UsageError(fmt::format("--time-limit {}: the time must be above 0 seconds", raw.time_limit));
        }
    }
}

void interpret(Options& o, const Raw& raw) {
    if (raw.inputs.size() > 1) {
        throw UsageError(fmt::format("one input file is expected, not {} (\"{}\" and \"{}\")", raw.inputs.size(),
                                     raw.inputs[0], raw.inputs[1]));
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
    for (const std::string& definition : o.definitions) {
        (void)split("-D", definition);
    }
    for (const std::string& setting : raw.settings) {
        o.settings.push_back(split("--set", setting));
    }
    if (!raw.size.empty()) {
        const auto n = read_numbers("--imgsize", raw.size, {2}, "width,height");
        for (const double side : n) {
            if (side != std::floor(side) || side < 1 || side > kLargestSide) {
                throw UsageError(
                    fmt::format("--imgsize {}: a side is a whole number from 1 to {}", raw.size, kLargestSide));
            }
        }
        o.size = {static_cast<int>(n[0]), static_cast<int>(n[1])};
    }
    o.projection = read_name<gl::Projection>("--projection", raw.projection,
                                             {{"p", gl::Projection::Perspective},
                                              {"o", gl::Projection::Orthographic},
                                              {"perspective", gl::Projection::Perspective},
                                              {"ortho", gl::Projection::Orthographic},
                                              {"orthographic", gl::Projection::Orthographic}});
    if (!raw.camera.empty()) {
        o.camera = camera_of_numbers(raw.camera);
        o.camera->projection = o.projection;
    }
    if (!raw.scheme.empty()) {
        o.scheme = raw.scheme;
    }
    if (!raw.layers.empty()) {
        o.layers = raw.layers == "all" ? 0 : read_integer("--layers", raw.layers, 1, kMostLayers);
    }
    if (!raw.samples.empty()) {
        o.samples = read_name<int>("--samples", raw.samples, {{"1", 1}, {"4", 4}, {"8", 8}, {"16", 16}});
    }
    using goldfeather::EngineKind;
    o.engine.kind = read_name<std::optional<EngineKind>>("--engine", raw.engine,
                                                         {{"auto", std::nullopt},
                                                          {"goldfeather", EngineKind::Goldfeather},
                                                          {"lists", EngineKind::Lists},
                                                          {"lists-cpu", EngineKind::ListsCpu},
                                                          {"scs", EngineKind::Scs}});
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
    const auto given = [](const std::string& path) { return path.empty() ? std::nullopt : std::optional(path); };
    o.statistics = given(raw.statistics);
    o.summary_file = given(raw.summary_file);
    o.dependencies = given(raw.dependencies);
    o.summary = !raw.summary.empty();
    o.summary_parts = read_summary_parts(raw.summary);
    o.exports = read_export_options(raw.export_options);
    o.preview = raw.render.empty() || !raw.preview.empty();
    if (raw.samples.empty() && !o.preview && o.style == "shaded") {
        o.samples = 1;  // As OpenSCAD's.
    }
}

/// Of a command line that holds nothing but paths, outputs after -o; false, and nothing, of another. To set up the
/// table of all options takes as long as to evaluate a small model.
bool read_paths(const std::vector<std::string>& arguments, Raw& raw) {
    const auto is_path = [](const std::string& argument) { return !argument.empty() && argument[0] != '-'; };
    Raw read;
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

}  // namespace

bool wants(const Options& options, Format format) {
    return std::any_of(options.outputs.begin(), options.outputs.end(),
                       [&](const Output& output) { return output.format == format; });
}

bool needs_geometry(const Options& options) {
    const bool told = options.summary || options.summary_file;
    return wants(options, Format::Mesh) || wants(options, Format::Drawing) ||
           (told && (options.summary_parts.needs_geometry() || (options.summary_parts.all && options.outputs.empty())));
}

gl::Camera read_camera(std::string_view text) {
    return camera_of_numbers(text);
}

CommandLine read_command_line(const std::vector<std::string>& arguments) {
    CommandLine line;
    Raw raw;
    if (read_paths(arguments, raw)) {
        interpret(line.options, raw);
        return line;
    }
    CLI::App app("csgscope draws OpenSCAD models: shaded, as a blueprint, as a sketch or as an X-ray.", "csgscope");
    app.set_help_flag("-h,--help", "Print this help")->group("Other");
    app.get_formatter()->column_width(34);
    declare(app, line.options, raw);
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        line.text = app.help();
        return line;
    } catch (const CLI::ExtrasError&) {
        std::vector<std::string> names;
        for (const CLI::Option* option : app.get_options()) {
            for (const std::string& name : option->get_lnames()) {
                names.push_back("--" + name);
            }
        }
        const auto extra = app.remaining().empty() ? std::string() : app.remaining().front();
        const auto name = extra.substr(0, extra.find('='));
        throw UsageError(fmt::format("unknown option {}.{}", name, suggestion(name, names, " See csgscope --help.")));
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
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
