// Reading XML (on Expat) element by element.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace csg::solid {

using Attributes = std::map<std::string, std::string, std::less<>>;

/// Empty where there is none of the name.
[[nodiscard]] std::string_view attribute(const Attributes& attributes, std::string_view name);

/// Called in document order. Names come without their namespace prefix.
struct XmlEvents {
    std::function<void(const std::string& name, const Attributes& attributes)> open;
    std::function<void(const std::string& name, const std::string& text)> close;  ///< With the text since the last tag.
};

/// Entities are not expanded, elements nest at most 256 deep. False, with a warning, where the text is no XML; what
/// came before was told.
bool read_xml(std::string_view text, const XmlEvents& events, std::vector<std::string>& warnings);

}  // namespace csg::solid
