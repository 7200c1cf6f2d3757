// The files that a run is to write, and their formats.
#pragma once

#include <string>

#include "csg/solid/outline_files.h"
#include "ui/pipeline/mesh/mesh.h"

namespace ui {

enum class Format { Png, Apng, Gif, WebP, Exr, Csg, Ast, Echo, Param, Term, Mesh, Drawing };

struct Output {
    std::string path;  ///< "-": standard output.
    Format format = Format::Png;
    MeshFormat mesh = MeshFormat::AsciiStl;                              ///< For Format::Mesh.
    csg::solid::DrawingFormat drawing = csg::solid::DrawingFormat::Svg;  ///< For Format::Drawing.
};

/// Does it hold all frames of an animation?
[[nodiscard]] inline bool is_film(Format format) {
    return format == Format::Apng || format == Format::Gif || format == Format::WebP;
}

/// Is it drawn: a picture, or a film of them?
[[nodiscard]] inline bool is_picture(Format format) {
    return format == Format::Png || is_film(format);
}

/// Of -o: the suffix of the path tells the format, unless there is an `export_format`. Throws UsageError.
[[nodiscard]] Output read_output(const std::string& path, const std::string& export_format);

/// Of a frame of an animation, as OpenSCAD names it: x00012.png for x.png; a film holds all frames, in one file.
[[nodiscard]] Output output_of_frame(Output output, int frame);

}  // namespace ui
