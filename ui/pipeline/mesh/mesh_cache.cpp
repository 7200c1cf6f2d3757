#include "ui/pipeline/mesh/mesh_cache.h"

#include <cstring>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "base/file.h"
#include "csg/tree/hash.h"

namespace ui {

namespace {

constexpr char kMagic[] = "csgscope mesh 1\n";
constexpr std::size_t kMagicSize = sizeof kMagic - 1;

struct Header {
    MeshKey key;
    std::uint64_t points, triangles, method_size, reason_size;
};

std::uint64_t checksum(const char* data, std::size_t size) {
    std::uint64_t sum = csg::mix(0, size);
    for (std::size_t i = 0; i < size; i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, data + i, std::min<std::size_t>(8, size - i));
        sum = csg::mix(sum, word);
    }
    return sum;
}

template <typename T>
void put(std::string& out, const T* values, std::size_t count) {
    out.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <typename T>
void take(const char*& at, T* values, std::size_t count) {
    std::memcpy(values, at, count * sizeof(T));
    at += count * sizeof(T);
}

}  // namespace

MeshKey mesh_key(const Model& model) {
    MeshKey key{1, 2};
    const auto add = [&](auto value) {
        for (std::uint64_t& half : key) {
            half = csg::mix(half, value);
        }
    };
    const auto count = [&](std::size_t value) { add(std::uint64_t{value}); };
    for (const auto& leaf : model.geometry.leaves) {
        count(leaf.points.size());
        for (const glm::dvec3& p : leaf.points) {
            add(p.x);
            add(p.y);
            add(p.z);
        }
        count(leaf.triangles.size());
        for (const glm::uvec3& t : leaf.triangles) {
            add(std::uint64_t{t.x} << 32 | t.y);
            add(std::uint64_t{t.z});
        }
    }
    for (const csg::Part& part : model.scene.parts) {
        count(static_cast<std::size_t>(part.kind));
        count(part.root);
    }
    for (const csg::Expression& e : model.scene.expressions) {
        count(static_cast<std::size_t>(e.kind));
        count(e.leaf);
        for (const std::uint32_t child : model.scene.children(e)) {
            count(child);
        }
    }
    return key;
}

std::string encode_kept(const MeshKey& key, const ModelMesh& mesh) {
    std::string out(kMagic, kMagicSize);
    const Header header{key, mesh.mesh.points.size(), mesh.mesh.triangles.size(), mesh.method.size(),
                        mesh.reason.size()};
    put(out, &header, 1);
    put(out, mesh.mesh.points.data(), mesh.mesh.points.size());
    put(out, mesh.mesh.triangles.data(), mesh.mesh.triangles.size());
    put(out, mesh.mesh.sources.data(), mesh.mesh.sources.size());
    out += mesh.method + mesh.reason;
    const std::uint64_t sum = checksum(out.data(), out.size());
    put(out, &sum, 1);
    return out;
}

std::optional<ModelMesh> decode_kept(const MeshKey& key, const std::string& bytes, std::size_t leaves) {
    constexpr std::size_t kFixed = kMagicSize + sizeof(Header) + sizeof(std::uint64_t);
    if (bytes.size() < kFixed || std::memcmp(bytes.data(), kMagic, kMagicSize) != 0) {
        return {};
    }
    const char* at = bytes.data() + kMagicSize;
    Header header{};
    take(at, &header, 1);
    // Each count is bounded by the file's size before it is multiplied.
    const std::uint64_t size = bytes.size();
    if (header.key != key || header.points > size || header.triangles > size || header.method_size > size ||
        header.reason_size > size ||
        kFixed + header.points * sizeof(glm::dvec3) + header.triangles * (sizeof(glm::uvec3) + 4) + header.method_size +
                header.reason_size !=
            size) {
        return {};
    }
    std::uint64_t sum = 0;
    std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
    if (sum != checksum(bytes.data(), bytes.size() - sizeof sum)) {
        return {};
    }
    ModelMesh mesh;
    mesh.mesh.points.resize(header.points);
    mesh.mesh.triangles.resize(header.triangles);
    mesh.mesh.sources.resize(header.triangles);
    take(at, mesh.mesh.points.data(), header.points);
    take(at, mesh.mesh.triangles.data(), header.triangles);
    take(at, mesh.mesh.sources.data(), header.triangles);
    mesh.method.assign(at, header.method_size);
    mesh.reason.assign(at + header.method_size, header.reason_size);
    for (std::size_t i = 0; i < mesh.mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.mesh.triangles[i];
        if (t.x >= header.points || t.y >= header.points || t.z >= header.points || mesh.mesh.sources[i] >= leaves) {
            return {};
        }
    }
    mesh.facts = csg::reference::facts(mesh.mesh);
    return mesh;
}

std::shared_ptr<const ModelMesh> MeshCache::get(const Model& model, const std::stop_token& stop) {
    const MeshKey key = mesh_key(model);
    problem_.clear();
    hit_ = true;
    if (const auto known = memory_.find(key); known != memory_.end()) {
        return known->second;
    }
    const auto keep = [&](ModelMesh mesh) {
        if (memory_.size() >= kMostInMemory) {
            memory_.clear();
        }
        return memory_[key] = std::make_shared<const ModelMesh>(std::move(mesh));
    };
    const auto path = folder_ / fmt::format("{:016x}{:016x}.mesh", key[0], key[1]);
    if (!folder_.empty()) {
        if (const auto bytes = base::read_regular_file(path)) {
            if (auto mesh = decode_kept(key, *bytes, model.scene.leaves.size())) {
                return keep(std::move(*mesh));
            }
        }
    }
    hit_ = false;
    auto mesh = keep(make_mesh(model, stop));
    if (!folder_.empty()) {
        try {
            base::make_folder(folder_);
            if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
                throw std::runtime_error(path.string() + " is no regular file");
            }
            base::write_file(path, encode_kept(key, *mesh));
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& error) {
            problem_ = fmt::format("the mesh is not kept: {}", error.what());
        }
    }
    return mesh;
}

}  // namespace ui
