// Files that would take more memory than anybody has, were they believed.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <zip.h>

#include <algorithm>

#include "csg/solid/files.h"
#include "csg/solid/import_mesh.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace csg::solid;

long peak_mebibytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

std::uint32_t crc(const std::string& bytes) {
    std::uint32_t sum = ~0U;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int i = 0; i < 8; ++i) {
            sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0xedb88320U : 0U);
        }
    }
    return ~sum;
}

std::string big_endian(std::uint32_t n) {
    return {static_cast<char>(n >> 24U), static_cast<char>(n >> 16U), static_cast<char>(n >> 8U), static_cast<char>(n)};
}

std::string chunk(const std::string& kind, const std::string& body) {
    return big_endian(static_cast<std::uint32_t>(body.size())) + kind + body + big_endian(crc(kind + body));
}

/// Gray, with next to no data.
std::string picture(std::uint32_t width, std::uint32_t height) {
    const std::string header = big_endian(width) + big_endian(height) + std::string("\x08\0\0\0\0", 5);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", "\x78\x9c") + chunk("IEND", "");
}

TEST(HostileFiles, AHugePictureIsRefusedBeforeItTakesMemory) {
    const test_support::TemporaryFolder folder;
    csg::Surface surface;
    surface.file.path = folder.write("huge.png", picture(60'000, 60'000));
    const long before = peak_mebibytes();
    const auto solid = surface_solid(surface);
    EXPECT_TRUE(solid->triangles.empty());
    ASSERT_EQ(solid->failures.size(), 1u);
    EXPECT_NE(solid->failures[0].find("60000 × 60000 pixels is too large"), std::string::npos) << solid->failures[0];
    EXPECT_LT(peak_mebibytes() - before, 64);
    surface.file.path = folder.write("cut.png", picture(8, 8));
    EXPECT_NE(surface_solid(surface)->failures[0].find("Can't read surface picture"), std::string::npos);
}

/// Of 2 GB, which is not there.
TEST(HostileFiles, ATextInAPictureTakesNoMemory) {
    const test_support::TemporaryFolder folder;
    csg::Surface surface;
    std::string bytes = picture(8, 8);
    constexpr std::size_t kHeader = 33;  // Signature and IHDR.
    bytes.insert(kHeader, "\x7f\xff\xff\xfftEXta");
    surface.file.path = folder.write("text.png", bytes);
    const long before = peak_mebibytes();
    EXPECT_TRUE(surface_solid(surface)->triangles.empty());
    EXPECT_LT(peak_mebibytes() - before, 64);
}

/// Blanks: 300 MiB of them are packed into some hundred KiB.
zip_int64_t blanks(void* left, void* data, zip_uint64_t size, zip_source_cmd_t command) {
    auto& rest = *static_cast<zip_uint64_t*>(left);
    switch (command) {
        case ZIP_SOURCE_READ: {
            const zip_uint64_t count = std::min(rest, size);
            std::fill_n(static_cast<char*>(data), count, ' ');
            rest -= count;
            return static_cast<zip_int64_t>(count);
        }
        case ZIP_SOURCE_STAT:
            zip_stat_init(static_cast<zip_stat_t*>(data));
            return sizeof(zip_stat_t);
        case ZIP_SOURCE_SUPPORTS:
            return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT,
                                                  ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, -1);
        default:
            return 0;
    }
}

TEST(HostileFiles, AnAmfMayBeAnArchive) {
    const test_support::TemporaryFolder folder;
    const std::string path = folder.path("zipped.amf");
    const std::string text =
        "<amf unit='inch'><object id='0'><mesh><vertices>"
        "<vertex><coordinates><x>1</x><y>0</y><z>0</z></coordinates></vertex>"
        "<vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates></vertex>"
        "<vertex><coordinates><x>0</x><y>0</y><z>1</z></coordinates></vertex></vertices><volume>"
        "<triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume></mesh></object></amf>";
    int error = 0;
    zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, &error);
    ASSERT_NE(archive, nullptr);
    zip_source_t* source = zip_source_buffer(archive, text.data(), text.size(), 0);
    ASSERT_GE(zip_file_add(archive, "zipped.amf", source, 0), 0);
    ASSERT_EQ(zip_close(archive), 0);
    csg::Import import;
    import.file.path = path;
    const auto solid = import_solid(import);
    EXPECT_TRUE(solid->failures.empty()) << solid->failures[0];
    ASSERT_EQ(solid->triangles.size(), 1U);
    EXPECT_EQ(solid->points[0].x, 25.4);
}

TEST(HostileFiles, AZipBombIsNotUnpackedBeyondItsLimit) {
    const test_support::TemporaryFolder folder;
    const std::string path = folder.path("bomb.3mf");
    zip_uint64_t left = zip_uint64_t{300} << 20U;
    int error = 0;
    zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, &error);
    ASSERT_NE(archive, nullptr);
    zip_source_t* source = zip_source_function(archive, blanks, &left);
    const zip_int64_t index = zip_file_add(archive, "3D/3dmodel.model", source, 0);
    ASSERT_GE(index, 0);
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), ZIP_CM_DEFLATE, 1);
    ASSERT_EQ(zip_close(archive), 0);
    ASSERT_LT(std::filesystem::file_size(path), 8U << 20U);
    FileMesh mesh;
    std::vector<std::string> warnings;
    read_3mf(path, mesh, warnings);
    EXPECT_TRUE(mesh.faces.empty());
    ASSERT_FALSE(warnings.empty());
    EXPECT_NE(warnings[0].find("unpacks to more than"), std::string::npos) << warnings[0];
}

}  // namespace
