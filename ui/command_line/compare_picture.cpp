#include "ui/command_line/compare_picture.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "base/file.h"
#include "base/image.h"
#include "ui/command_line/compare_input.h"
#include "ui/command_line/compare_table.h"
#include "ui/command_line/compare_views.h"
#include "ui/command_line/files.h"
#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

int compare_with_picture(const CompareOptions& o) {
    const base::Image reference = base::read_png(o.reference);
    const ComparedModel loaded = load(o);
    Renderer renderer(o.engine);
    PictureRequest request;
    request.camera = choose_camera({}, loaded.view, loaded.model->box);
    request.size = {reference.width, reference.height};
    const base::Image drawn = renderer.render(*loaded.model, request, o.stop);
    std::size_t differ = 0;
    base::Image difference = blank_image(request.size);
    for (std::size_t i = 0; i < drawn.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            most = std::max(most, std::abs(int{drawn.rgba[i + c]} - int{reference.rgba[i + c]}));
        }
        differ += most > 32 ? 1 : 0;  // an eighth of the range
        difference.rgba[i + 1] = difference.rgba[i + 2] = static_cast<std::uint8_t>(255 - most);
    }
    const double share = 4.0 * static_cast<double>(differ) / static_cast<double>(drawn.rgba.size());
    const bool good = share <= o.reference_threshold;
    const Json json = {{"model", o.input},
                       {"reference", o.reference},
                       {"pixels_that_differ", share},
                       {"threshold", o.reference_threshold},
                       {"within_threshold", good}};
    write_output("-", o.json ? text_of(json) : printable(compare_picture_text(json)));
    if (!o.report.empty()) {
        base::make_folder(o.report);
        write_output((std::filesystem::path(o.report) / "difference_1.png").string(), base::encode_png(difference));
        write_output((std::filesystem::path(o.report) / "report.json").string(), text_of(json));
        write_output((std::filesystem::path(o.report) / "report.html").string(),
                     report_page(fmt::format("{} against {}", o.input, o.reference), "Picture to picture.",
                                 {{"The picture", drawn, reference, difference, json, {}}}));
    }
    return good ? 0 : 1;
}

}  // namespace ui
