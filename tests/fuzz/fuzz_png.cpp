#include "tests/fuzz/file_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::import_surface(data, size, "png");
    return 0;
}
