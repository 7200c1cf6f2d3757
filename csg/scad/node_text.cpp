#include "csg/scad/node_text.h"

#include <fmt/format.h>

#include "csg/scad/expression_writer.h"

namespace csg::scad {

namespace {

/// As C++ streams print it: six significant digits.
std::string number(double value) {
    return fmt::format("{:g}", value);
}

std::string vector(const glm::dvec3& v) {
    return fmt::format("[{:g}, {:g}, {:g}]", v.x, v.y, v.z);
}

std::string vector(const glm::dvec2& v) {
    return fmt::format("[{:g}, {:g}]", v.x, v.y);
}

std::string fineness(const Fineness& f) {
    return fmt::format("$fn = {:g}, $fa = {:g}, $fs = {:g}", f.fn, f.fa, f.fs);
}

struct LeafText {
    std::string operator()(const Cube& c) const {
        return fmt::format("cube(size = {}, center = {})", vector(c.size), c.center);
    }
    std::string operator()(const Sphere& s) const {
        return fmt::format("sphere({}, r = {})", fineness(s.fineness), number(s.radius));
    }
    std::string operator()(const Cylinder& c) const {
        return fmt::format("cylinder({}, h = {}, r1 = {}, r2 = {}, center = {})", fineness(c.fineness),
                           number(c.height), number(c.radius1), number(c.radius2), c.center);
    }
    std::string operator()(const std::shared_ptr<const Polyhedron>& p) const {
        std::string points, faces;
        for (const glm::dvec3& point : p->points) {
            points += (points.empty() ? "" : ", ") + vector(point);
        }
        for (const auto& face : p->faces) {
            faces += fmt::format("{}[{}]", faces.empty() ? "" : ", ", fmt::join(face, ", "));
        }
        return fmt::format("polyhedron(points = [{}], faces = [{}], convexity = {})", points, faces, p->convexity);
    }
    std::string operator()(const Square& s) const {
        return fmt::format("square(size = {}, center = {})", vector(s.size), s.center);
    }
    std::string operator()(const Circle& c) const {
        return fmt::format("circle({}, r = {})", fineness(c.fineness), number(c.radius));
    }
    std::string operator()(const std::shared_ptr<const Polygon>& p) const {
        std::string points, paths;
        for (const glm::dvec2& point : p->points) {
            points += (points.empty() ? "" : ", ") + vector(point);
        }
        for (const auto& path : p->paths) {
            paths += fmt::format("{}[{}]", paths.empty() ? "" : ", ", fmt::join(path, ", "));
        }
        paths = p->has_paths && !p->paths.empty() ? '[' + paths + ']' : "undef";
        return fmt::format("polygon(points = [{}], paths = {}, convexity = {})", points, paths, p->convexity);
    }
    std::string operator()(const std::shared_ptr<const Text>& t) const {
        return fmt::format(
            "text(text = {}, size = {:g}, spacing = {:g}, font = {}, direction = {}, language = {}{}, halign = {}, "
            "valign = {}, {})",
            quoted(t->text), t->size, t->spacing, quoted(t->font), quoted(t->direction), quoted(t->language),
            t->script.empty() ? "" : ", script = " + quoted(t->script), quoted(t->halign), quoted(t->valign),
            fineness(t->fineness));
    }
    std::string operator()(const std::shared_ptr<const Import>& i) const {
        std::string text = "import(file = " + quoted(i->file.shown);
        text += i->id.empty() ? "" : ", id = " + quoted(i->id);
        text += i->layer.empty() ? "" : ", layer = " + quoted(i->layer);
        text += fmt::format(", origin = {}, scale = {:g}, center = {}", vector(i->origin), i->scale, i->center);
        text += i->dpi == 72 ? "" : fmt::format(", dpi = {:g}", i->dpi);
        return text + fmt::format(", convexity = {}, {}, timestamp = {})", i->convexity, fineness(i->fineness),
                                  i->file.modified);
    }
    std::string operator()(const std::shared_ptr<const Surface>& s) const {
        return fmt::format("surface(file = {}, center = {}, invert = {}, timestamp = {})", quoted(s->file.shown),
                           s->center, s->invert, s->file.modified);
    }
};

std::string convexity_if_not_1(unsigned convexity) {
    return convexity > 1 ? fmt::format(", convexity = {}", convexity) : std::string();
}

struct MeshText {
    std::string operator()(const LinearExtrude& e) const {
        std::string text = "linear_extrude(height = " + number(e.height);
        if (e.has_direction) {
            text += fmt::format(", v = [ {:g}, {:g}, {:g}]", e.direction.x, e.direction.y, e.direction.z);
        }
        text += e.center ? ", center = true" : "";
        text += e.twist ? ", twist = " + number(*e.twist) : "";
        text += e.slices ? fmt::format(", slices = {}", *e.slices) : "";
        text += e.segments ? fmt::format(", segments = {}", *e.segments) : "";
        if (e.scale != glm::dvec2(1.0)) {
            text += ", scale = " + (e.scale.x == e.scale.y ? number(e.scale.x) : vector(e.scale));
        }
        text += e.slices && e.segments ? "" : ", " + fineness(e.fineness);
        return text + convexity_if_not_1(e.convexity) + ')';
    }
    std::string operator()(const RotateExtrude& e) const {
        return fmt::format("rotate_extrude(angle = {:g}, start = {:g}, convexity = {}, {})", e.angle, e.start,
                           e.convexity, fineness(e.fineness));
    }
    std::string operator()(const Offset& o) const {
        const bool round = o.corner == Offset::Corner::Round;
        return fmt::format("offset({} = {:g}{}, {})", round ? "r" : "delta", o.distance,
                           round ? std::string() : fmt::format(", chamfer = {}", o.corner == Offset::Corner::Chamfer),
                           fineness(o.fineness));
    }
    std::string operator()(const Fill&) const { return "fill()"; }
    std::string operator()(const Projection& p) const {
        return fmt::format("projection(cut = {}, convexity = {})", p.cut, p.convexity);
    }
    std::string operator()(const Hull&) const { return "hull()"; }
    std::string operator()(const Minkowski& m) const { return fmt::format("minkowski(convexity = {})", m.convexity); }
    std::string operator()(const Resize& r) const {
        return fmt::format("resize(newsize = [{:g},{:g},{:g}], auto = [{:d},{:d},{:d}], convexity = {})", r.size.x,
                           r.size.y, r.size.z, r.automatic[0], r.automatic[1], r.automatic[2], r.convexity);
    }
    std::string operator()(const Render& r) const { return fmt::format("render(convexity = {})", r.convexity); }
    std::string operator()(const Roof& r) const {
        return fmt::format("roof(method = {}, {}, convexity = {})", quoted(r.method), fineness(r.fineness),
                           r.convexity);
    }
};

}  // namespace

std::string leaf_text(const LeafShape& shape) {
    return std::visit(LeafText{}, shape);
}

std::string mesh_text(const MeshOperation& operation) {
    return std::visit(MeshText{}, operation);
}

}  // namespace csg::scad
