#include "goldfeather/lists/list_resolver.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/stop.h"
#include "gl/error.h"
#include "goldfeather/goldfeather_shaders.h"

namespace goldfeather {

void ListBuffers::bind() const {
    GLuint binding = 2;
    for (const gl::Buffer* buffer : {&pixels, &entries, &jobs, &status}) {
        buffer->bind(GL_SHADER_STORAGE_BUFFER, binding++);
    }
}

gl::ShaderLibrary ListResolver::shaders() {
    gl::ShaderLibrary library;
    library.add(gl::shader_files());
    library.add(layers::shader_files());
    library.add(goldfeather::shader_files());
    return library;
}

ListResolver::ListResolver(const gl::Functions& gl, gl::ShaderLibrary library)
    : gl_(gl), library_(std::move(library)), programs_(make_programs(false)), most_work_(loop_limit()) {}

ListResolver::Programs ListResolver::make_programs(bool windings) const {
    const std::pair<std::string, std::string> counts{"kWindings", windings ? "true" : "false"};
    const auto short_lists = [&](std::uint32_t capacity) {
        return gl::Program(gl_, library_, {"goldfeather/lists/resolve_short_lists.comp"},
                           {{"kCapacity", std::to_string(capacity)}, counts});
    };
    return {short_lists(kShortLists[0]), short_lists(kShortLists[1]),
            gl::Program(gl_, library_, {"goldfeather/lists/resolve_long_lists.comp"}, {counts})};
}

const ListResolver::Programs& ListResolver::programs(bool windings) {
    if (windings && !counting_) {
        counting_ = make_programs(true);
    }
    return windings ? *counting_ : programs_;
}

/// llvmpipe ends loops after 65535 iterations in all, counted over the invocations that it runs in one vector, of which
/// there are at most 16.
std::uint32_t ListResolver::loop_limit() const {
    constexpr std::uint32_t kEnough = 1U << 20, kWidestVector = 16;
    const gl::Program probe(gl_, library_, {"goldfeather/lists/loop_limit.comp"});
    gl::Buffer result(gl_);
    std::uint32_t done = 0;
    result.upload_bytes(&done, sizeof done, GL_STREAM_READ);
    result.bind(GL_SHADER_STORAGE_BUFFER, 2);
    probe.set("wanted", kEnough);
    probe.use();
    gl_.DispatchCompute(1, 1, 1);
    gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl_.GetNamedBufferSubData(result.id(), 0, sizeof done, &done);
    return done == kEnough ? ~0U : done / kWidestVector;
}

ListStatus ListResolver::status(const ListBuffers& buffers) const {
    ListStatus status;
    gl_.GetNamedBufferSubData(buffers.status.id(), 0, sizeof status, &status);
    return status;
}

ListStatus ListResolver::resolve(const ListBuffers& buffers, const BlistBuffer& blist, const ListTarget& target,
                                 const std::array<std::uint32_t, kListClasses>& class_sizes, std::uint32_t class_stride,
                                 const std::stop_token& stop) {
    constexpr std::uint32_t kGroup = 64, kMostGroups = 32768;  // Every OpenGL 4.5 takes 65535 a dimension.
    constexpr std::uint32_t kPieceJobs = 1U << 14;             // At once, where it may have to stop in between.
    const std::uint32_t pause_after = target.pause_after != 0 ? target.pause_after
                                      : most_work_ == ~0U     ? ~0U
                                                              : most_work_ / 8;
    ListStatus after;
    gl_.BindImageTexture(0, target.stack.depth.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R32F);
    gl_.BindImageTexture(1, target.stack.surface.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RG32UI);
    for (std::size_t c = 0; c < kListClasses; ++c) {
        if (class_sizes[c] == 0) {
            continue;
        }
        const gl::Program& program = programs(target.windings)[c];
        blist.bind(program);
        program.set("band_size", target.band_size);
        program.set("first_row", target.first_row);
        program.set("layer_limit", target.layer_limit);
        program.set("layer_capacity", static_cast<unsigned>(target.stack.layers));
        program.set("count_inside", target.count_inside);
        program.set("pause_after", pause_after);
        program.set("most_work", most_work_);
        program.use();
        const std::uint32_t piece = stop.stop_possible() ? kPieceJobs : class_sizes[c];
        for (std::uint32_t first = 0; first < class_sizes[c]; first += piece) {
            base::end_if_asked(stop);
            const std::uint32_t jobs = std::min(piece, class_sizes[c] - first);
            program.set("first_job", static_cast<unsigned>(c) * class_stride + first);
            program.set("job_count", jobs);
            const std::uint32_t groups = (jobs + kGroup - 1) / kGroup;
            for (bool going_on = false;; going_on = true) {
                program.set("going_on", going_on);
                gl_.DispatchCompute(std::min(groups, kMostGroups), (groups + kMostGroups - 1) / kMostGroups, 1);
                gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                                  GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                                  GL_TEXTURE_UPDATE_BARRIER_BIT);
                if (pause_after == ~0U) {
                    break;
                }
                after = status(buffers);
                if (after.unfinished == 0 || after.overlong != 0) {
                    break;
                }
                base::end_if_asked(stop);
                after.unfinished = 0;
                gl_.NamedBufferSubData(buffers.status.id(), 0, sizeof after, &after);
            }
            if (stop.stop_possible()) {
                gl_.Finish();
            }
        }
    }
    after = status(buffers);
    if (after.faults != 0) {
        throw gl::Error("two passes over the same triangles gave different per-pixel lists");
    }
    if (after.overlong != 0) {
        throw gl::Error(fmt::format("{} per-pixel lists need longer loops than this OpenGL runs", after.overlong));
    }
    return after;
}

}  // namespace goldfeather
