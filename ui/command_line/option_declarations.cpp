#include "ui/command_line/option_declarations.h"

#include <fmt/format.h>

#include "base/alternatives.h"
#include "goldfeather/engines.h"
#include "npr/transparency.h"

namespace ui {

namespace {

std::string transparency_help() {
    std::vector<std::string> names;
    for (const npr::TransparencyInfo& each : npr::transparencies()) {
        names.emplace_back(each.name);
    }
    return fmt::format("What is seen through parts that are not opaque: {} ({})", base::alternatives(names),
                       names.front());
}

/// Takes out what is of outputs, and what does not change which surfaces there are.
void remove_outputs(OptionTable& table) {
    for (const char* const name : {"-o",
                                   "--export-format",
                                   "-O",
                                   "--cache",
                                   "-d",
                                   "--stats",
                                   "--summary-file",
                                   "--summary",
                                   "--precision",
                                   "--style",
                                   "--style-of",
                                   "--reveal",
                                   "--set",
                                   "--animate",
                                   "--animate_sharding",
                                   "--turntable",
                                   "--storyboard",
                                   "--colorscheme",
                                   "--samples",
                                   "--thickness",
                                   "--label",
                                   "--callouts",
                                   "--arrow",
                                   "--dpi",
                                   "--transparency",
                                   "--blend",
                                   "--medium",
                                   "--medium-light",
                                   "--transparent-background",
                                   "--minimal-fraction",
                                   "--log-frames",
                                   "--help-export",
                                   "--version",
                                   "--info"}) {
        table.remove(name);
    }
}

}  // namespace

void declare(OptionTable& table, Options& o, RawOptions& raw, const std::string& styles) {
    // Values may hold commas and begin with '-': every option takes exactly the argument after it.
    const auto text = [&](const char* names, std::string& value, const char* help, const char* type,
                          const char* group) {
        table.add_last({names, help, type, group}, value);
    };
    const auto list = [&](const char* names, std::vector<std::string>& values, const char* help, const char* type,
                          const char* group) {
        table.add_each({names, help, type, group}, values);
    };
    const auto flag = [&](const char* names, auto& value, const char* help, const char* group) {
        table.add_flag({names, help, "", group}, value);
    };
    const char* const in = "Input and output";
    table.add_rest({"file", "The .scad file; - reads standard input"}, raw.inputs);
    list("-o,--o", raw.outputs,
         "Write FILE: .png, .apng, .gif, .webp, .exr, .stl, .off, .obj, .amf, .3mf, .wrl, .pov, .svg, .dxf, .pdf, "
         ".csg, .ast, .echo, .term "
         "or .param; - is standard output. May be repeated. Without it a window opens",
         "FILE", in);
    text("--export-format", raw.export_format,
         "The format of the outputs, whatever their suffix; also asciistl, binstl", "FORMAT", in);
    list("-O,--O", raw.export_options, "Set an option of a file format; may be repeated (--help-export)",
         "SECTION/KEY=VALUE", in);
    text("--cache", o.cache, "Keep meshes in this folder, and take them from there", "DIR", in);
    list("-D,--D", o.definitions, "Put a statement behind the file: -D 'size=[1,2]'", "STATEMENT", in);
    text("-p,--p", o.parameter_file, "A file of parameter sets, as OpenSCAD's customizer writes it", "FILE", in);
    text("-P,--P", o.parameter_set, "The parameter set of that file to take", "NAME", in);
    text("-d,--d", raw.dependencies, "Write the files read as a rule for make", "FILE", in);
    text("-m,--m", o.make_command, "Run COMMAND FILE for each file that the model names and that is not there",
         "COMMAND", in);
    text("--stats", raw.statistics, "Write figures of the run as JSON; - is standard output", "FILE", in);
    text("--summary-file", raw.summary_file, "Write what --summary names (all) as JSON; - is standard output", "FILE",
         in);
    list("--summary", raw.summary,
         "Print all (but parts and measures), cache, time, camera, geometry, bounding-box, area, volume, parts or "
         "measures",
         "WHAT", in);
    text("--precision", raw.precision,
         "Of --summary measures: the share of volume and area that their errors may be (0.01)", "SHARE", in);
    text("--animate", raw.animate,
         "Write each output N times, with $t from 0 on in steps of 1/N: x00000.png, x00001.png, … for -o x.png", "N",
         in);
    text("--turntable", raw.turntable,
         "Write each picture N times, the camera turned about the z axis in steps of 360/N degrees", "N", in);
    text("--animate_sharding", raw.sharding, "Of these, write the I-th of M shares only", "I/M", in);
    text("--fps", raw.frame_rate, "Frames that a film (-o x.apng, x.gif or x.webp) shows in a second (25)", "N", in);
    text("--storyboard", raw.storyboard,
         "Draw the model at N times, those at which its motion changes most, as panels of one picture", "N", in);
    text("--time", raw.time, "$t, where no frames are written (0)", "T", in);
    flag("-q,--quiet", o.quiet, "Print errors only", in);
    flag("--hardwarnings", o.hard_warnings, "Stop at the first warning", in);

    const char* const checks = "Limits and checks";
    text("--time-limit", raw.time_limit, "End with an error after that time, whatever is being done", "SECONDS",
         checks);
    text("--memory-limit", raw.memory_limit, "End with an error where more memory would be needed", "MIB", checks);
    text("--check-parameters", raw.check_parameters,
         "Warn of arguments that user-defined functions and modules do not take: on or off (on)", "BOOL", checks);
    text("--check-parameter-ranges", raw.check_ranges, "Warn of dimensions that make nothing: on or off (off)", "BOOL",
         checks);
    list("--enable", raw.features,
         "Experiments of OpenSCAD: discretization-by-error turns $fe on, lazy-union leaves groups of loops out, all "
         "both; the others are always on",
         "FEATURE", checks);
    text("--trace-depth", raw.trace_depth, "Steps shown at either end of a trace (12)", "N", checks);
    text("--trace-usermodule-parameters", raw.trace_parameters, "Parameters in traces: on or off (on)", "BOOL", checks);

    const char* const picture = "Picture";
    const std::string transparencies = transparency_help();
    text("--imgsize", raw.size, "Width and height in pixels, 1 to 16384 (512,512)", "W,H", picture);
    text("--dpi", raw.dpi, "Pixels per inch, 1 to 100000: the PNG tells it, and lengths in mm go by it (96, untold)",
         "N", picture);
    text("--style", o.picture_texts.style, styles.c_str(), "STYLE", picture);
    list("--style-of", o.picture_texts.part_styles,
         "Draw some parts in another style: 'part=NAME: STYLE,PARAMETER=VALUE,…', or color=COLOR or module=NAME for "
         "part=NAME; may be repeated",
         "STYLE", picture);
    list("--reveal", o.picture_texts.reveal,
         "Take the first layers of other parts away, until that share (1) of the parts NAME, color=COLOR or "
         "module=NAME is to be seen; may be repeated",
         "PART[,SHARE]", picture);
    text("--transparency", raw.transparency, transparencies.c_str(), "NAME[:KEY=VALUE,...]", picture);
    text("--blend", raw.blend,
         "In sorted: OpenGL's blend factors and equation; three more are those of alpha "
         "(src-alpha,one-minus-src-alpha,add,one,one-minus-src-alpha,add)",
         "SRC,DST[,EQUATION]", picture);
    list("--medium", raw.media,
         "In volume: what a part is made of, as 'PART: tau=0.3/mm, albedo=#aabbcc'; may be repeated", "MEDIUM",
         picture);
    text("--medium-light", raw.medium_light, "In volume: light from everywhere and from one side (0.5,0.5)",
         "AMBIENT,DIRECTIONAL", picture);
    list("--set", raw.settings, "Set a parameter of the style; may be repeated", "NAME=VALUE", picture);
    text("--colorscheme", raw.scheme, "OpenSCAD's color scheme (Cornfield)", "NAME", picture);
    text("--layers", raw.layers, "The first N surfaces behind each pixel, or all (what the style needs)", "N|all",
         picture);
    text("--parts", raw.parts,
         "What is a part: model (all of it), top (children of the top-level union), color, depth=N or "
         "module=NAME[,NAME] (model; with --section color; with --style-of or --reveal what they name, or top)",
         "RULE", picture);
    text("--changes-from", o.changes_from,
         "Draw what has changed since that version of the file: what is new green, what is gone red, the rest seen "
         "through",
         "FILE", picture);
    list("--depict", raw.depictions,
         "Draw what moves while $t runs into the picture: path, motion, still, ghost, rotation, collision, frame, "
         "speak, "
         "camera or auto, as 'path {PART} [0,1] (width=2)'; may be repeated",
         "EXPRESSION", picture);
    text("--depict-rules", o.depiction_rules,
         "The same by a file that has an expression on each line: what is to be drawn of bodies by their names", "FILE",
         picture);
    list("--label", o.annotations.labels,
         "Write a text beside the picture of a part, with a line to it: PART=TEXT, where PART is NAME, color=COLOR or "
         "module=NAME; may be repeated",
         "PART=TEXT", picture);
    flag("--callouts", o.annotations.callouts, "Number the parts, in circles, with a legend", picture);
    list("--arrow", o.annotations.arrows,
         "Draw an arrow along a smooth curve through points of the model, as '0,0,9:5,0,12:9,0,9 (width=1)'; may be "
         "repeated",
         "X,Y,Z:X,Y,Z[:X,Y,Z...]", picture);
    text("--explain", o.explain,
         "Draw what the difference or intersection at that place did: what it removed red, what it kept green",
         "[FILE:]LINE[:COLUMN]", picture);
    text("--without", o.without,
         "Draw the model without the call at that place: of differences the first operand, of transformations what "
         "is below",
         "[FILE:]LINE[:COLUMN]", picture);
    text("--thickness", raw.thickness,
         "Color faces by how thick the wall behind them is, or how wide the gap before them: wall, gap, "
         "wall-along-view or gap-along-view; with the range of the colors wall=MM",
         "WHAT", picture);
    list(
        "--section", raw.sections,
        "Cut away what is on the eye's side of a plane (z=12), on one side of it (z>12, z<12), where the normal points "
        "(plane([x,y,z],[nx,ny,nz])), inside box([x,y,z],[x,y,z]) or part:NAME, or half, quarter or eighth of the "
        "model before its middle; may be repeated",
        "WHAT", picture);
    list("--uncut", raw.uncut, "Parts that sections leave whole; may be repeated", "NAME[,NAME]", picture);
    text("--hatching", raw.hatching,
         "Distance of the lines of hatching on cut faces, in units of the model; 0: none (by the model's size)",
         "LENGTH", picture);
    text("--samples", raw.samples,
         "Samples per pixel: 1, 4, 8, 16, 64 or 256 (4; as OpenSCAD 1, where it is to draw a shaded --render)", "N",
         picture);
    flag("--transparent-background", o.picture.transparent_background, "No background", picture);
    text("--view", raw.view,
         "Show axes, scales (of the axes), crosshairs, edges and centers (center lines of what is round); several with "
         "commas between",
         "WHAT", picture);
    flag("--render", raw.render,
         "Draw the result: $preview false, neither % nor # parts, outlines flat, framed exactly", picture);
    flag("--preview", raw.preview, "Evaluate with $preview true (default)", picture);

    const char* const camera = "Camera";
    text("--camera", raw.camera, "x,y,z,rotx,roty,rotz,distance or eyex,y,z,centerx,y,z", "NUMBERS", camera);
    text("--projection", raw.projection, "o (orthographic) or p (perspective, default)", "o|p", camera);
    flag("--viewall", o.view_all, "Move the camera so that all is seen", camera);
    text("--margin", raw.margin,
         "The same as near as leaves so much of the picture at each side empty, 0 to 45 (OpenSCAD's distance)",
         "PERCENT", camera);
    text("--plan", raw.plan,
         "Several views in one picture at one scale, with lines between them and a scale bar: top, front, side (from "
         "the right) or iso",
         "VIEW[,VIEW...]", camera);
    flag("--autocenter", o.autocenter, "Look at the center of the model", camera);

    const char* const engine = "Engine";
    const std::string engines = "auto, " + goldfeather::engine_names() + " (auto)";
    text("--engine", raw.engine, engines.c_str(), "NAME", engine);
    text("--context", raw.context, "OpenGL from: auto, egl, osmesa or none (auto)", "NAME", engine);
    text("--memory-budget", raw.memory_budget, "Per-pixel state of the engines on OpenGL at once (128)", "MIB", engine);
    text("--minimal-fraction", raw.minimal_fraction,
         "Leave out layers that fewer than this share of the pixels have (0)", "SHARE", engine);
    text("--log-frames", o.frames_log, "Write one line of JSON for each frame that the window shows", "FILE", engine);

    const char* const other = "Other";
    flag("--help-export", raw.help_export, "Print the options of file formats", other);
    flag("-v,--version", raw.version, "Print the version", other);
    flag("--info", o.information, "Print version and OpenGL", other);
    const char* const accepted = "Accepted for OpenSCAD's sake, without effect";
    text("--csglimit", raw.csg_limit, "Nothing is left out, however large the model", "N", accepted);
    text("--backend", raw.backend, "Geometry backend", "NAME", accepted);
    text("--debug", raw.debug, "Messages of OpenSCAD's own sources", "WHAT", accepted);
    flag("--trust-python", raw.trust_python, "Declined: no Python runs", accepted);
}

void declare_pick(OptionTable& table, Options& options, RawOptions& raw, const std::string& styles) {
    const char* const pick = "What to pick";
    table.add_last({"--at", "The pixel, counted from the upper left corner, from 0 on", "X,Y", pick}, raw.at, true);
    table.add_last({"--format", "text or json (text)", "FORMAT", pick}, raw.format);
    declare(table, options, raw, styles);
    remove_outputs(table);
}

void declare_measure(OptionTable& table, Options& options, RawOptions& raw, const std::string& styles) {
    const char* const measure = "What to measure";
    const std::string values = fmt::format("Print that number alone: {}", base::alternatives(measure_values()));
    table.add_each({"--of",
                    "The measures of a thing: of the face at a pixel X,Y, of edge@X,Y or corner@X,Y, or of the shape "
                    "that is called at LINE[:COLUMN] or its face +z@LINE (-z, +x, ...); #N behind it: the N-th; may be "
                    "repeated",
                    "THING", measure},
                   raw.of);
    table.add_each(
        {"--between", "Distance and angle from such a thing, or from a point [x,y,z], ...", "THING", measure},
        raw.between);
    table.add_each({"--and", "... to another; may be repeated", "THING", measure}, raw.other);
    table.add_last({"--value", values, "NAME", measure}, raw.value);
    table.add_last({"--format", "text or json (text)", "FORMAT", measure}, raw.format);
    declare(table, options, raw, styles);
    remove_outputs(table);
    table.remove("--layers");
}

}  // namespace ui
