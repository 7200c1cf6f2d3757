#include "csg/reference/zip.h"

#include <zlib.h>

#include <cstdint>
#include <stdexcept>

namespace csg::reference {
namespace {

void put(std::string& out, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) {
        out += static_cast<char>(value >> (8 * i) & 255);
    }
}

std::string deflated(const std::string& bytes) {
    z_stream stream{};
    // Negative window: raw deflate, as ZIP has it.
    if (deflateInit2(&stream, 6, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
        throw std::runtime_error("cannot compress: out of memory");
    }
    std::string out(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    const int status = deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    if (status != Z_STREAM_END) {
        throw std::runtime_error("cannot compress");
    }
    return out;
}

}  // namespace

std::string zip(const std::vector<std::pair<std::string, std::string>>& entries) {
    constexpr std::uint32_t kDate = (1u << 5) | 1u;  // 1980-01-01, the first that ZIP knows
    std::string out, directory;
    for (const auto& [name, bytes] : entries) {
        if (bytes.size() >= 0xf0000000u || out.size() >= 0xf0000000u) {
            throw std::runtime_error("the mesh is too large for a 3MF file");
        }
        const std::string packed = deflated(bytes);
        const auto offset = static_cast<std::uint32_t>(out.size());
        std::string head;
        put(head, 20, 2);  // version
        put(head, 0, 2);   // flags
        put(head, 8, 2);   // deflate
        put(head, 0, 2);   // time
        put(head, kDate, 2);
        put(head,
            static_cast<std::uint32_t>(
                crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()))),
            4);
        put(head, static_cast<std::uint32_t>(packed.size()), 4);
        put(head, static_cast<std::uint32_t>(bytes.size()), 4);
        put(head, static_cast<std::uint32_t>(name.size()), 2);
        put(head, 0, 2);  // extra
        put(out, 0x04034b50, 4);
        out.append(head).append(name).append(packed);
        put(directory, 0x02014b50, 4);
        put(directory, 20, 2);
        directory += head;
        put(directory, 0, 2);  // comment
        put(directory, 0, 2);  // disk
        put(directory, 0, 2);  // internal attributes
        put(directory, 0, 4);  // external attributes
        put(directory, offset, 4);
        directory += name;
    }
    const auto start = static_cast<std::uint32_t>(out.size());
    out += directory;
    put(out, 0x06054b50, 4);
    put(out, 0, 4);
    put(out, static_cast<std::uint32_t>(entries.size()), 2);
    put(out, static_cast<std::uint32_t>(entries.size()), 2);
    put(out, static_cast<std::uint32_t>(directory.size()), 4);
    put(out, start, 4);
    put(out, 0, 2);
    return out;
}

}  // namespace csg::reference
