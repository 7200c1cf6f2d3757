#include "csg/reference/mesh_files.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "csg/reference/mesh_text.h"

namespace csg::reference {
namespace {

glm::dvec3 normal_of(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 n = glm::cross(mesh.points[t.y] - mesh.points[t.x], mesh.points[t.z] - mesh.points[t.x]);
    const double length = glm::length(n);
    return length > 0 ? n / length + 0.0 : glm::dvec3(0.0);
}

// Headers are OpenSCAD's where scripts look for them.

std::string ascii_stl(const Mesh& mesh, const std::stop_token& stop) {
    Text out(stop);
    put(out, "solid OpenSCAD_Model\n");
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 n = normal_of(mesh, t);
        put(out, "  facet normal {} {} {}\n    outer loop\n", n.x, n.y, n.z);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p = mesh.points[t[k]] + 0.0;
            put(out, "      vertex {} {} {}\n", p.x, p.y, p.z);
        }
        put(out, "    endloop\n  endfacet\n");
    }
    put(out, "endsolid OpenSCAD_Model\n");
    return out.str();
}

void put_bytes(std::string& out, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) {
        out += static_cast<char>(value >> (8 * i) & 255);
    }
}

void put_float(std::string& out, double value) {
    put_bytes(out, std::bit_cast<std::uint32_t>(static_cast<float>(value + 0.0)), 4);
}

std::string binary_stl(const Mesh& mesh, const std::stop_token& stop) {
    std::string out = "OpenSCAD Model\n";  // Whoever tells binary files by it looks for that.
    out.resize(80, '\0');
    out.reserve(84 + 50 * mesh.triangles.size());
    put_bytes(out, static_cast<std::uint32_t>(mesh.triangles.size()), 4);
    base::PacedStop paced(stop);
    for (const glm::uvec3& t : mesh.triangles) {
        paced();
        const glm::dvec3 n = normal_of(mesh, t);
        for (int k = 0; k < 3; ++k) {
            put_float(out, n[k]);
        }
        for (int k = 0; k < 3; ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                put_float(out, mesh.points[t[k]][axis]);
            }
        }
        put_bytes(out, 0, 2);
    }
    return out;
}

std::string off(const MeshDocument& d, const std::stop_token& stop) {
    Text out(stop);
    put(out, "OFF\n{} {} 0\n", d.mesh.points.size(), d.mesh.triangles.size());
    for (const glm::dvec3& p : d.mesh.points) {
        put(out, "{} {} {}\n", p.x + 0.0, p.y + 0.0, p.z + 0.0);
    }
    for (std::size_t i = 0; i < d.mesh.triangles.size(); ++i) {
        const glm::uvec3& t = d.mesh.triangles[i];
        const auto& c = d.parts[part_of(d, i)].rgba;
        put(out, "3 {} {} {} {} {} {}\n", t.x, t.y, t.z, byte_of(c[0]), byte_of(c[1]), byte_of(c[2]));
    }
    return out.str();
}

std::string one_line(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) <= ' ') {
            c = '_';
        }
    }
    return text;
}

std::string obj(const MeshDocument& d, const std::stop_token& stop) {
    Text out(stop);
    put(out, "# OpenSCAD obj exporter\n");
    for (const glm::dvec3& p : d.mesh.points) {
        put(out, "v {} {} {}\n", p.x + 0.0, p.y + 0.0, p.z + 0.0);
    }
    const auto parts = by_part(d);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].empty()) {
            continue;
        }
        put(out, "g {}\n", one_line(d.parts[p].name));
        for (const std::uint32_t i : parts[p]) {
            const glm::uvec3 t = d.mesh.triangles[i] + 1u;
            put(out, "f {} {} {}\n", t.x, t.y, t.z);
        }
    }
    return out.str();
}

std::string amf(const MeshDocument& d, const std::stop_token& stop) {
    Text out(stop);
    put(out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<amf unit=\"millimeter\">\n"
        " <metadata type=\"producer\">csgscope</metadata>\n");
    for (std::size_t p = 0; p < d.parts.size(); ++p) {
        const auto& c = d.parts[p].rgba;
        put(out,
            " <material id=\"{}\"><metadata type=\"name\">{}</metadata>"
            "<color><r>{}</r><g>{}</g><b>{}</b><a>{}</a></color></material>\n",
            p + 1, xml(d.parts[p].name), c[0], c[1], c[2], c[3]);
    }
    put(out, " <object id=\"0\">\n  <mesh>\n   <vertices>\n");
    for (const glm::dvec3& v : d.mesh.points) {
        put(out, "    <vertex><coordinates><x>{}</x><y>{}</y><z>{}</z></coordinates></vertex>\n", v.x + 0.0, v.y + 0.0,
            v.z + 0.0);
    }
    put(out, "   </vertices>\n");
    const auto parts = by_part(d);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].empty()) {
            continue;
        }
        put(out, "   <volume materialid=\"{}\">\n", p + 1);
        for (const std::uint32_t i : parts[p]) {
            const glm::uvec3& t = d.mesh.triangles[i];
            put(out, "    <triangle><v1>{}</v1><v2>{}</v2><v3>{}</v3></triangle>\n", t.x, t.y, t.z);
        }
        put(out, "   </volume>\n");
    }
    put(out, "  </mesh>\n </object>\n</amf>\n");
    return out.str();
}

std::string wrl(const MeshDocument& d, const std::stop_token& stop) {
    Text out(stop);
    put(out, "#VRML V2.0 utf8\n");
    const auto parts = by_part(d);
    put(out, "Group {{ children [\n");
    bool points_written = false;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].empty()) {
            continue;
        }
        const auto& c = d.parts[p].rgba;
        put(out,
            "Shape {{ appearance Appearance {{ material Material {{ diffuseColor {} {} {} transparency {} }} }}\n"
            "geometry IndexedFaceSet {{ ccw TRUE solid TRUE coord ",
            c[0], c[1], c[2], 1 - c[3]);
        if (points_written) {
            put(out, "USE P");
        } else {
            put(out, "DEF P Coordinate {{ point [\n");
            for (const glm::dvec3& v : d.mesh.points) {
                put(out, "{} {} {},\n", v.x + 0.0, v.y + 0.0, v.z + 0.0);
            }
            put(out, "] }}");
            points_written = true;
        }
        put(out, "\ncoordIndex [\n");
        for (const std::uint32_t i : parts[p]) {
            const glm::uvec3& t = d.mesh.triangles[i];
            put(out, "{},{},{},-1,\n", t.x, t.y, t.z);
        }
        put(out, "] }} }}\n");
    }
    put(out, "] }}\n");
    return out.str();
}

}  // namespace

std::vector<std::vector<std::uint32_t>> by_part(const MeshDocument& d) {
    std::vector<std::vector<std::uint32_t>> triangles(d.parts.size());
    for (std::uint32_t i = 0; i < d.mesh.triangles.size(); ++i) {
        triangles[part_of(d, i)].push_back(i);
    }
    return triangles;
}

std::string xml(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
        }
    }
    return out;
}

std::string encode(const MeshDocument& document, MeshFormat format, const std::stop_token& stop) {
    switch (format) {
        case MeshFormat::AsciiStl:
            return ascii_stl(document.mesh, stop);
        case MeshFormat::BinaryStl:
            return binary_stl(document.mesh, stop);
        case MeshFormat::Off:
            return off(document, stop);
        case MeshFormat::Obj:
            return obj(document, stop);
        case MeshFormat::Amf:
            return amf(document, stop);
        case MeshFormat::ThreeMf:
            return three_mf(document, stop);
        case MeshFormat::Wrl:
            return wrl(document, stop);
        case MeshFormat::Pov:
            return pov(document, stop);
    }
    return {};
}

}  // namespace csg::reference
