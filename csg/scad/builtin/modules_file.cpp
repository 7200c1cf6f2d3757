// Built-in modules that take their shape from a file. The file is read later, when the shape is needed.
#include <array>
#include <cmath>

#include "csg/scad/builtin/builtin_modules.h"
#include "csg/scad/builtin/data_file.h"
#include "csg/tree/finite.h"

namespace csg::scad {

namespace {

using ParameterNames = std::string_view;

std::string text_of(const ModuleArguments& arguments, ParameterNames parameter, ParameterNames old_name) {
    const Value& value = arguments[arguments[parameter].is_undef() ? old_name : parameter];
    return value.is_string() ? value.string() : std::string();
}

void run_import(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 5> kParameters{"file", "layer", "convexity", "origin", "scale"};
    static constexpr std::array<ParameterNames, 7> kNamed{"width",  "height", "filename", "layername",
                                                          "center", "dpi",    "id"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters, kNamed);
    auto import = std::make_shared<Import>();
    import->file = find_data_file(c.evaluator, c.where(), text_of(arguments, "file", "filename"));
    import->layer = text_of(arguments, "layer", "layername");
    import->id = text_of(arguments, "id", "id");
    import->fineness = c.evaluator.fineness(c.where());
    import->convexity = whole(arguments.number("convexity"), 1);
    if (const Value& origin = arguments["origin"]; !origin.is_undef()) {
        glm::dvec2 xy(0.0);
        if (to_vec2(origin, xy) && is_finite(xy)) {
            import->origin = xy;
        } else {
            c.warn(fmt::format("Unable to convert import(..., origin={}) parameter to vec2", origin.echo_text()));
        }
    }
    import->scale = arguments.number("scale").value_or(1);
    if (!(import->scale > 0) || !std::isfinite(import->scale)) {
        import->scale = 1;
    }
    import->center = is_true(arguments["center"]);
    if (const auto dpi = arguments.number("dpi")) {
        if (*dpi >= 0.001 && std::isfinite(*dpi)) {
            import->dpi = *dpi;
        } else {
            c.warn(
                fmt::format("Invalid dpi value giving, using default of 72 dpi. Value must be positive and >= "
                            "0.001, file '{}'",
                            import->file.shown));
        }
    }
    add_leaf(c, std::shared_ptr<const Import>(std::move(import)), out);
}

void run_surface(const ModuleContext& c, Nodes& out) {
    static constexpr std::array<ParameterNames, 3> kParameters{"file", "center", "convexity"};
    static constexpr std::array<ParameterNames, 1> kNamed{"invert"};
    c.expect_no_children();
    const ModuleArguments arguments(c, kParameters, kNamed);
    auto surface = std::make_shared<Surface>();
    surface->file = find_data_file(c.evaluator, c.where(), text_of(arguments, "file", "file"));
    surface->center = is_true(arguments["center"]);
    surface->invert = is_true(arguments["invert"]);
    add_leaf(c, std::shared_ptr<const Surface>(std::move(surface)), out);
}

constexpr std::array kFile{
    ModuleEntry{"import", run_import},
    ModuleEntry{"surface", run_surface},
};

}  // namespace

std::span<const ModuleEntry> file_modules() {
    return kFile;
}

}  // namespace csg::scad
