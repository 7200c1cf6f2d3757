// OpenSCAD's options of file formats: -O section/key=value.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/outline_files.h"
#include "ui/pipeline/mesh/mesh.h"

namespace ui {

struct ExportOptions {
    /// As OpenSCAD 2021.01 draws it.
    csg::solid::Paint svg{true, {211, 211, 211}, true, {0, 0, 0}, 0.5};
    csg::solid::PdfPage pdf;
    bool pdf_meta_data = true, pdf_file_name = false;
    csg::reference::ThreeMfOptions three_mf;
    bool three_mf_meta_data = true;
};

/// Reads each "section/key=value" in order; a later one wins. Throws UsageError, with the nearest name.
[[nodiscard]] ExportOptions read_export_options(const std::vector<std::string>& assignments);

/// All sections with their keys, values and defaults, for people.
[[nodiscard]] std::string export_options_help();

}  // namespace ui
