// Meshes kept by the content of what they were made from: in memory, and in a folder where one is given.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "ui/pipeline/mesh/mesh.h"

namespace ui {

/// 128 bits over the placed leaves and expressions; places in the source and colors left out.
using MeshKey = std::array<std::uint64_t, 2>;

[[nodiscard]] MeshKey mesh_key(const Model& model);

class MeshCache {
  public:
    /// `folder`: created when the first mesh is kept; empty for none. Several programs may share it: a file is written
    /// under another name and renamed, and one that is torn or damaged counts as absent.
    explicit MeshCache(std::filesystem::path folder = {}) : folder_(std::move(folder)) {}

    /// As make_mesh, unless the mesh is known. That a mesh cannot be kept on disk is no error; `problem` tells.
    [[nodiscard]] std::shared_ptr<const ModelMesh> get(const Model& model, const std::stop_token& stop = {});

    [[nodiscard]] const std::string& problem() const { return problem_; }
    [[nodiscard]] bool hit() const { return hit_; }  ///< Was the last mesh known?

  private:
    static constexpr std::size_t kMostInMemory = 8;
    std::filesystem::path folder_;
    std::map<MeshKey, std::shared_ptr<const ModelMesh>> memory_;
    std::string problem_;
    bool hit_ = false;
};

/// The bytes of a kept mesh, and the mesh again; none where the bytes are not those of a whole mesh with this key.
[[nodiscard]] std::string encode_kept(const MeshKey& key, const ModelMesh& mesh);
[[nodiscard]] std::optional<ModelMesh> decode_kept(const MeshKey& key, const std::string& bytes, std::size_t leaves);

}  // namespace ui
