// Films as GIF and WebP: what decoders show is what was added.
#include <gif_lib.h>
#include <gtest/gtest.h>
#include <webp/demux.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/film_writer.h"

namespace base {
namespace {

struct Shown {
    Image image;
    int milliseconds = 0;
};

struct Bytes {
    const std::string& all;
    std::size_t at = 0;
};

int read_bytes(GifFileType* file, GifByteType* to, int count) {
    auto& from = *static_cast<Bytes*>(file->UserData);
    const std::size_t taken = std::min(static_cast<std::size_t>(count), from.all.size() - from.at);
    std::memcpy(to, from.all.data() + from.at, taken);
    from.at += taken;
    return static_cast<int>(taken);
}

/// What a player shows: each frame over the one before, unless that one was to be cleared.
std::vector<Shown> play_gif(const std::string& film) {
    Bytes bytes{film};
    int error = 0;
    GifFileType* const file = DGifOpen(&bytes, read_bytes, &error);
    EXPECT_NE(file, nullptr);
    EXPECT_EQ(DGifSlurp(file), GIF_OK);
    std::vector<Shown> shown;
    Image canvas{file->SWidth, file->SHeight,
                 std::vector<std::uint8_t>(4 * static_cast<std::size_t>(file->SWidth * file->SHeight), 0)};
    for (int i = 0; i < file->ImageCount; ++i) {
        const SavedImage& saved = file->SavedImages[i];
        const GifImageDesc& at = saved.ImageDesc;
        GraphicsControlBlock control;
        EXPECT_EQ(DGifSavedExtensionToGCB(file, i, &control), GIF_OK);
        for (int y = 0; y < at.Height; ++y) {
            for (int x = 0; x < at.Width; ++x) {
                const int index = saved.RasterBits[y * at.Width + x];
                if (index != control.TransparentColor) {
                    const GifColorType& c = at.ColorMap->Colors[index];
                    std::uint8_t* const to =
                        &canvas.rgba[static_cast<std::size_t>(4 * ((y + at.Top) * canvas.width + x + at.Left))];
                    to[0] = c.Red;
                    to[1] = c.Green;
                    to[2] = c.Blue;
                    to[3] = 255;
                }
            }
        }
        shown.push_back({canvas, 10 * control.DelayTime});
        if (control.DisposalMode == DISPOSE_BACKGROUND) {
            std::fill(canvas.rgba.begin(), canvas.rgba.end(), std::uint8_t{0});
        }
    }
    DGifCloseFile(file, &error);
    return shown;
}

std::vector<Shown> play_webp(const std::string& film) {
    const WebPData data{reinterpret_cast<const std::uint8_t*>(film.data()), film.size()};
    WebPAnimDecoder* const decoder = WebPAnimDecoderNew(&data, nullptr);
    EXPECT_NE(decoder, nullptr);
    WebPAnimInfo info;
    EXPECT_NE(WebPAnimDecoderGetInfo(decoder, &info), 0);
    EXPECT_EQ(info.loop_count, 0u);
    std::vector<Shown> shown;
    int before = 0;
    while (WebPAnimDecoderHasMoreFrames(decoder) != 0) {
        std::uint8_t* pixels = nullptr;
        int end = 0;
        EXPECT_NE(WebPAnimDecoderGetNext(decoder, &pixels, &end), 0);
        const std::size_t count = std::size_t{4} * info.canvas_width * info.canvas_height;
        shown.push_back({{static_cast<int>(info.canvas_width), static_cast<int>(info.canvas_height),
                          std::vector<std::uint8_t>(pixels, pixels + count)},
                         end - before});
        before = end;
    }
    WebPAnimDecoderDelete(decoder);
    return shown;
}

constexpr int kWidth = 40, kHeight = 30;

/// A square that moves over a ground; `clear`: of nothing.
Image frame(int number, bool clear = false) {
    Image image{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool square = x > number && x < number + 9 && y > 5 && y < 20;
            const auto shade = static_cast<std::uint8_t>(square ? 10 * number + 5 : 7 * y);
            image.rgba.insert(image.rgba.end(), {shade, static_cast<std::uint8_t>(square ? 200 : 3), 9,
                                                 static_cast<std::uint8_t>(square || !clear ? 255 : 0)});
        }
    }
    return image;
}

using Make = std::unique_ptr<FilmWriter> (*)(WriteBytes, int, double);

std::string film_of(Make make, const std::vector<Image>& frames, double rate) {
    std::string film;
    const auto writer = make([&](std::string_view bytes) { film += bytes; }, static_cast<int>(frames.size()), rate);
    for (const Image& each : frames) {
        writer->add(each, {}, 0);
    }
    writer->finish();
    return film;
}

/// Where nothing is seen there is no color.
std::vector<std::uint8_t> seen(Image image) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        if (image.rgba[i + 3] == 0) {
            std::fill_n(image.rgba.begin() + static_cast<std::ptrdiff_t>(i), 3, std::uint8_t{0});
        }
    }
    return std::move(image.rgba);
}

void expect_frames(const std::vector<Shown>& shown, const std::vector<Image>& frames) {
    ASSERT_EQ(shown.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(seen(shown[i].image), seen(frames[i])) << i;
    }
}

TEST(Gif, ShowsItsFrames) {
    for (const bool clear : {false, true}) {
        const std::vector<Image> frames{frame(0, clear), frame(1, clear), frame(2, clear), frame(20, clear)};
        const std::string film = film_of(gif_writer, frames, 30);
        const std::vector<Shown> shown = play_gif(film);
        expect_frames(shown, frames);
        // In hundredths of a second, of which frames have three or four: together as long as they are to be.
        int all = 0;
        for (const Shown& each : shown) {
            all += each.milliseconds;
        }
        EXPECT_EQ(all, 130);
        EXPECT_EQ(film, film_of(gif_writer, frames, 30));
    }
}

TEST(Gif, TakesTheNearestColors) {
    Image image{128, 128, {}};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            image.rgba.insert(image.rgba.end(), {static_cast<std::uint8_t>(2 * x), static_cast<std::uint8_t>(2 * y),
                                                 static_cast<std::uint8_t>(x + y), 255});
        }
    }
    const std::vector<Shown> shown = play_gif(film_of(gif_writer, {image}, 10));
    ASSERT_EQ(shown.size(), 1u);
    // 16,384 colors on a plane; 255 cells of it are 16 wide.
    int worst = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        worst = std::max(worst, std::abs(int{image.rgba[i]} - int{shown[0].image.rgba[i]}));
    }
    EXPECT_LE(worst, 16);
    EXPECT_GT(worst, 0);
}

TEST(WebP, ShowsItsFrames) {
    for (const bool clear : {false, true}) {
        const std::vector<Image> frames{frame(0, clear), frame(1, clear), frame(2, clear), frame(20, clear)};
        const std::string film = film_of(webp_writer, frames, 30);
        const std::vector<Shown> shown = play_webp(film);
        expect_frames(shown, frames);
        int all = 0;
        for (const Shown& each : shown) {
            all += each.milliseconds;
        }
        EXPECT_EQ(all, 133);
        EXPECT_EQ(film, film_of(webp_writer, frames, 30));
    }
}

TEST(Films, RefuseOtherFrames) {
    for (const Make make : {Make{gif_writer}, Make{webp_writer}}) {
        const auto writer = make([](std::string_view) {}, 2, 10);
        writer->add(frame(0), {}, 0);
        EXPECT_THROW(writer->finish(), std::runtime_error);
        EXPECT_THROW(writer->add(Image{1, 1, {0, 0, 0, 0}}, {}, 0), std::runtime_error);
        writer->add(frame(1), {}, 0);
        EXPECT_THROW(writer->add(frame(2), {}, 0), std::runtime_error);
    }
}

}  // namespace
}  // namespace base
