// Sections as the command line writes them.
#pragma once

#include <string>
#include <vector>

#include "npr/section.h"

namespace ui {

/// x=1, y>1, z<1, plane([x,y,z],[nx,ny,nz]), box([x,y,z],[x,y,z]), half, quarter, eighth or part:NAME. Throws
/// UsageError, which says what is expected.
[[nodiscard]] npr::Section read_section(const std::string& text);

/// The values of --section, --uncut and --hatching ("" where it is not given). Throws UsageError.
[[nodiscard]] npr::Sections read_sections(const std::vector<std::string>& cuts, const std::vector<std::string>& uncut,
                                          const std::string& hatching);

}  // namespace ui
