// AMF and 3MF: meshes in XML; 3MF is a zip archive of it.
#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "csg/solid/file_text.h"
#include "csg/solid/import_mesh.h"
#include "csg/solid/xml.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostUnpacked = std::size_t{256} << 20;

double number(std::string_view text) {
    return to_number(text).value_or(0);
}

std::optional<std::uint32_t> index(std::string_view text, std::size_t first, std::size_t count) {
    const auto number = to_number(text);
    if (!number || *number < 0 || *number >= static_cast<double>(count)) {
        return std::nullopt;
    }
    return static_cast<std::uint32_t>(first + static_cast<std::size_t>(*number));
}

/// Adds the face where all of its indices are good.
bool add_face(FileMesh& mesh, const std::array<std::string_view, 3>& words, std::size_t first) {
    std::vector<std::uint32_t> face;
    for (const std::string_view word : words) {
        if (const auto i = index(word, first, mesh.points.size() - first)) {
            face.push_back(*i);
        }
    }
    if (face.size() != 3 || mesh.faces.size() >= kMostFaces) {
        return false;
    }
    mesh.faces.push_back(std::move(face));
    return true;
}

/// A transform of 3MF: twelve numbers, four rows of three for row vectors.
glm::dmat4 matrix(std::string_view text) {
    glm::dmat4 m(1.0);
    Words words(text);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column) {
            const auto n = words.number();
            if (!n) {
                return glm::dmat4(1.0);
            }
            m[row][column] = *n;
        }
    }
    return m;
}

/// What of a model file is needed: meshes by object, components, and what is built.
class Model3mf {
  public:
    void open(const std::string& name, const Attributes& a) {
        if (name == "model") {
            const std::string_view unit = attribute(a, "unit");
            scale_ = unit == "micron"       ? 0.001
                     : unit == "centimeter" ? 10
                     : unit == "inch"       ? 25.4
                     : unit == "foot"       ? 304.8
                     : unit == "meter"      ? 1000
                                            : 1;
        } else if (name == "object") {
            object_ = &objects_[std::string(attribute(a, "id"))];
        } else if (name == "vertex" && object_ != nullptr) {
            object_->mesh.points.emplace_back(number(attribute(a, "x")), number(attribute(a, "y")),
                                              number(attribute(a, "z")));
        } else if (name == "triangle" && object_ != nullptr) {
            bad_ |= !add_face(object_->mesh, {attribute(a, "v1"), attribute(a, "v2"), attribute(a, "v3")}, 0);
        } else if (name == "component" && object_ != nullptr) {
            object_->components.push_back(reference(a));
        } else if (name == "item") {
            items_.push_back(reference(a));
        }
    }

    void build(FileMesh& mesh, std::vector<std::string>& warnings) const {
        glm::dmat4 unit(1.0);
        unit[0][0] = unit[1][1] = unit[2][2] = scale_;
        Assembly assembly{mesh, {}, 0, false, false, false};
        for (const Reference& item : items_) {
            add({item.object, unit * item.placed}, assembly);
        }
        if (bad_) {
            warnings.emplace_back("3MF file has triangles whose indices are out of bounds; they are ignored");
        }
        if (assembly.in_itself) {
            warnings.emplace_back("3MF file has an object that is a component of itself; it is left out there");
        }
        if (assembly.too_deep) {
            warnings.push_back(
                fmt::format("3MF file has components nested deeper than {}; they are left out", kDeepest));
        }
        if (assembly.too_many) {
            warnings.push_back(
                fmt::format("3MF file has more than {} components, or more than {} triangles; the rest is left out",
                            kMostObjects, kMostFaces));
        }
        if (assembly.made > kMostObjects) {
            warnings.push_back(fmt::format("3MF file has more than {} components; the rest is left out", kMostObjects));
        }
    }

  private:
    struct Reference {
        std::string object;
        glm::dmat4 placed;
    };
    static Reference reference(const Attributes& a) {
        return {std::string(attribute(a, "objectid")), matrix(attribute(a, "transform"))};
    }
    struct Object {
        FileMesh mesh;
        std::vector<Reference> components;
    };
    static constexpr unsigned kMostObjects = 100'000;
    static constexpr std::size_t kDeepest = 32;
    /// What is put together from objects.
    struct Assembly {
        FileMesh& mesh;
        std::vector<const Object*> within;  ///< The objects that the next one is part of, the outermost first.
        unsigned made = 0;
        bool in_itself = false, too_deep = false, too_many = false;
    };

    void add(const Reference& reference, Assembly& assembly) const {
        const auto found = objects_.find(reference.object);
        if (found == objects_.end()) {
            return;
        }
        const Object& object = found->second;
        FileMesh& mesh = assembly.mesh;
        if (std::find(assembly.within.begin(), assembly.within.end(), &object) != assembly.within.end()) {
            assembly.in_itself = true;
            return;
        }
        assembly.too_deep |= assembly.within.size() > kDeepest;
        assembly.too_many |= assembly.made == kMostObjects || mesh.faces.size() + object.mesh.faces.size() > kMostFaces;
        if (assembly.within.size() > kDeepest || assembly.too_many) {
            return;
        }
        ++assembly.made;
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (const glm::dvec3& p : object.mesh.points) {
            mesh.points.emplace_back(reference.placed * glm::dvec4(p, 1.0));
        }
        for (const auto& face : object.mesh.faces) {
            mesh.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
        }
        assembly.within.push_back(&object);
        for (const Reference& component : object.components) {
            add({component.object, reference.placed * component.placed}, assembly);
        }
        assembly.within.pop_back();
    }

    std::map<std::string, Object> objects_;
    Object* object_ = nullptr;
    std::vector<Reference> items_;
    double scale_ = 1;
    bool bad_ = false;
};

/// The text of the first file in the archive whose name ends so; `kind`: what the archive is, for people.
std::optional<std::string> unpacked(const std::string& path, std::string_view ending, std::string_view kind,
                                    std::vector<std::string>& warnings) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {  // Opening a pipe would wait.
        warnings.push_back(fmt::format("Can't open import file '{}'", path));
        return std::nullopt;
    }
    int error = 0;
    const std::unique_ptr<zip_t, void (*)(zip_t*)> archive(zip_open(path.c_str(), ZIP_RDONLY, &error), zip_discard);
    if (!archive) {
        warnings.push_back(fmt::format("Can't open import file '{}' as a {} archive", path, kind));
        return std::nullopt;
    }
    const zip_int64_t entries = zip_get_num_entries(archive.get(), 0);
    for (zip_int64_t i = 0; i < entries; ++i) {
        const char* name = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
        if (name == nullptr || !std::string_view(name).ends_with(ending)) {
            continue;
        }
        const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
            zip_fopen_index(archive.get(), static_cast<zip_uint64_t>(i), 0), zip_fclose);
        std::string text;
        std::array<char, 65536> buffer{};
        while (file) {
            const zip_int64_t got = zip_fread(file.get(), buffer.data(), buffer.size());
            if (got <= 0) {
                return text;
            }
            text.append(buffer.data(), static_cast<std::size_t>(got));
            if (text.size() > kMostUnpacked) {
                warnings.push_back(
                    fmt::format("'{}' unpacks to more than {} bytes; it is left out", path, kMostUnpacked));
                return std::nullopt;
            }
        }
    }
    warnings.push_back(fmt::format("{} file '{}' holds no model", kind, path));
    return std::nullopt;
}

}  // namespace

void read_amf(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings) {
    std::size_t first = 0;
    double scale = 1;
    std::array<std::string, 3> corners;
    glm::dvec3 point(0.0);
    bool bad = false;
    XmlEvents events;
    events.open = [&](const std::string& name, const Attributes& attributes) {
        if (name == "amf") {
            const std::string_view unit = attribute(attributes, "unit");
            scale = unit == "inch"     ? 25.4
                    : unit == "feet"   ? 304.8
                    : unit == "meter"  ? 1000
                    : unit == "micron" ? 0.001
                                       : 1;
        } else if (name == "mesh") {
            first = mesh.points.size();
        } else if (name == "triangle") {
            corners = {};
        }
    };
    events.close = [&](const std::string& name, const std::string& content) {
        if (name == "x" || name == "y" || name == "z") {
            point[name[0] - 'x'] = Words(content).number().value_or(0) * scale;
        } else if (name == "vertex") {
            mesh.points.push_back(point);
        } else if (name == "v1" || name == "v2" || name == "v3") {
            corners[static_cast<std::size_t>(name[1] - '1')] = std::string(Words(content).next());
        } else if (name == "triangle") {
            bad |= !add_face(mesh, {corners[0], corners[1], corners[2]}, first);
        }
    };
    read_xml(text, events, warnings);
    if (bad) {
        warnings.emplace_back("AMF file has triangles whose indices are out of bounds; they are ignored");
    }
}

void read_3mf_model(std::string_view text, FileMesh& mesh, std::vector<std::string>& warnings) {
    Model3mf model;
    XmlEvents events;
    events.open = [&](const std::string& name, const Attributes& attributes) { model.open(name, attributes); };
    read_xml(text, events, warnings);
    model.build(mesh, warnings);
}

void read_3mf(const std::string& path, FileMesh& mesh, std::vector<std::string>& warnings) {
    if (const auto text = unpacked(path, ".model", "3MF", warnings)) {
        read_3mf_model(*text, mesh, warnings);
    }
}

void read_zipped_amf(const std::string& path, FileMesh& mesh, std::vector<std::string>& warnings) {
    if (const auto text = unpacked(path, "", "AMF", warnings)) {
        read_amf(*text, mesh, warnings);
    }
}

}  // namespace csg::solid
