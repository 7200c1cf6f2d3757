// OpenSCAD's own suite as data, where this machine has it (shared/conformance beside the project, with a README).
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace suite {

/// Where it lies; whether it is there is another question.
[[nodiscard]] inline std::filesystem::path folder() {
    return std::filesystem::path(CSGSCOPE_SOURCE_DIR).parent_path() / "shared/conformance";
}

/// What the suite says of each case; none where it is absent.
[[nodiscard]] inline std::vector<nlohmann::json> cases() {
    std::ifstream in(folder() / "manifest.json");
    return in ? nlohmann::json::parse(in).get<std::vector<nlohmann::json>>() : std::vector<nlohmann::json>();
}

[[nodiscard]] inline std::filesystem::path input(const nlohmann::json& row) {
    return folder() / "openscad" / row.at("input").get<std::string>();
}
[[nodiscard]] inline std::filesystem::path expected(const nlohmann::json& row) {
    return folder() / "openscad/expected" / row.at("expected").get<std::string>();
}

inline void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// Some programs name files by the folder that the suite had where it was recorded: names them in `root`.
inline void move_to(std::string& program, std::string_view root) {
    constexpr std::string_view kRecordedIn = "/tmp/tmp";  // and some letters
    for (std::size_t at = program.find(kRecordedIn); at != std::string::npos; at = program.find(kRecordedIn, at)) {
        const std::size_t end = program.find("/tests/", at);
        if (end == std::string::npos) {
            return;
        }
        program.replace(at, end - at, root);
        at += root.size();
    }
}

}  // namespace suite
