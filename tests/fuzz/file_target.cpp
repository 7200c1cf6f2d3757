#include "tests/fuzz/file_target.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "csg/solid/files.h"

namespace fuzz {
namespace {

/// A file in memory, where the system has such a folder; one for all inputs of a process.
class ScratchFile {
  public:
    explicit ScratchFile(const std::string& suffix) {
        const std::filesystem::path memory = "/dev/shm";
        const auto folder = std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
        path_ = folder / ("csgscope-fuzz-" + std::to_string(getpid()) + "." + suffix);
    }
    ~ScratchFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    csg::FileStamp hold(const std::uint8_t* data, std::size_t size) const {
        std::FILE* file = std::fopen(path_.c_str(), "wb");
        if (file == nullptr || std::fwrite(data, 1, size, file) != size || std::fclose(file) != 0) {
            std::abort();
        }
        csg::FileStamp stamp;
        stamp.path = path_;
        return stamp;
    }

  private:
    std::filesystem::path path_;
};

const ScratchFile& scratch(const std::string& suffix) {
    static const ScratchFile file(suffix);
    return file;
}

void check(const csg::solid::Solid& solid) {
    for (const auto& triangle : solid.triangles) {
        for (int k = 0; k < 3; ++k) {
            if (triangle[k] >= solid.points.size()) {
                std::abort();
            }
        }
    }
    for (const glm::dvec3& p : solid.points) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
            std::abort();
        }
    }
}

}  // namespace

void import_solid(const std::uint8_t* data, std::size_t size, const std::string& suffix) {
    csg::Import import;
    import.file = scratch(suffix).hold(data, size);
    check(*csg::solid::import_solid(import));
}

void import_outline(const std::uint8_t* data, std::size_t size, const std::string& suffix) {
    csg::Import import;
    import.file = scratch(suffix).hold(data, size);
    csg::solid::Remarks remarks;
    try {
        if (!std::isfinite(csg::solid::import_outline(import, remarks).area())) {
            std::abort();
        }
    } catch (const csg::solid::GeometryError&) {
        // Coordinates beyond what can be worked with: an answer, too.
    }
}

void import_surface(const std::uint8_t* data, std::size_t size, const std::string& suffix) {
    csg::Surface surface;
    surface.file = scratch(suffix).hold(data, size);
    check(*csg::solid::surface_solid(surface));
}

}  // namespace fuzz
