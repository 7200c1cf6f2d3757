// STL, OFF, OBJ, and the choice between them.
#include "csg/solid/import_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "csg/solid/extrude.h"
#include "csg/solid/file_text.h"
#include "csg/solid/files.h"
#include "csg/solid/mesh_checks.h"
#include "csg/solid/triangulate.h"
#include "csg/tree/finite.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostMeshBytes = std::size_t{1} << 30;

void add_triangle(FileMesh& mesh, const glm::dvec3 (&corners)[3], bool& finite) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    if (!is_finite(corners[0]) || !is_finite(corners[1]) || !is_finite(corners[2])) {
        finite = false;
        return;
    }
    mesh.points.insert(mesh.points.end(), corners, corners + 3);
    mesh.faces.push_back({first, first + 1, first + 2});
}

constexpr const char* kNotFinite = "STL file has a triangle with a coordinate that is no finite number; it is ignored";

void read_binary_stl(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings) {
    constexpr std::size_t kHead = 84, kRecord = 50;
    std::uint32_t claimed = 0;
    std::memcpy(&claimed, text.data() + 80, sizeof claimed);
    const std::size_t held = (text.size() - kHead) / kRecord;
    if (claimed > held) {
        warnings.push_back(fmt::format("STL file claims {} triangles and holds {}", claimed, held));
    }
    const std::size_t count = std::min(std::min(std::size_t{claimed}, held), kMostFaces);
    bool finite = true;
    for (std::size_t i = 0; i < count; ++i) {
        float numbers[9];
        std::memcpy(numbers, text.data() + kHead + i * kRecord + 12, sizeof numbers);
        glm::dvec3 corners[3];
        for (int k = 0; k < 9; ++k) {
            corners[k / 3][k % 3] = static_cast<double>(numbers[k]);
        }
        add_triangle(mesh, corners, finite);
    }
    if (!finite) {
        warnings.emplace_back(kNotFinite);
    }
}

bool is_binary_stl(std::string_view text) {
    if (text.size() < 84) {
        return false;
    }
    std::uint32_t claimed = 0;
    std::memcpy(&claimed, text.data() + 80, sizeof claimed);
    if (text.size() == 84 + std::size_t{claimed} * 50) {
        return true;
    }
    // A text begins with "solid" and names facets soon.
    return !text.starts_with("solid") || text.substr(0, 1024).find("facet") == std::string_view::npos;
}

/// Unites equal points, turns faces into triangles and drops what has no extent. `failures`: of what was read.
std::shared_ptr<Solid> to_solid(FileMesh mesh, std::vector<std::string> failures) {
    auto solid = std::make_shared<Solid>();
    bool all = mesh.faces.size() < kMostFaces;  // Readers end there.
    const std::vector<std::uint32_t> first = first_of_equals(mesh.points);
    solid->points = std::move(mesh.points);
    for (auto& face : mesh.faces) {
        weld(face, first);
        triangulate(solid->points, face, solid->triangles);
        if (solid->triangles.size() > kMostTriangles) {
            all = false;
            break;
        }
    }
    if (!all) {
        failures.push_back(fmt::format("mesh has {} triangles or more; the rest is left out", kMostTriangles));
    }
    finish(*solid);
    if (!solid->triangles.empty() && !solid->closed) {
        solid->warnings.emplace_back("mesh is not closed, or its faces are not all oriented alike");
    }
    solid->failures = std::move(failures);
    return solid;
}

void center(FileMesh& mesh) {
    Box box;
    for (const glm::dvec3& p : mesh.points) {
        box = enclose(box, p);
    }
    if (box.empty()) {
        return;
    }
    const glm::dvec3 middle = box.center();
    for (glm::dvec3& p : mesh.points) {
        p -= middle;
    }
}

}  // namespace

void read_stl(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings) {
    if (is_binary_stl(text)) {
        return read_binary_stl(text, mesh, warnings);
    }
    Words words(text);
    glm::dvec3 corners[3];
    int corner = 0;
    bool finite = true;
    while (!words.at_end() && mesh.faces.size() < kMostFaces) {
        const std::string_view word = words.next();
        if (word == "outer" || word == "OUTER") {
            corner = 0;
        } else if (word == "vertex" || word == "VERTEX") {
            glm::dvec3 p;
            for (int i = 0; i < 3; ++i) {
                p[i] = words.number().value_or(std::nan(""));
            }
            if (corner < 3) {
                corners[corner] = p;
            }
            if (++corner == 3) {
                add_triangle(mesh, corners, finite);
            }
        }
    }
    if (!finite) {
        warnings.emplace_back(kNotFinite);
    }
    if (mesh.faces.empty() && text.find_first_not_of(" \t\r\n") != std::string_view::npos &&
        text.find("endsolid") == std::string_view::npos) {
        warnings.emplace_back("STL file holds no triangles");
    }
}

/// The word OFF may be missing, where a line of three counts tells what the file is.
bool begins_with_counts(std::string_view text) {
    Words words(text, true);
    (void)words.at_end();
    Words counts(words.line(), true);
    return counts.count() && counts.count() && counts.count();
}

void read_off(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings) {
    Words words(text, true);
    if (!begins_with_counts(text) && !words.next().ends_with("OFF")) {
        warnings.emplace_back("OFF file does not begin with OFF");
        return;
    }
    const std::size_t points = words.count().value_or(0), faces = words.count().value_or(0);
    words.line();
    for (std::size_t i = 0; i < points && !words.at_end(); ++i) {
        Words line(words.line());
        glm::dvec3 p;
        for (int k = 0; k < 3; ++k) {
            p[k] = line.number().value_or(0);
        }
        mesh.points.push_back(p);
    }
    for (std::size_t i = 0; i < faces && !words.at_end() && mesh.faces.size() < kMostFaces; ++i) {
        Words line(words.line());
        const std::size_t corners = line.count().value_or(0);
        std::vector<std::uint32_t> face;
        for (std::size_t k = 0; k < corners && !line.at_end(); ++k) {
            const auto index = line.count();
            if (index && *index < mesh.points.size()) {
                face.push_back(static_cast<std::uint32_t>(*index));
            } else {
                warnings.emplace_back("OFF file has a face with an index that is out of bounds; it is ignored");
            }
        }
        mesh.faces.push_back(std::move(face));
        if (warnings.size() > 10) {
            return;
        }
    }
    if (mesh.points.size() < points || mesh.faces.size() < faces) {
        warnings.emplace_back("OFF file ends early");
    }
}

void read_obj(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings) {
    Words words(text, true);
    bool bad = false;
    while (!words.at_end() && mesh.faces.size() < kMostFaces) {
        const std::string_view kind = words.next();
        Words line(words.line(), true);
        if (kind == "v") {
            glm::dvec3 p;
            for (int k = 0; k < 3; ++k) {
                p[k] = line.number().value_or(0);
            }
            mesh.points.push_back(p);
        } else if (kind == "f") {
            std::vector<std::uint32_t>& face = mesh.faces.emplace_back();
            while (!line.at_end()) {
                const std::string_view word = line.next();
                const auto number = to_number(word.substr(0, word.find('/')));
                // Counted from 1, or back from the last one.
                const double count = static_cast<double>(mesh.points.size());
                const double index = !number ? -1 : *number < 0 ? count + *number : *number - 1;
                if (index >= 0 && index < count) {
                    face.push_back(static_cast<std::uint32_t>(index));
                } else {
                    bad = true;
                }
            }
        }
    }
    if (bad) {
        warnings.emplace_back("OBJ file has a face with an index that is out of bounds; it is ignored");
    }
}

std::shared_ptr<Solid> import_solid(const Import& import) {
    FileMesh mesh;
    std::vector<std::string> failures;
    const std::string suffix = file_suffix(import.file.path);
    if (suffix == "3mf") {
        read_3mf(import.file.path, mesh, failures);
    } else if (suffix == "stl" || suffix == "off" || suffix == "obj" || suffix == "amf") {
        if (const auto text = read_file(import.file.path, kMostMeshBytes, failures)) {
            const auto read = suffix == "stl"   ? read_stl
                              : suffix == "off" ? read_off
                              : suffix == "obj" ? read_obj
                                                : read_amf;
            if (suffix == "amf" && text->starts_with("PK\x03\x04")) {
                read_zipped_amf(import.file.path, mesh, failures);
            } else {
                read(*text, mesh, failures);
            }
        }
    } else {
        failures.push_back(
            import.file.path.empty()
                ? "import() without a file"
                : fmt::format("Unsupported file format while trying to import file '{}'", import.file.path));
    }
    if (import.center) {
        center(mesh);
    }
    return to_solid(std::move(mesh), std::move(failures));
}

}  // namespace csg::solid
