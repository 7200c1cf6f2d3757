#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/film_writer.h"
#include "base/stop.h"

namespace base {
namespace {

struct EndEncoder {
    void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};

void need(bool done) {
    if (!done) {
        throw std::runtime_error("WebP: the film cannot be made");
    }
}

class WebpWriter final : public FilmWriter {
  public:
    WebpWriter(WriteBytes write, int frames, double frames_per_second)
        : write_(std::move(write)), frames_(frames), frames_per_second_(frames_per_second) {}

    void add(const Image& frame, const std::stop_token& stop, double) override {
        if (added_ == frames_ || (added_ > 0 && (frame.width != width_ || frame.height != height_))) {
            throw std::runtime_error("WebP: frames of one size, and no more than were told, make a film");
        }
        end_if_asked(stop);
        if (added_ == 0) {
            open(frame);
        }
        WebPConfig config;
        need(WebPConfigInit(&config) != 0);
        config.lossless = 1;
        config.exact = 1;  // Colors of what is seen through stay.
        constexpr float kEffort = 50;
        config.quality = kEffort;
        WebPPicture picture;
        need(WebPPictureInit(&picture) != 0);
        picture.use_argb = 1;
        picture.width = width_;
        picture.height = height_;
        const bool done = WebPPictureImportRGBA(&picture, frame.rgba.data(), 4 * width_) != 0 &&
                          WebPAnimEncoderAdd(encoder_.get(), &picture, time(added_), &config) != 0;
        WebPPictureFree(&picture);
        need(done);
        ++added_;
    }

    void finish() override {
        if (added_ != frames_) {
            throw std::runtime_error("WebP: frames are missing");
        }
        need(WebPAnimEncoderAdd(encoder_.get(), nullptr, time(added_), nullptr) != 0);
        WebPData data;
        WebPDataInit(&data);
        const bool done = WebPAnimEncoderAssemble(encoder_.get(), &data) != 0;
        const std::string bytes(done ? reinterpret_cast<const char*>(data.bytes) : "", done ? data.size : 0);
        WebPDataClear(&data);
        need(done);
        write_(bytes);
    }

  private:
    void open(const Image& first) {
        if (first.width > WEBP_MAX_DIMENSION || first.height > WEBP_MAX_DIMENSION) {
            throw std::runtime_error("WebP: a film is at most 16383 pixels wide and high");
        }
        width_ = first.width;
        height_ = first.height;
        WebPAnimEncoderOptions options;
        need(WebPAnimEncoderOptionsInit(&options) != 0);
        options.anim_params.loop_count = 0;  // Again and again.
        encoder_.reset(WebPAnimEncoderNew(width_, height_, &options));
        need(encoder_ != nullptr);
    }
    /// Milliseconds.
    [[nodiscard]] int time(int frame) const {
        constexpr double kThousandths = 1000;
        return static_cast<int>(std::lround(kThousandths * frame / frames_per_second_));
    }

    WriteBytes write_;
    int frames_;
    double frames_per_second_;
    int added_ = 0, width_ = 0, height_ = 0;
    std::unique_ptr<WebPAnimEncoder, EndEncoder> encoder_;
};

}  // namespace

std::unique_ptr<FilmWriter> webp_writer(WriteBytes write, int frames, double frames_per_second) {
    return std::make_unique<WebpWriter>(std::move(write), frames, frames_per_second);
}

}  // namespace base
