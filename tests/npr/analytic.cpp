#include "tests/npr/analytic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace analytic {
namespace {

using comparison::Subject;

glm::dvec4 color_of(const Subject& subject, const npr::Picture& picture, const truth::Surface& s) {
    const csg::LeafInstance& leaf = subject.scene.leaves[s.leaves.front()];
    const csg::Part& part = subject.scene.parts[leaf.part];
    if (part.kind == csg::PartKind::Highlight) {
        return picture.scheme.highlight;
    }
    const bool translucent = part.kind == csg::PartKind::Translucent;
    const csg::Rgba& c = translucent ? part.color : leaf.color;
    const glm::dvec3 given(c.r, c.g, c.b);
    glm::dvec4 color(s.reversed.empty() || translucent ? picture.scheme.face : picture.scheme.cut,
                     translucent ? c.a : 1);
    if (part.kind == csg::PartKind::Background) {
        const bool all_of_it = c.r < 0 && c.g < 0 && c.b < 0 && !c.translucent();
        color = glm::dvec4(glm::dvec3(picture.scheme.ghost), all_of_it ? picture.scheme.ghost.a : c.a < 0 ? 1 : c.a);
    }
    for (int i = 0; i < 3; ++i) {
        color[i] = given[i] >= 0 ? given[i] : color[i];
    }
    return color;
}

/// Two lights fixed to the eye, and ambient light.
double light_on(const Subject& subject, const base::View& view, const truth::Surface& s) {
    const glm::dvec3 normal = subject.geometry.planes.planes()[s.planes.front()].normal;
    return 0.2 + std::abs(glm::dot(glm::dmat3(view.eye_from_world()) * normal, glm::dvec3(-1, 1, 1) / std::sqrt(3.0)));
}

struct Seen {
    glm::dvec3 color{0};
    double through = 1;

    void add(const glm::dvec3& c, double opacity) {
        color += through * opacity * c;
        through *= 1 - opacity;
    }
};

csg::PartKind kind_of(const Subject& subject, const truth::Surface& s) {
    return subject.scene.parts[subject.scene.leaves[s.leaves.front()].part].kind;
}

/// Of faces in one place one is seen: the most opaque, then that of the larger color, and `%` only where it is alone.
/// Highlights are among themselves.
bool is_another_seen(const Subject& subject, const npr::Picture& picture, const truth::Ray& ray, std::size_t i) {
    const auto rank = [&](const truth::Surface& s) {
        const glm::dvec4 c = color_of(subject, picture, s);
        return std::array{kind_of(subject, s) == csg::PartKind::Background ? 0.0 : 1.0, c.a, c.r, c.g, c.b};
    };
    const auto marked = [&](const truth::Surface& s) { return kind_of(subject, s) == csg::PartKind::Highlight; };
    const truth::Surface& s = ray.surfaces[i];
    for (std::size_t j = 0; j < ray.surfaces.size(); ++j) {
        const truth::Surface& t = ray.surfaces[j];
        if (j != i && t.planes == s.planes && t.leaving == s.leaving && marked(t) == marked(s) &&
            (rank(t) > rank(s) || (rank(t) == rank(s) && j < i))) {
            return true;
        }
    }
    return false;
}

void add_surface(Seen& seen, const Subject& subject, const npr::Picture& picture, const base::View& view,
                 const truth::Ray& ray, std::size_t i) {
    const truth::Surface& s = ray.surfaces[i];
    const glm::dvec4 color = color_of(subject, picture, s);
    if (color.a < 1 && (s.leaving || is_another_seen(subject, picture, ray, i))) {
        return;
    }
    seen.add(glm::min(glm::dvec3(color) * light_on(subject, view, s), 1.0), color.a);
}

glm::dvec3 exact(const Subject& subject, const npr::Picture& picture, const base::View& view, const truth::Ray& ray) {
    Seen seen;
    for (std::size_t i = 0; i < ray.surfaces.size(); ++i) {
        add_surface(seen, subject, picture, view, ray, i);
    }
    return seen.color + seen.through * glm::dvec3(picture.scheme.background);
}

/// Attenuation and albedo of a part; attenuation below 0: it is no medium.
glm::dvec4 medium(const Subject& subject, const npr::Picture& picture, csg::PartId id) {
    const csg::Part& part = subject.scene.parts[id];
    for (const npr::PartMedium& m : picture.media) {
        if (m.part == part.name) {
            return {*m.albedo, *m.attenuation};
        }
    }
    if (part.kind != csg::PartKind::Translucent) {
        return {0, 0, 0, -1};
    }
    const double thickness = 0.1 * glm::length(subject.geometry.box.hi - subject.geometry.box.lo);
    return {part.color.r, part.color.g, part.color.b, -std::log(1.0 - part.color.a) / thickness};
}

glm::dvec3 volume(const Subject& subject, const npr::Picture& picture, const base::View& view, const truth::Ray& ray,
                  const base::View::Ray& line) {
    const auto part_of = [&](const truth::Surface& s) { return subject.scene.leaves[s.leaves.front()].part; };
    std::set<csg::PartId> inside, known;
    for (const truth::Surface& s : ray.surfaces) {
        if (known.insert(part_of(s)).second && s.leaving) {
            inside.insert(part_of(s));
        }
    }
    const glm::dvec3 toward = glm::dmat3(view.eye_from_world()) * glm::normalize(line.direction);
    const double facing = glm::dot(toward, glm::dvec3(-1, 1, 1) / std::sqrt(3.0));
    const double light = picture.medium_light.ambient + picture.medium_light.directional * 0.75 * (1 + facing * facing);
    Seen seen;
    double at = view.orthographic() ? view.near_distance() : 0;
    for (std::size_t i = 0; i < ray.surfaces.size(); ++i) {
        const truth::Surface& s = ray.surfaces[i];
        double attenuation = 0;
        glm::dvec3 scattered(0);
        for (const csg::PartId part : inside) {
            const glm::dvec4 m = medium(subject, picture, part);
            attenuation += std::max(m.w, 0.0);
            scattered += std::max(m.w, 0.0) * glm::dvec3(m);
        }
        if (attenuation > 0) {
            const double length = (s.distance - at) * glm::length(line.direction);
            seen.add(glm::min(scattered / attenuation * light, 1.0), 1 - std::exp(-attenuation * length));
        }
        at = s.distance;
        s.leaving ? (void)inside.erase(part_of(s)) : (void)inside.insert(part_of(s));
        if (medium(subject, picture, part_of(s)).w < 0) {
            add_surface(seen, subject, picture, view, ray, i);
        }
    }
    return seen.color + seen.through * glm::dvec3(picture.scheme.background);
}

}  // namespace

Truth truth_of(const Subject& subject, const npr::Picture& picture) {
    const base::View view = subject.view(picture.camera, picture.size);
    const truth::RayCaster caster(subject.scene, subject.geometry, view);
    Truth result{picture.size, {}, {}};
    for (int y = picture.size.y - 1; y >= 0; --y) {
        for (int x = 0; x < picture.size.x; ++x) {
            const truth::Ray ray = caster.cast(x, y);
            const bool one_leaf = std::all_of(ray.surfaces.begin(), ray.surfaces.end(),
                                              [](const truth::Surface& s) { return s.leaves.size() == 1; });
            result.compared.push_back(ray.hit && ray.decided && one_leaf ? 1 : 0);
            const bool all_named = std::none_of(ray.surfaces.begin(), ray.surfaces.end(),
                                                [](const truth::Surface& s) { return s.leaves.empty(); });
            result.colors.push_back(!all_named ? glm::dvec3(picture.scheme.background)
                                    : picture.transparency == npr::Transparency::Volume
                                        ? volume(subject, picture, view, ray, view.ray(x, y))
                                        : exact(subject, picture, view, ray));
        }
    }
    return result;
}

Error error_of(const Truth& truth, const base::Image& image) {
    Error error;
    for (std::size_t i = 0; i < truth.colors.size(); ++i) {
        if (truth.compared[i] == 0) {
            continue;
        }
        const glm::ivec2 at(static_cast<int>(i) % truth.size.x, static_cast<int>(i) / truth.size.x);
        const std::uint8_t* pixel = image.pixel(at.x, at.y);
        for (int c = 0; c < 3; ++c) {
            const double off = pixel[c] - 255 * truth.colors[i][c];
            error.rms += off * off;
            if (std::abs(off) > error.most) {
                error.most = std::abs(off);
                error.worst = at;
            }
        }
        ++error.pixels;
    }
    error.rms = error.pixels > 0 ? std::sqrt(error.rms / (3.0 * static_cast<double>(error.pixels))) : 0;
    return error;
}

Error error_of(const Subject& subject, const npr::Picture& picture, const base::Image& image) {
    return error_of(truth_of(subject, picture), image);
}

}  // namespace analytic
