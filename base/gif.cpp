#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/film_writer.h"
#include "base/stop.h"

namespace base {
namespace {

constexpr std::size_t kColors = 256;
using Pixel = std::array<std::uint8_t, 3>;

std::uint32_t number_of(const std::uint8_t* rgb) {
    return std::uint32_t{rgb[0]} << 16 | std::uint32_t{rgb[1]} << 8 | rgb[2];
}

/// At most so many colors for the pixels of a frame.
class Palette {
  public:
    /// `pixels`: in any order, as often as they are there.
    Palette(std::vector<std::uint32_t> pixels, std::size_t most) {
        std::sort(pixels.begin(), pixels.end());
        for (std::size_t i = 0; i < pixels.size();) {
            const auto end = static_cast<std::size_t>(
                std::upper_bound(pixels.begin() + static_cast<std::ptrdiff_t>(i), pixels.end(), pixels[i]) -
                pixels.begin());
            known_.push_back({pixels[i], static_cast<double>(end - i), 0});
            i = end;
        }
        divide(most);
        std::sort(known_.begin(), known_.end(), [](const Known& a, const Known& b) { return a.color < b.color; });
    }

    [[nodiscard]] std::uint8_t index(std::uint32_t color) const {
        const auto at = std::lower_bound(known_.begin(), known_.end(), color,
                                         [](const Known& k, std::uint32_t c) { return k.color < c; });
        return at->index;
    }
    [[nodiscard]] const std::vector<Pixel>& colors() const { return colors_; }

  private:
    struct Known {
        std::uint32_t color;
        double count;
        std::uint8_t index;
    };
    static double channel(std::uint32_t color, int c) { return static_cast<double>(color >> (16 - 8 * c) & 255U); }

    /// A range of the colors, and along which channel they are most apart.
    struct Range {
        std::size_t begin, end;
        int along = 0;
        double spread = 0;
    };
    [[nodiscard]] Range range(std::size_t begin, std::size_t end) const {
        Range r{begin, end};
        for (int c = 0; c < 3; ++c) {
            double count = 0, sum = 0, squares = 0;
            for (std::size_t i = begin; i < end; ++i) {
                const double v = channel(known_[i].color, c);
                count += known_[i].count;
                sum += known_[i].count * v;
                squares += known_[i].count * v * v;
            }
            if (const double spread = squares - sum * sum / count; spread > r.spread) {
                r.spread = spread;
                r.along = c;
            }
        }
        return r;
    }

    /// Halves the range in which colors are most apart, at their mean, again and again.
    void divide(std::size_t most) {
        std::vector<Range> ranges;
        if (!known_.empty()) {
            ranges.push_back(range(0, known_.size()));
        }
        while (ranges.size() < most) {
            const auto widest = std::max_element(ranges.begin(), ranges.end(),
                                                 [](const Range& a, const Range& b) { return a.spread < b.spread; });
            if (widest == ranges.end() || widest->end - widest->begin < 2) {
                break;
            }
            const Range r = *widest;
            double count = 0, sum = 0;
            for (std::size_t i = r.begin; i < r.end; ++i) {
                count += known_[i].count;
                sum += known_[i].count * channel(known_[i].color, r.along);
            }
            const auto begin = known_.begin() + static_cast<std::ptrdiff_t>(r.begin),
                       end = known_.begin() + static_cast<std::ptrdiff_t>(r.end);
            const auto middle = std::stable_partition(
                begin, end, [&](const Known& k) { return channel(k.color, r.along) <= sum / count; });
            const auto at = static_cast<std::size_t>(middle - known_.begin());
            if (at == r.begin || at == r.end) {
                widest->spread = 0;  // One color of that channel, to rounding.
                if (std::all_of(ranges.begin(), ranges.end(), [](const Range& each) { return each.spread == 0; })) {
                    break;
                }
                continue;
            }
            *widest = range(r.begin, at);
            ranges.push_back(range(at, r.end));
        }
        for (const Range& r : ranges) {
            std::array<double, 3> sum{};
            double count = 0;
            for (std::size_t i = r.begin; i < r.end; ++i) {
                known_[i].index = static_cast<std::uint8_t>(colors_.size());
                count += known_[i].count;
                for (int c = 0; c < 3; ++c) {
                    sum[static_cast<std::size_t>(c)] += known_[i].count * channel(known_[i].color, c);
                }
            }
            Pixel mean{};
            for (std::size_t c = 0; c < 3; ++c) {
                mean[c] = static_cast<std::uint8_t>(std::lround(sum[c] / count));
            }
            colors_.push_back(mean);
        }
    }

    std::vector<Known> known_;
    std::vector<Pixel> colors_;
};

class GifWriter final : public FilmWriter {
  public:
    GifWriter(WriteBytes write, int frames, double frames_per_second)
        : write_(std::move(write)), frames_(frames), frames_per_second_(frames_per_second) {}
    ~GifWriter() override {
        silent_ = true;  // What closing would write is of no use any more.
        close();
    }

    void add(const Image& frame, const std::stop_token& stop, double) override {
        if (added_ == frames_ || (added_ > 0 && (frame.width != last_.width || frame.height != last_.height))) {
            throw std::runtime_error("GIF: frames of one size, and no more than were told, make a film");
        }
        if (added_ == 0) {
            open(frame);
        }
        end_if_asked(stop);
        const bool whole = added_ == 0 || clears_;
        write_frame(frame, whole ? ImageRectangle{0, 0, frame.width, frame.height} : difference(last_, frame), whole);
        last_ = frame;
        ++added_;
    }

    void finish() override {
        if (added_ != frames_) {
            throw std::runtime_error("GIF: frames are missing");
        }
        need(close());
    }

  private:
    static constexpr int kHalf = 128;  ///< Opacity of which more is all.

    static int output(GifFileType* file, const GifByteType* bytes, int count) {
        const auto& self = *static_cast<const GifWriter*>(file->UserData);
        if (!self.silent_) {
            self.write_({reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count)});
        }
        return count;
    }
    static void need(bool done) {
        if (!done) {
            throw std::runtime_error("GIF: the film cannot be written");
        }
    }

    void open(const Image& first) {
        constexpr int kLargest = 65535;
        if (first.width > kLargest || first.height > kLargest) {
            throw std::runtime_error("GIF: a film is at most 65535 pixels wide and high");
        }
        for (std::size_t i = 3; i < first.rgba.size(); i += 4) {
            clears_ = clears_ || first.rgba[i] < kHalf;
        }
        int error = 0;
        file_ = EGifOpen(this, output, &error);
        need(file_ != nullptr);
        EGifSetGifVersion(file_, true);
        need(EGifPutScreenDesc(file_, first.width, first.height, 8, 0, nullptr) == GIF_OK);
        // Shown again and again.
        constexpr char kLoop[] = "NETSCAPE2.0";
        constexpr GifByteType kForever[]{1, 0, 0};
        need(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
             EGifPutExtensionBlock(file_, 11, kLoop) == GIF_OK && EGifPutExtensionBlock(file_, 3, kForever) == GIF_OK &&
             EGifPutExtensionTrailer(file_) == GIF_OK);
    }

    bool close() {
        int error = 0;
        GifFileType* const file = std::exchange(file_, nullptr);
        return file == nullptr || EGifCloseFile(file, &error) == GIF_OK;
    }

    /// Pixels that stay as they were are written as transparent.
    void write_frame(const Image& frame, const ImageRectangle& r, bool whole) {
        std::vector<std::optional<std::uint32_t>> pixels;
        std::vector<std::uint32_t> opaque;
        for (int y = r.y; y < r.y + r.height; ++y) {
            for (int x = r.x; x < r.x + r.width; ++x) {
                const std::uint8_t* p = frame.pixel(x, y);
                const bool seen = whole ? !clears_ || p[3] >= kHalf : !std::equal(p, p + 4, last_.pixel(x, y));
                pixels.push_back(seen ? std::optional(number_of(p)) : std::nullopt);
                if (seen) {
                    opaque.push_back(number_of(p));
                }
            }
        }
        const Palette palette(std::move(opaque), kColors - 1);
        const auto transparent = static_cast<int>(palette.colors().size());
        write_control(transparent);
        int bits = 1;
        while (1 << bits <= transparent) {
            ++bits;
        }
        std::vector<GifColorType> colors(std::size_t{1} << bits, GifColorType{0, 0, 0});
        for (std::size_t i = 0; i < palette.colors().size(); ++i) {
            const Pixel& c = palette.colors()[i];
            colors[i] = {c[0], c[1], c[2]};
        }
        ColorMapObject* const map = GifMakeMapObject(static_cast<int>(colors.size()), colors.data());
        need(map != nullptr);
        const bool begun = EGifPutImageDesc(file_, r.x, r.y, r.width, r.height, false, map) == GIF_OK;
        GifFreeMapObject(map);
        need(begun);
        std::vector<GifPixelType> row;
        for (std::size_t y = 0; y < static_cast<std::size_t>(r.height); ++y) {
            row.clear();
            for (std::size_t x = 0; x < static_cast<std::size_t>(r.width); ++x) {
                const auto& pixel = pixels[y * static_cast<std::size_t>(r.width) + x];
                row.push_back(pixel ? palette.index(*pixel) : static_cast<GifPixelType>(transparent));
            }
            need(EGifPutLine(file_, row.data(), r.width) == GIF_OK);
        }
    }

    void write_control(int transparent) {
        constexpr double kHundredths = 100;
        GraphicsControlBlock control{};
        control.DisposalMode = clears_ ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT;
        // So that all frames together take as long as they are to.
        const auto time = [&](int frame) { return std::lround(kHundredths * frame / frames_per_second_); };
        control.DelayTime = static_cast<int>(std::clamp(time(added_ + 1) - time(added_), 1L, 65535L));
        control.TransparentColor = transparent;
        std::array<GifByteType, 4> bytes{};
        need(EGifGCBToExtension(&control, bytes.data()) == bytes.size() &&
             EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()), bytes.data()) == GIF_OK);
    }

    WriteBytes write_;
    int frames_;
    double frames_per_second_;
    int added_ = 0;
    bool clears_ = false;  ///< Frames have pixels that are seen through: each is drawn on nothing.
    bool silent_ = false;
    Image last_;
    GifFileType* file_ = nullptr;
};

}  // namespace

std::unique_ptr<FilmWriter> gif_writer(WriteBytes write, int frames, double frames_per_second) {
    return std::make_unique<GifWriter>(std::move(write), frames, frames_per_second);
}

}  // namespace base
