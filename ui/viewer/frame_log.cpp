#include "ui/viewer/frame_log.h"

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include <fmt/format.h>

namespace ui {

std::string to_json(const FrameRecord& record) {
    const auto array = [](const glm::dvec3& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
    const bool orthographic = record.camera.projection == gl::Projection::Orthographic;
    const nlohmann::ordered_json json = {{"time", record.time},
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
                                         {"state", record.state},
                                         {"evaluating", record.evaluating},
                                         {"camera",
                                          {{"translation", array(record.camera.target)},
                                           {"rotation", array(record.camera.rotation)},
                                           {"distance", record.camera.distance},
                                           {"fov", record.camera.fov},
                                           {"projection", orthographic ? "orthographic" : "perspective"}}}};
    return json.dump();
}

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
