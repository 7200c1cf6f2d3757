// Meshes from texts of the formats that csg/solid/files.h names. Each reads what it can; numbers of things that a file
// claims are never believed before the things are there.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/solid/solid.h"

namespace csg::solid {

/// What is read: points and faces of any number of corners.
struct FileMesh {
    std::vector<glm::dvec3> points;
    std::vector<std::vector<std::uint32_t>> faces;  ///< Counter-clockwise seen from outside.
};

inline constexpr std::size_t kMostFaces = kMostTriangles;

void read_stl(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings);
void read_off(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings);
void read_obj(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings);
/// Of xml; objects one after the other.
void read_amf(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings);
/// The model file (xml) of a 3mf archive: what it builds, put together of its objects.
void read_3mf_model(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings);
/// The archive at `path`.
void read_3mf(const std::string& path, FileMesh& mesh, std::vector<std::string>& warnings);
/// The archive at `path`, whose first file is the xml.
void read_zipped_amf(const std::string& path, FileMesh& mesh, std::vector<std::string>& warnings);

}  // namespace csg::solid
