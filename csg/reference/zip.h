// ZIP packages.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace csg::reference {

/// A ZIP file of the entries (name, bytes) in their order, deflated, without times: the same entries give the same
/// bytes. Entries up to 4 GiB; throws std::runtime_error beyond.
[[nodiscard]] std::string zip(const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace csg::reference
