// What the file system says of a file: enough to tell that it has not been written to since.
#pragma once

#include <cstdint>
#include <string>

namespace csg::scad {

/// Tells one state of a file from another. A file that cannot be looked at does not exist.
struct DiskState {
    bool exists = false;
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t seconds = 0, nanoseconds = 0;  ///< Of its last modification.
    std::int64_t changed_seconds = 0,
                 changed_nanoseconds = 0;  ///< Of the last change of its entry, which cannot be set.
    bool operator==(const DiskState&) const = default;
};

[[nodiscard]] DiskState disk_state(const std::string& path);

}  // namespace csg::scad
