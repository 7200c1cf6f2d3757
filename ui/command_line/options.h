// The command line, read: OpenSCAD 2021.01's options and csgscope's own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/tree/part_rule.h"
#include "gl/context.h"
#include "goldfeather/choice.h"
#include "ui/command_line/export_options.h"
#include "ui/command_line/measure_options.h"
#include "ui/command_line/outputs.h"
#include "ui/command_line/picture_options.h"
#include "ui/command_line/summary_parts.h"
#include "ui/command_line/usage_error.h"
#include "ui/pipeline/annotation/annotation_texts.h"
#include "ui/pipeline/motion/depiction_expression.h"
#include "ui/pipeline/picture/plan.h"
#include "ui/pipeline/picture/thickness_request.h"
#include "ui/pipeline/picture/view_marks.h"

namespace ui {

/// What `csgscope pick` is to tell.
struct PickOptions {
    glm::ivec2 at{0};   ///< A pixel, counted from the upper left corner.
    bool json = false;  ///< Else a text for people.
};

struct Options {
    std::optional<PickOptions> pick;        ///< Instead of outputs.
    std::optional<MeasureOptions> measure;  ///< The same.
    std::string input;                      ///< "-": standard input; empty where none was given.
    std::vector<Output> outputs;
    ExportOptions exports;
    std::string changes_from;  ///< An earlier version, of which changes are drawn; empty: none.
    std::vector<Depiction> depictions;
    std::string depiction_rules;  ///< A file of them; empty: none.
    int storyboard = 0;           ///< Panels on the sheet that the picture is to be; 0: it is no storyboard.
    AnnotationTexts annotations;
    double time = 0;               ///< $t, where no frames are made.
    std::string explain, without;  ///< Places of calls, as call_at takes them; empty: none.
    std::optional<ThicknessRequest> thickness;
    std::vector<std::string> definitions;  ///< Statements that come after the file's text.
    std::string parameter_file;            ///< Parameter sets; empty: none.
    std::string parameter_set;             ///< The one to take.
    std::optional<base::Camera> camera;    ///< Absent: the file's $vp… variables, or everything in view.
    bool view_all = false;
    std::optional<double> margin;  ///< See CameraRequest.
    std::vector<PlanView> plan;    ///< None: the one view of the camera.
    bool autocenter = false;
    base::Projection projection = base::Projection::Perspective;
    npr::Picture picture;  ///< But for its camera, and for what `style` says; see picture_of.
    PictureTexts picture_texts;
    goldfeather::EngineOptions engine;
    std::optional<gl::ContextKind> context = gl::ContextKind::Auto;  ///< Absent: no OpenGL.
    std::optional<std::string> statistics;                           ///< File for JSON; "-": standard output.
    std::optional<std::string> summary_file;
    std::optional<std::string> dependencies;  ///< File for make.
    std::string make_command;                 ///< -m; empty: none.
    std::string cache;                        ///< Folder that keeps meshes; empty: none.
    std::string frames_log;                   ///< The window's log; empty: none.
    int frames = 0;                           ///< Of an animation, all of them; 0: none.
    bool turntable = false;                   ///< They turn the camera, not $t.
    double frames_per_second = 25;            ///< Of films.
    int first_frame = 0, end_frame = 0;       ///< Those that this run makes.
    double time_limit = 0;                    ///< Seconds for evaluation and drawing together; 0: none.
    int memory_limit = 0;                     ///< MiB for the run; 0: none.
    int trace_depth = 12;
    bool trace_parameters = true;
    bool check_parameters = true;
    bool check_ranges = false;
    bool by_error = false;  ///< $fe has its meaning.
    bool lazy_union = false;
    ViewMarks marks;
    bool preview = true;  ///< $preview
    bool quiet = false;
    bool hard_warnings = false;
    bool summary = false;  ///< Printed.
    SummaryParts summary_parts;
    double precision = 0.01;  ///< Of its measures: the share that errors may be.
    csg::PartRule parts;
    bool information = false;  ///< --info
};

/// Is there an output of these options of this format?
[[nodiscard]] bool wants(const Options& options, Format format);

/// Is there something to write or to tell that is the geometry itself, not a picture of it?
[[nodiscard]] bool needs_geometry(const Options& options);

/// Of --parts. Throws UsageError.
[[nodiscard]] csg::PartRule read_parts(const std::string& text);

/// What to do: run with the options, or print `text` on standard output and end well.
struct CommandLine {
    Options options;
    std::optional<std::string> text;
};

/// Reads the arguments (without the program's name); "pick" or "measure" as the first of them sets
/// Options::pick or measure. Throws UsageError. `styles`: as the help lists them, see
/// style_names; where it is empty, a command line that asks for the help gives neither options nor text.
[[nodiscard]] CommandLine read_command_line(const std::vector<std::string>& arguments, const std::string& styles = "");

}  // namespace ui
