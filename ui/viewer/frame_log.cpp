#include "ui/viewer/frame_log.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "ui/pipeline/json.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

/// The record on one line, without newline.
std::string to_json(const FrameRecord& record) {
    Json camera = ui::to_json(record.camera);
    camera["projection"] = record.camera.projection == base::Projection::Orthographic ? "orthographic" : "perspective";
    const Json json = {{"time", record.time},
                       {"ms", record.ms},
                       {"picture_ms", record.picture_ms},
                       {"samples", record.samples},
                       {"wanted_samples", record.wanted_samples},
                       {"divisor", record.divisor},
                       {"width", record.size.x},
                       {"height", record.size.y},
                       {"current", record.current},
                       {"generation", record.generation},
                       {"style", record.style},
                       {"engine", record.engine},
                       {"state", record.state},
                       {"evaluating", record.evaluating},
                       {"selected", record.selected},
                       {"step", record.step},
                       {"text_line", record.text_line},
                       {"tool", record.tool},
                       {"found", record.found},
                       {"edits", record.edits},
                       {"unsaved", record.unsaved},
                       {"inspection",
                        {{"task", record.inspection.task},
                         {"range", record.inspection.range},
                         {"thin_places", record.inspection.thin_places},
                         {"findings", record.inspection.findings},
                         {"volume", record.inspection.volume},
                         {"changed_parts", record.inspection.changed_parts},
                         {"marked", record.inspection.marked},
                         {"error", record.inspection.error}}},
                       {"dynamics",
                        {{"searches", record.dynamics.searches},
                         {"bodies", record.dynamics.bodies},
                         {"depictions", record.dynamics.depictions},
                         {"labels", record.dynamics.labels},
                         {"error", record.dynamics.error}}},
                       {"camera", camera}};
    return json.dump();
}

}  // namespace

FrameLog::FrameLog(const std::string& path) {
    if (path.empty()) {
        return;
    }
    file_.open(path, std::ios::trunc);
    if (!file_) {
        throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
    }
}

void FrameLog::write(const FrameRecord& record) {
    if (file_.is_open()) {
        file_ << to_json(record) << '\n' << std::flush;  // Readers follow the file.
    }
}

}  // namespace ui
