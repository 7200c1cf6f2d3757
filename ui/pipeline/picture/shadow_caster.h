// Which surfaces of a picture lie in the shadow of a part: by rays toward the light through the expressions of the
// parts, in double precision, so that both painters have the same shadows and no mesh or map of depths is between.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "layers/host_stack.h"
#include "npr/cast_shadows.h"
#include "ui/pipeline/model.h"

namespace ui {

class ShadowCaster {
  public:
    /// The model must outlive it.
    explicit ShadowCaster(const Model& model);
    ~ShadowCaster();
    ShadowCaster(const ShadowCaster&) = delete;
    ShadowCaster& operator=(const ShadowCaster&) = delete;

    /// By pixel of the model's layers from that view. Solid parts cast shadows; light passes `%`, `#` and what is seen
    /// through, which lie in shadows themselves. What lies behind a solid surface, and faces that are turned from the
    /// light or from the eye, have no bit. Throws base::Stopped where `stop` asks for it.
    [[nodiscard]] std::vector<npr::ShadowBits> shadows(const base::View& view, const layers::HostStack& layers,
                                                       const std::stop_token& stop = {}) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The last such.
class ShadowCasters {
  public:
    /// Stands until the next call.
    [[nodiscard]] const ShadowCaster& of(const Model& model);
    /// The model has been edited in place.
    void forget() { caster_.reset(); }

  private:
    std::unique_ptr<ShadowCaster> caster_;
    const Model* model_ = nullptr;  ///< Its own; only compared.
    std::uint64_t generation_ = 0;
};

}  // namespace ui
