#include "ui/command_line/export.h"

#include <filesystem>

#include "base/stop.h"
#include "ui/command_line/files.h"
#include "ui/pipeline/mesh/mesh_cache.h"
#include "ui/pipeline/mesh/outline.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

std::string file_name(const Options& options) {
    return options.input == "-" ? std::string() : printable(std::filesystem::path(options.input).filename().string());
}

std::string drawing(const Options& options, const csg::solid::Outline& outline, csg::solid::DrawingFormat format,
                    Messages& messages) {
    if (format == csg::solid::DrawingFormat::Svg) {
        return encode_svg(outline, options.exports.svg);
    }
    if (format == csg::solid::DrawingFormat::Dxf) {
        return encode_dxf(outline);
    }
    csg::solid::PdfPage page = options.exports.pdf;
    if (!options.exports.pdf_meta_data) {
        page.title = page.author = page.subject = page.keywords = "";
    } else if (page.title.empty()) {
        page.title = file_name(options);
    }
    if (options.exports.pdf_file_name) {
        page.file_name = file_name(options);
    }
    if (beyond_page(outline, page)) {
        messages.warn("the drawing is larger than the page; see -O export-pdf/paper-size and export-pdf/orientation");
    }
    return encode_pdf(outline, page);
}

csg::reference::PovView pov_view(const base::Camera& camera, glm::ivec2 size) {
    const auto array = [](const glm::dvec3& v) { return std::array{v.x, v.y, v.z}; };
    const base::View view(camera, size, camera.target, camera.target);
    const bool perspective = !view.orthographic();
    // The rows of a rotation are the axes of the eye.
    const glm::dmat3 axes = glm::transpose(glm::dmat3(view.eye_from_world()));
    return {array(camera.eye()),          array(camera.target), array(axes[1]),
            perspective ? camera.fov : 0, view.half_height(),   static_cast<double>(size.x) / size.y};
}

}  // namespace

std::optional<Json> Geometry::figures() const {
    if (mesh) {
        return to_json(*mesh);
    }
    if (outline) {
        return to_json(*outline);
    }
    return std::nullopt;
}

Geometry make_geometry(const Options& options, const Model& model, ModelBuilder& builder, Messages& messages,
                       const std::stop_token& stop) {
    need_whole(model);
    if (wants(options, Format::Mesh)) {
        need_solid(model);
    }
    if (wants(options, Format::Drawing)) {
        need_flat(model);
    }
    Geometry geometry;
    const Extent extent = extent_of(model);
    if (extent == Extent::Flat) {
        geometry.outline = builder.outline(model, stop);
    } else if (extent == Extent::Solid) {
        MeshCache cache(options.cache);
        geometry.mesh = cache.get(model, stop);
        geometry.mesh_known = cache.hit();
        if (!cache.problem().empty()) {
            messages.warn(cache.problem());
        }
    }
    return geometry;
}

void write_geometry(const Options& options, const Model& model, const Geometry& geometry, const base::Camera& camera,
                    Messages& messages, const std::stop_token& stop) {
    const csg::reference::PovView view = pov_view(camera, options.picture.size);
    csg::reference::ThreeMfOptions three_mf = options.exports.three_mf;
    if (!options.exports.three_mf_meta_data) {
        three_mf.meta_data.clear();
    } else if (three_mf.meta_data["Title"].empty()) {
        three_mf.meta_data["Title"] = file_name(options);
    }
    for (auto& [name, value] : three_mf.meta_data) {
        value = printable(value);
    }
    for (const Output& output : options.outputs) {
        base::end_if_asked(stop);
        if (output.format == Format::Mesh) {
            write_output(output.path, encode_mesh(model, *geometry.mesh, output.mesh, three_mf, view, stop));
        } else if (output.format == Format::Drawing) {
            write_output(output.path, drawing(options, *geometry.outline, output.drawing, messages));
        }
    }
}

}  // namespace ui
