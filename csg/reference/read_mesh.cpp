#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "csg/reference/mesh_files.h"
#include "csg/reference/point_ids.h"

namespace csg::reference {
namespace {

constexpr std::size_t kMostTriangles = std::size_t{1} << 26;

/// Words separated by white space; the text need not end in zero.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) {}

    std::string_view next() {
        while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') {
            ++at_;
        }
        const std::size_t from = at_;
        while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ') {
            ++at_;
        }
        return text_.substr(from, at_ - from);
    }

    double number() {
        const std::string_view word = next();
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) {
            throw std::runtime_error("a number was expected, not \"" + std::string(word.substr(0, 40)) + "\"");
        }
        return value;
    }

    std::size_t count(std::size_t most) {
        const double value = number();
        if (value < 0 || value != std::floor(value) || value > static_cast<double>(most)) {
            throw std::runtime_error("a count or an index is out of bounds");
        }
        return static_cast<std::size_t>(value);
    }

    void end_line() {
        while (at_ < text_.size() && text_[at_] != '\n') {
            ++at_;
        }
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

class Joiner {
  public:
    std::uint32_t add(const glm::dvec3& p) {
        const auto [id, added] = ids_.add(p);
        if (added) {
            mesh.points.push_back(p);
        }
        return id;
    }
    void triangle(const glm::uvec3& t) {
        if (t.x == t.y || t.y == t.z || t.z == t.x) {
            return;
        }
        mesh.triangles.push_back(t);
        mesh.sources.push_back(0);
    }
    Mesh mesh;

  private:
    PointIds ids_;
};

Mesh binary_stl(std::string_view bytes, std::size_t count) {
    Joiner joiner;
    for (std::size_t i = 0; i < count; ++i) {
        float values[12];
        std::memcpy(values, bytes.data() + 84 + 50 * i, sizeof values);
        glm::uvec3 t;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p(values[3 + 3 * k], values[4 + 3 * k], values[5 + 3 * k]);
            if (!std::isfinite(p.x + p.y + p.z)) {
                throw std::runtime_error("a point is not finite");
            }
            t[k] = joiner.add(p);
        }
        joiner.triangle(t);
    }
    return std::move(joiner.mesh);
}

Mesh ascii_stl(std::string_view text) {
    Words words(text);
    Joiner joiner;
    std::vector<std::uint32_t> loop;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (word == "vertex") {
            const double x = words.number(), y = words.number(), z = words.number();
            loop.push_back(joiner.add({x, y, z}));
        } else if (word == "endloop") {
            if (loop.size() != 3) {
                throw std::runtime_error("a facet does not have three vertices");
            }
            joiner.triangle({loop[0], loop[1], loop[2]});
            loop.clear();
        }
    }
    if (!loop.empty() || joiner.mesh.triangles.empty()) {
        throw std::runtime_error("the STL file ends early or has no facets");
    }
    return std::move(joiner.mesh);
}

Mesh off(std::string_view text) {
    Words words(text);
    (void)words.next();
    const std::size_t points = words.count(kMostTriangles), faces = words.count(kMostTriangles);
    (void)words.count(kMostTriangles * 3);
    Joiner joiner;
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < points; ++i) {
        const double x = words.number(), y = words.number(), z = words.number();
        ids.push_back(joiner.add({x, y, z}));
    }
    for (std::size_t i = 0; i < faces; ++i) {
        const std::size_t corners = words.count(1 << 20);
        std::vector<std::uint32_t> face;
        for (std::size_t k = 0; k < corners; ++k) {
            const std::size_t id = words.count(kMostTriangles);
            if (id >= ids.size()) {
                throw std::runtime_error("a face has a point that is not there");
            }
            face.push_back(ids[id]);
        }
        words.end_line();  // a color may follow
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            joiner.triangle({face[0], face[k], face[k + 1]});
        }
    }
    return std::move(joiner.mesh);
}

}  // namespace

Mesh decode_mesh(std::string_view bytes) {
    if (bytes.size() >= 84) {
        std::uint32_t count = 0;
        std::memcpy(&count, bytes.data() + 80, 4);
        if (bytes.size() == 84 + std::size_t{50} * count) {
            return binary_stl(bytes, count);
        }
    }
    if (bytes.starts_with("OFF")) {
        return off(bytes);
    }
    if (bytes.starts_with("solid")) {
        return ascii_stl(bytes);
    }
    throw std::runtime_error("neither an STL nor an OFF file");
}

}  // namespace csg::reference
