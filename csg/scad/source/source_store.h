// Texts that stay: a file is read again only where the file system says that it may have changed.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "csg/scad/source/disk_state.h"
#include "csg/scad/source/source.h"

namespace csg::scad {

/// Whether two answers are the same: the same shared text, or an error of the same words.
[[nodiscard]] bool same_source(const SourceResult& a, const SourceResult& b);

/// All members may be called from any thread.
class SourceStore {
  public:
    struct Answer {
        SourceResult result;
        std::optional<DiskState> state;  ///< Of the file before it was read; nothing where that is not on disk.
    };
    /// The file as it is now. As long as its text is the same, the same SourceFile is given. A `reader` other than
    /// read_source_file is asked every time.
    [[nodiscard]] Answer read(const std::string& path, const SourceReader& reader);
    /// Lets go of texts that nobody has asked for since `kKept` calls of this.
    void trim();

    static constexpr std::uint32_t kKept = 16;

  private:
    struct Entry {
        Answer answer;
        bool settled = false;  ///< Its last change was long enough before it was read.
        std::uint32_t used = 0;
    };
    /// The entry's answer, where nothing is to be read for it; else null.
    [[nodiscard]] const Answer* known(const std::string& path, const DiskState& state);

    std::mutex mutex_;
    std::map<std::string, Entry> entries_;
    std::uint32_t round_ = 0;
};

}  // namespace csg::scad
