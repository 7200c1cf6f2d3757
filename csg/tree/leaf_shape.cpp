#include "csg/tree/leaf_shape.h"

#include "csg/tree/hash.h"

namespace csg {
namespace {

std::uint64_t mix(std::uint64_t seed, const glm::dvec2& v) {
    return csg::mix(csg::mix(seed, v.x), v.y);
}

std::uint64_t mix(std::uint64_t seed, const FileStamp& f) {
    const std::uint64_t h = csg::mix(csg::mix(seed, std::string_view(f.path)), std::string_view(f.shown));
    return csg::mix(csg::mix(h, static_cast<std::uint64_t>(f.modified)), f.bytes);
}

std::uint64_t mix(std::uint64_t seed, const std::vector<std::vector<std::uint32_t>>& loops) {
    for (const auto& loop : loops) {
        seed = csg::mix(seed, std::uint64_t{loop.size()});
        for (const std::uint32_t index : loop) {
            seed = csg::mix(seed, std::uint64_t{index});
        }
    }
    return seed;
}

struct ShapeHasher {
    std::uint64_t seed;

    std::uint64_t operator()(const Cube& c) const { return csg::mix(csg::mix(seed, c.size), std::uint64_t{c.center}); }
    std::uint64_t operator()(const Sphere& s) const { return mix(csg::mix(seed, s.radius), s.fineness); }
    std::uint64_t operator()(const Cylinder& c) const {
        std::uint64_t h = csg::mix(csg::mix(csg::mix(seed, c.height), c.radius1), c.radius2);
        return mix(csg::mix(h, std::uint64_t{c.center}), c.fineness);
    }
    std::uint64_t operator()(const std::shared_ptr<const Polyhedron>& p) const {
        std::uint64_t h = csg::mix(seed, std::uint64_t{p->points.size()});
        for (const glm::dvec3& point : p->points) {
            h = csg::mix(h, point);
        }
        return csg::mix(mix(h, p->faces), std::uint64_t{p->convexity});
    }
    std::uint64_t operator()(const Square& s) const { return csg::mix(mix(seed, s.size), std::uint64_t{s.center}); }
    std::uint64_t operator()(const Circle& c) const { return mix(csg::mix(seed, c.radius), c.fineness); }
    std::uint64_t operator()(const std::shared_ptr<const Polygon>& p) const {
        std::uint64_t h = csg::mix(seed, std::uint64_t{p->points.size()} << 1 | std::uint64_t{p->has_paths});
        for (const glm::dvec2& point : p->points) {
            h = mix(h, point);
        }
        return csg::mix(mix(h, p->paths), std::uint64_t{p->convexity});
    }
    std::uint64_t operator()(const std::shared_ptr<const Text>& t) const {
        std::uint64_t h = csg::mix(csg::mix(seed, t->size), t->spacing);
        for (const std::string* s :
             {&t->text, &t->font, &t->direction, &t->language, &t->script, &t->halign, &t->valign}) {
            h = csg::mix(h, std::string_view(*s));
        }
        for (const std::string& file : t->font_files) {
            h = csg::mix(h, std::string_view(file));
        }
        return mix(h, t->fineness);
    }
    std::uint64_t operator()(const std::shared_ptr<const Import>& i) const {
        std::uint64_t h = mix(mix(seed, i->file), i->origin);
        h = csg::mix(csg::mix(h, std::string_view(i->layer)), std::string_view(i->id));
        h = csg::mix(csg::mix(h, i->scale), i->dpi);
        return mix(csg::mix(h, std::uint64_t{i->convexity} << 1 | std::uint64_t{i->center}), i->fineness);
    }
    std::uint64_t operator()(const std::shared_ptr<const Surface>& s) const {
        return csg::mix(mix(seed, s->file), std::uint64_t{s->center} | std::uint64_t{s->invert} << 1);
    }
};

template <typename T>
bool same(const T& a, const T& b) {
    return a == b;
}
template <typename T>
bool same(const std::shared_ptr<T>& a, const std::shared_ptr<T>& b) {
    return a == b || *a == *b;
}

bool is_outline_file(std::string_view name) {
    if (name.size() < 4) {
        return false;
    }
    std::string end(name.substr(name.size() - 4));
    for (char& c : end) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return end == ".dxf" || end == ".svg";
}

}  // namespace

bool is_flat(const LeafShape& shape) {
    if (const auto* file = std::get_if<std::shared_ptr<const Import>>(&shape)) {
        return is_outline_file((*file)->file.path);
    }
    return std::holds_alternative<Square>(shape) || std::holds_alternative<Circle>(shape) ||
           std::holds_alternative<std::shared_ptr<const Polygon>>(shape) ||
           std::holds_alternative<std::shared_ptr<const Text>>(shape);
}

std::uint64_t mix(std::uint64_t seed, const Fineness& f) {
    return mix(mix(mix(mix(seed, f.fn), f.fa), f.fs), f.fe.value_or(0));
}

std::uint64_t content_hash(const LeafShape& shape) {
    return std::visit(ShapeHasher{csg::mix(std::uint64_t{0x1eaf}, std::uint64_t{shape.index()})}, shape);
}

bool same_shape(const LeafShape& a, const LeafShape& b) {
    return a.index() == b.index() &&
           std::visit([&b](const auto& shape) { return same(shape, std::get<std::decay_t<decltype(shape)>>(b)); }, a);
}

}  // namespace csg
