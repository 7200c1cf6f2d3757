#include "npr/edges/edge_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/stop.h"
#include "layers/limits.h"

namespace npr {
namespace {

constexpr int kEdgeTile = shader::LineCode().kEdgeTile;

constexpr std::size_t candidate_bytes(std::uint32_t room) {
    return 8 * (static_cast<std::size_t>(room) + 1);
}

std::uint32_t read_count(const gl::Functions& gl, const gl::Buffer& list) {
    std::uint32_t count = 0;
    gl.GetNamedBufferSubData(list.id(), 0, sizeof count, &count);
    return count;
}

}  // namespace

gl::Texture make_edge_tiles(const gl::Functions& gl, glm::ivec2 size) {
    return gl::Texture::make_2d(gl, GL_R32UI, (size + kEdgeTile - 1) / kEdgeTile);
}

EdgeMap::EdgeMap(const gl::Functions& gl)
    : gl_(gl),
      find_links_(gl, {"npr/edges/edge_links.comp"}),
      find_candidates_(gl, {"npr/edges/edge_candidates.comp"}),
      find_edges_(gl, {"npr/edges/edge_map.comp"}),
      links_(gl),
      candidates_(gl) {
    candidates_.reserve(candidate_bytes(room_), GL_DYNAMIC_COPY);
}

void EdgeMap::resize(glm::ivec2 size, int layers) {
    const int slices = 2 * std::min(layers, layers::kLayersApart);
    if (!marks_ || marks_.size() != size) {
        marks_ = gl::Texture::make_2d(gl_, GL_R32UI, size);
        tiles_ = make_edge_tiles(gl_, size);
        const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
        links_.reserve(4 * (1 + 2 * pixels), GL_DYNAMIC_COPY);
    }
    if (!points_ || points_.size() != size || points_.layers() < slices) {
        points_ = gl::Texture::make_2d_array(gl_, GL_R32UI, size, slices);
    }
}

std::uint32_t EdgeMap::list_links(const Frame& frame) {
    const std::uint32_t zero = 0;
    gl_.NamedBufferSubData(links_.id(), 0, sizeof zero, &zero);
    links_.bind(GL_SHADER_STORAGE_BUFFER, 2);
    find_links_.use(frame);
    gl_.DispatchCompute(groups(static_cast<std::uint32_t>(frame.layers.size.x)),
                        static_cast<GLuint>(frame.layers.size.y), 1);
    gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    return read_count(gl_, links_);
}

std::uint32_t EdgeMap::list_candidates(const Frame& frame, std::uint32_t links) {
    const std::array<std::uint32_t, 2> head{0, room_};
    gl_.NamedBufferSubData(candidates_.id(), 0, sizeof head, head.data());
    candidates_.bind(GL_SHADER_STORAGE_BUFFER, 3);
    gl_.BindImageTexture(0, points_.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32UI);
    find_candidates_.use(frame);
    gl_.DispatchCompute(groups(links), 1, 1);
    gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    return read_count(gl_, candidates_);
}

void EdgeMap::draw(const Frame& frame, const EdgeSettings& settings) {
    resize(frame.layers.size, frame.layers.layers);
    jitter_ = glm::vec2(frame.view.jitter());
    for (const FrameProgram* search : {&find_links_, &find_candidates_}) {
        search->program().set("part_edges", settings.parts);
        search->program().set("visible_only", settings.visible_only);
    }
    find_candidates_.program().set("crease_angle", glm::radians(settings.crease_degrees));
    base::end_if_asked(frame.stop);
    link_count_ = list_links(frame);
    base::end_if_asked(frame.stop);
    std::uint32_t count = link_count_ > 0 ? list_candidates(frame, link_count_) : 0;
    if (count > room_) {
        room_ = count + count / 4;
        candidates_.reserve(candidate_bytes(room_), GL_DYNAMIC_COPY);
        count = list_candidates(frame, link_count_);
    }
    const std::uint32_t zero = 0;
    gl_.ClearTexImage(marks_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    gl_.ClearTexImage(tiles_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    if (count > 0) {
        find_edges_.program().set("crease_angle", glm::radians(settings.crease_degrees));
        find_edges_.program().set("part_edges", settings.parts);
        find_edges_.program().set("follow_borders", settings.follow_borders);
        gl_.BindImageTexture(0, points_.id(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_R32UI);
        gl_.BindImageTexture(1, marks_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
        gl_.BindImageTexture(2, tiles_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
        find_edges_.use(frame);
        gl_.DispatchCompute(groups(count), 1, 1);
        gl_.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    has_facts_ = settings.facts;
    if (has_facts_) {
        find_facts(frame, settings, count);
    }
    bind();
}

void EdgeMap::find_facts(const Frame& frame, const EdgeSettings& settings, std::uint32_t candidates) {
    if (!facts_ || facts_.size() != points_.size() || facts_.layers() != 2 * points_.layers()) {
        facts_ = gl::Texture::make_2d_array(gl_, GL_R32UI, points_.size(), 2 * points_.layers());
    }
    if (!find_facts_) {
        find_facts_.emplace(gl_, std::initializer_list<std::string_view>{"npr/edges/edge_facts.comp"});
    }
    if (candidates == 0) {
        return;
    }
    find_facts_->program().set("crease_angle", glm::radians(settings.crease_degrees));
    find_facts_->program().set("part_edges", settings.parts);
    find_facts_->program().set("follow_borders", settings.follow_borders);
    find_facts_->program().set("clearances", settings.clearances);
    for (const bool clearing : {true, false}) {
        gl_.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        gl_.BindImageTexture(0, points_.id(), 0, GL_TRUE, 0, GL_READ_ONLY, GL_R32UI);
        gl_.BindImageTexture(1, facts_.id(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_R32UI);
        find_facts_->program().set("clearing", clearing);
        find_facts_->use(frame);
        gl_.DispatchCompute(groups(candidates), 1, 1);
    }
    gl_.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

std::vector<HostEdge> EdgeMap::read_back() const {
    const glm::ivec2 size = marks_.size();
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const auto read = [&](const gl::Texture& texture, std::size_t count) {
        std::vector<std::uint32_t> texels(count);
        gl_.GetTextureImage(texture.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, static_cast<GLsizei>(4 * count),
                            texels.data());
        return texels;
    };
    const std::vector<std::uint32_t> marks = read(marks_, pixels);
    const std::vector<std::uint32_t> points = read(points_, pixels * static_cast<std::size_t>(points_.layers()));
    const std::vector<std::uint32_t> facts =
        has_facts_ ? read(facts_, pixels * static_cast<std::size_t>(facts_.layers())) : std::vector<std::uint32_t>();
    shader::LineCode code;
    std::vector<HostEdge> edges;
    for (int slice = 0; slice < points_.layers(); ++slice) {
        for (std::size_t i = 0; i < pixels; ++i) {
            const int axis = slice % 2, layer = slice / 2;
            if ((marks[i] >> (layer + layers::kLayersApart * axis) & 1U) == 0) {
                continue;
            }
            const auto e = code.unpack_edge(points[pixels * static_cast<std::size_t>(slice) + i]);
            const std::size_t words = 2 * pixels * static_cast<std::size_t>(slice) + i;
            const std::size_t row = i / static_cast<std::size_t>(size.x);
            const glm::vec2 lower(static_cast<float>(i % static_cast<std::size_t>(size.x)), static_cast<float>(row));
            edges.push_back({lower + 0.5F + jitter_ + (axis == 0 ? glm::vec2(e.at, 0) : glm::vec2(0, e.at)), e.across,
                             layer, e.kind == code.kProfileEdge,
                             has_facts_ ? code.unpack_facts({facts[words], facts[words + pixels]}) : code.no_facts()});
        }
    }
    return edges;
}

void EdgeMap::bind() const {
    links_.bind(GL_SHADER_STORAGE_BUFFER, 2);
    marks_.bind(2);
    tiles_.bind(3);
    points_.bind(4);
    if (has_facts_) {
        facts_.bind(8);
    }
}

}  // namespace npr
