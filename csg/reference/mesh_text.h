// What the writers of mesh files share.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "csg/reference/mesh_files.h"

namespace csg::reference {

using Text = fmt::memory_buffer;

template <typename... Args>
void put(Text& out, fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(fmt::appender(out), format, std::forward<Args>(args)...);
}

inline std::uint32_t part_of(const MeshDocument& d, std::size_t triangle) {
    return d.part_of.empty() ? 0 : d.part_of[triangle];
}

inline int byte_of(float value) {
    return static_cast<int>(std::lround(std::min(1.0f, std::max(0.0f, value)) * 255));
}

/// What the text needs to stand in XML.
[[nodiscard]] std::string xml(const std::string& text);

/// The bytes of a 3MF file.
[[nodiscard]] std::string three_mf(const MeshDocument& document);

}  // namespace csg::reference
