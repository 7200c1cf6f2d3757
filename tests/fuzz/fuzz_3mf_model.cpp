// The model within a 3mf archive: mutations of the archive itself seldom get past its checksums.
#include <cstdint>
#include <cstdlib>

#include "csg/solid/import_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    csg::solid::FileMesh mesh;
    std::vector<std::string> warnings;
    csg::solid::read_3mf_model({reinterpret_cast<const char*>(data), size}, mesh, warnings);
    for (const auto& face : mesh.faces) {
        for (const std::uint32_t corner : face) {
            if (corner >= mesh.points.size()) {
                std::abort();
            }
        }
    }
    return 0;
}
