// Meshes as files: STL, OFF, OBJ, AMF, 3MF, VRML and scenes of POV-Ray. The same mesh gives the same bytes.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

enum class MeshFormat { AsciiStl, BinaryStl, Off, Obj, Amf, ThreeMf, Wrl, Pov };

/// One object of a file: a range of the mesh's triangles with a name and a color.
struct MeshPart {
    std::string name;
    std::array<float, 4> rgba{0.976f, 0.843f, 0.173f, 1};  ///< sRGB, 0 to 1.
};

enum class ThreeMfColors { Model, None, Selected };

struct ThreeMfOptions {
    std::string unit = "millimeter";  ///< One of the specification's names.
    ThreeMfColors colors = ThreeMfColors::Model;
    std::array<float, 4> selected{0.976f, 0.843f, 0.173f, 1};  ///< The color of all parts for Selected.
    bool color_group = false;  ///< Colors as colors (materials extension), without the names of parts.
    int decimals = 0;          ///< Of coordinates; 0: as many as are needed to read them back to the last bit.
    std::map<std::string, std::string> meta_data;  ///< By the specification's names; empty texts are left out.
};

/// How a scene of POV-Ray is looked at; world coordinates.
struct PovView {
    std::array<double, 3> eye{0, 0, 140}, center{0, 0, 0}, up{0, 1, 0};
    double fov = 22.5;       ///< Vertical, degrees; 0: orthographic.
    double half_height = 1;  ///< World units, where it is orthographic.
    double aspect = 1;       ///< Width by height.
};

/// What is written: `part_of` gives each triangle's part (all 0 where it is empty).
struct MeshDocument {
    const Mesh& mesh;
    std::vector<MeshPart> parts;
    std::vector<std::uint32_t> part_of;
    ThreeMfOptions three_mf;  ///< For 3MF only.
    PovView view{};           ///< For POV-Ray only.
};

/// The bytes of the file. Coordinates are written so that they are read back to the last bit (STL in single precision
/// where binary). Formats that know parts (OBJ, AMF, 3MF) keep names, those that know colors (OFF, AMF, 3MF, WRL, POV)
/// colors. Throws base::Stopped where `stop` asked for it.
[[nodiscard]] std::string encode(const MeshDocument& document, MeshFormat format, const std::stop_token& stop = {});

/// Reads STL (either kind) or OFF; equal points are one. Throws std::runtime_error with the reason.
[[nodiscard]] Mesh decode_mesh(std::string_view bytes);

}  // namespace csg::reference
