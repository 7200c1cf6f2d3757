#include "ui/command_line/outputs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "ui/command_line/usage_error.h"

namespace ui {

namespace {

using csg::solid::DrawingFormat;
struct NamedFormat {
    std::string_view name;
    Format format;
    MeshFormat mesh = MeshFormat::AsciiStl;
    DrawingFormat drawing = DrawingFormat::Svg;
};
const std::array<NamedFormat, 22> kFormats{{{"png", Format::Png},
                                            {"apng", Format::Apng},
                                            {"gif", Format::Gif},
                                            {"webp", Format::WebP},
                                            {"exr", Format::Exr},
                                            {"stl", Format::Mesh},
                                            {"asciistl", Format::Mesh},
                                            {"binstl", Format::Mesh, MeshFormat::BinaryStl},
                                            {"off", Format::Mesh, MeshFormat::Off},
                                            {"obj", Format::Mesh, MeshFormat::Obj},
                                            {"amf", Format::Mesh, MeshFormat::Amf},
                                            {"3mf", Format::Mesh, MeshFormat::ThreeMf},
                                            {"wrl", Format::Mesh, MeshFormat::Wrl},
                                            {"pov", Format::Mesh, MeshFormat::Pov},
                                            {"svg", Format::Drawing},
                                            {"dxf", Format::Drawing, {}, DrawingFormat::Dxf},
                                            {"pdf", Format::Drawing, {}, DrawingFormat::Pdf},
                                            {"csg", Format::Csg},
                                            {"ast", Format::Ast},
                                            {"echo", Format::Echo},
                                            {"term", Format::Term},
                                            {"param", Format::Param}}};
constexpr const char* kFormatNames =
    "png, apng, gif, webp, exr, stl, asciistl, binstl, off, obj, amf, 3mf, wrl, pov, svg, dxf, pdf, csg, ast, echo, "
    "term and "
    "param";

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

}  // namespace

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

Output output_of_frame(Output output, int frame) {
    if (is_film(output.format)) {
        return output;
    }
    const std::size_t dot = output.path.rfind('.');
    const std::size_t slash = output.path.rfind('/');
    const bool suffix = dot != std::string::npos && (slash == std::string::npos || dot > slash);
    output.path.insert(suffix ? dot : output.path.size(), fmt::format("{:05}", frame));
    return output;
}

}  // namespace ui
