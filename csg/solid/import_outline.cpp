#include "csg/solid/import_outline.h"

#include "csg/solid/file_text.h"
#include "csg/solid/files.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;

void center(Outline& outline) {
    const glm::dvec2 middle(bounds_of(outline.loops).center());
    for (Loop& loop : outline.loops) {
        for (glm::dvec2& p : loop) {
            p -= middle;
        }
    }
}

}  // namespace

Outline import_outline(const Import& import, Remarks& remarks) {
    const auto text = read_file(import.file.path, kMostBytes, remarks.failures);
    if (!text) {
        return {};
    }
    Outline outline = file_suffix(import.file.path) == "svg"
                          ? read_svg(*text, import, remarks)
                          : clean(read_dxf(*text, import, remarks), FillRule::EvenOdd);
    if (import.center) {
        center(outline);
    }
    return outline;
}

}  // namespace csg::solid
