#include "tests/fuzz/file_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::import_solid(data, size, "off");
    return 0;
}
