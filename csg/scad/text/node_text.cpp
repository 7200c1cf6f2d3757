#include "csg/scad/text/node_text.h"

#include <array>
#include <charconv>
#include <concepts>

#include "csg/scad/value/number_text.h"
#include "csg/scad/value/quoted.h"

namespace csg::scad {

namespace {

struct Quoted {
    std::string_view text;
};

void put_one(std::string& out, const glm::dvec3& v);
void put_one(std::string& out, const glm::dvec2& v);
void put_one(std::string& out, const Fineness& f);

void put_one(std::string& out, const char* text) {
    out += text;
}
void put_one(std::string& out, const Quoted& q) {
    out += quoted(q.text);
}
void put_one(std::string& out, char c) {
    out += c;
}
void put_one(std::string& out, double value) {
    append_number(out, value);
}
void put_one(std::string& out, bool value) {
    out += value ? "true" : "false";
}

template <std::integral Integer>
void put_one(std::string& out, Integer value) {
    std::array<char, 24> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    out.append(digits.data(), end.ptr);
}

/// Appends each in turn.
template <typename... Parts>
void put(std::string& out, const Parts&... parts) {
    (put_one(out, parts), ...);
}

void put_one(std::string& out, const glm::dvec3& v) {
    put(out, '[', v.x, ", ", v.y, ", ", v.z, ']');
}
void put_one(std::string& out, const glm::dvec2& v) {
    put(out, '[', v.x, ", ", v.y, ']');
}
void put_one(std::string& out, const Fineness& f) {
    put(out, "$fn = ", f.fn);
    if (f.fe) {
        put(out, ", $fe = ", *f.fe);
    }
    put(out, ", $fa = ", f.fa, ", $fs = ", f.fs);
}

/// "[1, 2, 3]"
template <typename Range>
void put_list(std::string& out, const Range& items) {
    const char* before = "[";
    for (const auto& item : items) {
        out += before;
        put_one(out, item);
        before = ", ";
    }
    out += items.empty() ? "[]" : "]";
}

/// "[[1, 2, 3], [3, 4]]"
void put_lists(std::string& out, const std::vector<std::vector<std::uint32_t>>& lists) {
    out += '[';
    for (std::size_t i = 0; i < lists.size(); ++i) {
        out += i == 0 ? "" : ", ";
        put_list(out, lists[i]);
    }
    out += ']';
}

struct LeafText {
    std::string& out;

    void operator()(const Cube& c) const { put(out, "cube(size = ", c.size, ", center = ", c.center, ')'); }
    void operator()(const Sphere& s) const { put(out, "sphere(", s.fineness, ", r = ", s.radius, ')'); }
    void operator()(const Cylinder& c) const {
        put(out, "cylinder(", c.fineness, ", h = ", c.height, ", r1 = ", c.radius1, ", r2 = ", c.radius2,
            ", center = ", c.center, ')');
    }
    void operator()(const std::shared_ptr<const Polyhedron>& p) const {
        out += "polyhedron(points = ";
        put_list(out, p->points);
        out += ", faces = ";
        put_lists(out, p->faces);
        put(out, ", convexity = ", p->convexity, ')');
    }
    void operator()(const Square& s) const { put(out, "square(size = ", s.size, ", center = ", s.center, ')'); }
    void operator()(const Circle& c) const { put(out, "circle(", c.fineness, ", r = ", c.radius, ')'); }
    void operator()(const std::shared_ptr<const Polygon>& p) const {
        out += "polygon(points = ";
        put_list(out, p->points);
        out += ", paths = ";
        if (p->has_paths && !p->paths.empty()) {
            put_lists(out, p->paths);
        } else {
            out += "undef";
        }
        put(out, ", convexity = ", p->convexity, ')');
    }
    void operator()(const std::shared_ptr<const Text>& t) const {
        put(out, "text(text = ", Quoted{t->text}, ", size = ", t->size, ", spacing = ", t->spacing,
            ", font = ", Quoted{t->font}, ", direction = ", Quoted{t->direction}, ", language = ", Quoted{t->language});
        if (!t->script.empty()) {
            put(out, ", script = ", Quoted{t->script});
        }
        put(out, ", halign = ", Quoted{t->halign}, ", valign = ", Quoted{t->valign}, ", ", t->fineness, ')');
    }
    void operator()(const std::shared_ptr<const Import>& i) const {
        put(out, "import(file = ", Quoted{i->file.shown});
        if (!i->id.empty()) {
            put(out, ", id = ", Quoted{i->id});
        }
        if (!i->layer.empty()) {
            put(out, ", layer = ", Quoted{i->layer});
        }
        put(out, ", origin = ", i->origin, ", scale = ", i->scale, ", center = ", i->center);
        if (i->dpi != 72) {
            put(out, ", dpi = ", i->dpi);
        }
        put(out, ", convexity = ", i->convexity, ", ", i->fineness, ", timestamp = ", i->file.modified, ')');
    }
    void operator()(const std::shared_ptr<const Surface>& s) const {
        put(out, "surface(file = ", Quoted{s->file.shown}, ", center = ", s->center, ", invert = ", s->invert,
            ", timestamp = ", s->file.modified, ')');
    }
};

struct MeshText {
    std::string& out;

    void operator()(const LinearExtrude& e) const {
        put(out, "linear_extrude(height = ", e.height);
        if (e.has_direction) {
            put(out, ", v = [ ", e.direction.x, ", ", e.direction.y, ", ", e.direction.z, ']');
        }
        if (e.center) {
            out += ", center = true";
        }
        if (e.twist) {
            put(out, ", twist = ", *e.twist);
        }
        if (e.slices) {
            put(out, ", slices = ", *e.slices);
        }
        if (e.segments) {
            put(out, ", segments = ", *e.segments);
        }
        if (e.scale.x != e.scale.y) {
            put(out, ", scale = ", e.scale);
        } else if (e.scale.x != 1) {
            put(out, ", scale = ", e.scale.x);
        }
        if (!e.slices || !e.segments) {
            put(out, ", ", e.fineness);
        }
        if (e.convexity > 1) {
            put(out, ", convexity = ", e.convexity);
        }
        out += ')';
    }
    void operator()(const RotateExtrude& e) const {
        put(out, "rotate_extrude(angle = ", e.angle, ", start = ", e.start, ", convexity = ", e.convexity, ", ",
            e.fineness, ')');
    }
    void operator()(const Offset& o) const {
        const bool round = o.corner == Offset::Corner::Round;
        put(out, "offset(", round ? "r" : "delta", " = ", o.distance);
        if (!round) {
            put(out, ", chamfer = ", o.corner == Offset::Corner::Chamfer);
        }
        put(out, ", ", o.fineness, ')');
    }
    void operator()(const Fill&) const { out += "fill()"; }
    void operator()(const Projection& p) const {
        put(out, "projection(cut = ", p.cut, ", convexity = ", p.convexity, ')');
    }
    void operator()(const Hull&) const { out += "hull()"; }
    void operator()(const Minkowski& m) const { put(out, "minkowski(convexity = ", m.convexity, ')'); }
    void operator()(const Resize& r) const {
        put(out, "resize(newsize = [", r.size.x, ',', r.size.y, ',', r.size.z, "], auto = [", int{r.automatic[0]}, ',',
            int{r.automatic[1]}, ',', int{r.automatic[2]}, "], convexity = ", r.convexity, ')');
    }
    void operator()(const Render& r) const { put(out, "render(convexity = ", r.convexity, ')'); }
    void operator()(const Roof& r) const {
        put(out, "roof(method = ", Quoted{r.method}, ", ", r.fineness, ", convexity = ", r.convexity, ')');
    }
};

void put_one(std::string& out, const glm::dmat4& m) {
    out += "multmatrix([";
    for (int row = 0; row < 4; ++row) {
        put(out, row == 0 ? "[" : ", [", m[0][row], ", ", m[1][row], ", ", m[2][row], ", ", m[3][row], ']');
    }
    out += "])";
}

void put_one(std::string& out, const Rgba& c) {
    put(out, "color([", double{c.r}, ", ", double{c.g}, ", ", double{c.b}, ", ", double{c.a}, "])");
}

}  // namespace

void append_node_text(const Tree& tree, NodeId id, std::string& out) {
    switch (tree.node(id).operation) {
        case Operation::Group:
            out += "group()";
            return;
        case Operation::Union:
            out += "union()";
            return;
        case Operation::Difference:
            out += "difference()";
            return;
        case Operation::Intersection:
            out += "intersection()";
            return;
        case Operation::Transform:
            put_one(out, tree.matrix(id));
            return;
        case Operation::Color:
            put_one(out, tree.color(id));
            return;
        case Operation::Leaf:
            std::visit(LeafText{out}, tree.shape(id));
            return;
        case Operation::Mesh:
            std::visit(MeshText{out}, tree.mesh(id));
            return;
    }
}

}  // namespace csg::scad
