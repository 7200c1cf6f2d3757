// What the writers of mesh files share.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "base/stop.h"
#include "csg/reference/mesh_files.h"

namespace csg::reference {

/// The text of a file in the making. `put` throws base::Stopped where the token asked for it; the token must outlive
/// the text.
class Text {
  public:
    explicit Text(const std::stop_token& stop) : paced_(stop) {}
    /// The text, which is taken out.
    [[nodiscard]] std::string str() { return std::move(text_); }

    template <typename... Args>
    void put(fmt::format_string<Args...> format, Args&&... args) {
        paced_();
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
    }

  private:
    std::string text_;
    base::PacedStop paced_;
};

template <typename... Args>
void put(Text& out, fmt::format_string<Args...> format, Args&&... args) {
    out.put(format, std::forward<Args>(args)...);
}

inline std::uint32_t part_of(const MeshDocument& d, std::size_t triangle) {
    return d.part_of.empty() ? 0 : d.part_of[triangle];
}

inline int byte_of(float value) {
    return static_cast<int>(std::lround(std::min(1.0f, std::max(0.0f, value)) * 255));
}

/// What the text needs to stand in XML.
[[nodiscard]] std::string xml(const std::string& text);

/// The triangles of each part.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> by_part(const MeshDocument& document);

/// The text of a scene of POV-Ray.
[[nodiscard]] std::string pov(const MeshDocument& document, const std::stop_token& stop);

/// The bytes of a 3MF file.
[[nodiscard]] std::string three_mf(const MeshDocument& document, const std::stop_token& stop);

}  // namespace csg::reference
