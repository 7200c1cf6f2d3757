// 3MF core specification 1.3, and color groups of the materials extension: a package with one model. Parts are entries
// of one group of properties, triangle by triangle, so that the object stays one closed surface.
#include "csg/reference/mesh_text.h"
#include "csg/reference/zip.h"

namespace csg::reference {
namespace {

std::string hex(const std::array<float, 4>& rgba) {
    return fmt::format("#{:02X}{:02X}{:02X}{:02X}", byte_of(rgba[0]), byte_of(rgba[1]), byte_of(rgba[2]),
                       byte_of(rgba[3]));
}

/// A coordinate with all its digits, or with as many decimals as are asked for.
std::string coordinate(double value, int decimals) {
    if (decimals == 0) {
        return fmt::format("{}", value + 0.0);
    }
    std::string text = fmt::format("{:.{}f}", value, decimals);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
        text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

/// The group of properties, resource 1.
void put_properties(Text& out, const MeshDocument& d) {
    const ThreeMfOptions& how = d.three_mf;
    const bool selected = how.colors == ThreeMfColors::Selected;
    const char* const group = how.color_group ? "m:colorgroup" : "basematerials";
    put(out, "  <{} id=\"1\">\n", group);
    for (const MeshPart& part : d.parts) {
        const std::string color = hex(selected ? how.selected : part.rgba);
        if (how.color_group) {
            put(out, "   <m:color color=\"{}\"/>\n", color);
        } else {
            put(out, "   <base name=\"{}\" displaycolor=\"{}\"/>\n", xml(part.name), color);
        }
    }
    put(out, "  </{}>\n", group);
}

std::string model(const MeshDocument& d, const std::stop_token& stop) {
    const ThreeMfOptions& how = d.three_mf;
    const bool colored = how.colors != ThreeMfColors::None;
    Text out(stop);
    put(out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"{}\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"{}>\n"
        " <metadata name=\"Application\">csgscope</metadata>\n",
        how.unit,
        how.color_group && colored ? " xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\"" : "");
    for (const auto& [name, value] : how.meta_data) {
        if (!value.empty()) {
            put(out, " <metadata name=\"{}\">{}</metadata>\n", name, xml(value));
        }
    }
    put(out, " <resources>\n");
    if (colored) {
        put_properties(out, d);
    }
    put(out, "  <object id=\"2\" type=\"model\"{}>\n   <mesh>\n    <vertices>\n",
        colored ? " pid=\"1\" pindex=\"0\"" : "");
    for (const glm::dvec3& v : d.mesh.points) {
        put(out, "     <vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", coordinate(v.x, how.decimals),
            coordinate(v.y, how.decimals), coordinate(v.z, how.decimals));
    }
    put(out, "    </vertices>\n    <triangles>\n");
    for (std::size_t i = 0; i < d.mesh.triangles.size(); ++i) {
        const glm::uvec3& t = d.mesh.triangles[i];
        const std::uint32_t part = part_of(d, i);
        if (part == 0 || !colored) {
            put(out, "     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", t.x, t.y, t.z);
        } else {
            put(out, "     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\" pid=\"1\" p1=\"{}\"/>\n", t.x, t.y, t.z, part);
        }
    }
    put(out,
        "    </triangles>\n   </mesh>\n  </object>\n </resources>\n <build><item objectid=\"2\"/></build>\n"
        "</model>\n");
    return out.str();
}

}  // namespace

std::string three_mf(const MeshDocument& document, const std::stop_token& stop) {
    const std::string types =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
        "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
        "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
        "</Types>\n";
    const std::string relations =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
    return zip(
        {{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {"3D/3dmodel.model", model(document, stop)}});
}

}  // namespace csg::reference
