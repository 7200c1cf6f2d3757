// The bytes are the model within a 3mf archive: mutations of the archive itself seldom get past its checksums.
#include <zip.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "tests/fuzz/file_target.h"

namespace {

/// As an archive with the model, stored.
std::vector<std::uint8_t> archive(const std::uint8_t* data, std::size_t size) {
    zip_error_t error;
    zip_source_t* whole = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(whole);
    zip_t* zip = zip_open_from_source(whole, ZIP_TRUNCATE, &error);
    zip_source_t* model = zip_source_buffer(zip, data, size, 0);
    const zip_int64_t at = zip_file_add(zip, "3D/3dmodel.model", model, ZIP_FL_ENC_UTF_8);
    if (at < 0 || zip_set_file_compression(zip, static_cast<zip_uint64_t>(at), ZIP_CM_STORE, 0) != 0 ||
        zip_close(zip) != 0)
        std::abort();
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_source_stat(whole, &stat) != 0 || zip_source_open(whole) != 0)
        std::abort();
    std::vector<std::uint8_t> bytes(stat.size);
    if (zip_source_read(whole, bytes.data(), bytes.size()) != static_cast<zip_int64_t>(bytes.size()))
        std::abort();
    zip_source_close(whole);
    zip_source_free(whole);
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const std::vector<std::uint8_t> bytes = archive(data, size);
    fuzz::import_solid(bytes.data(), bytes.size(), "3mf");
    return 0;
}
