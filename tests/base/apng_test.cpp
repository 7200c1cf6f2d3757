// Films: each frame, put together again from the file's chunks, is the one that was added.
#include "base/apng.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <stdexcept>
#include <utility>

#include "tests/support/temporary_folder.h"

namespace base {
namespace {

struct Chunk {
    std::string kind, data;
};

std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t count = 4) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + count; ++i) {
        value = value << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return value;
}

std::string bytes_of(std::uint32_t value) {
    return {static_cast<char>(value >> 24 & 255), static_cast<char>(value >> 16 & 255),
            static_cast<char>(value >> 8 & 255), static_cast<char>(value & 255)};
}

std::uint32_t sum_of(const std::string& text) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}

std::vector<Chunk> chunks_of(const std::string& png) {
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at < png.size();) {
        const std::uint32_t length = number(png, at);
        chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
        EXPECT_EQ(number(png, at + 8 + length), sum_of(chunks.back().kind + chunks.back().data));
        at += 12 + length;
    }
    return chunks;
}

/// What a player shows, frame by frame, and how long (seconds).
std::vector<std::pair<Image, double>> play(const std::string& film) {
    const test_support::TemporaryFolder folder;
    std::vector<std::pair<Image, double>> shown;
    const std::vector<Chunk> chunks = chunks_of(film);
    std::string header, data, control;
    std::uint32_t sequence = 0, frames = 0;
    const auto end_frame = [&] {
        if (control.empty()) {
            return;
        }
        std::string png = film.substr(0, 8);
        const std::string size = control.substr(4, 8);
        for (const auto& [kind, content] :
             {std::pair<std::string, std::string>("IHDR", size + header.substr(8)), {"IDAT", data}, {"IEND", ""}}) {
            png += bytes_of(static_cast<std::uint32_t>(content.size())) + kind + content +
                   bytes_of(sum_of(kind + content));
        }
        folder.write("frame.png", png);
        const Image part = read_png(folder.path("frame.png"));
        Image image = shown.empty() ? part : shown.back().first;
        const std::uint32_t x = number(control, 12), y = number(control, 16);
        for (int row = 0; row < part.height; ++row) {
            std::copy_n(part.pixel(0, row), 4 * part.width,
                        image.rgba.begin() + 4 * ((static_cast<std::ptrdiff_t>(y) + row) * image.width + x));
        }
        shown.emplace_back(std::move(image), double{1} * number(control, 20, 2) / number(control, 22, 2));
        data.clear();
    };
    for (const Chunk& chunk : chunks) {
        if (chunk.kind == "IHDR") {
            header = chunk.data;
        } else if (chunk.kind == "acTL") {
            frames = number(chunk.data, 0);
        } else if (chunk.kind == "fcTL") {
            end_frame();
            control = chunk.data;
            EXPECT_EQ(number(control, 0), sequence++);
        } else if (chunk.kind == "IDAT") {
            data += chunk.data;
        } else if (chunk.kind == "fdAT") {
            EXPECT_EQ(number(chunk.data, 0), sequence++);
            data += chunk.data.substr(4);
        }
    }
    end_frame();
    EXPECT_EQ(frames, shown.size());
    return shown;
}

Image frame(int number) {
    Image image{40, 30, std::vector<std::uint8_t>(4 * 40 * 30, 255)};
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            std::uint8_t* const p = &image.rgba[static_cast<std::size_t>(4 * (40 * y + x))];
            p[0] = static_cast<std::uint8_t>(x > number && x < number + 9 && y > 5 && y < 20 ? 10 * number : 7 * y);
            p[3] = number == 2 && x == 3 ? 80 : 255;  // One frame is not opaque.
        }
    }
    return image;
}

TEST(Apng, ShowsItsFrames) {
    std::string film;
    ApngWriter writer([&](std::string_view bytes) { film += bytes; }, 5, 25);
    const int numbers[] = {0, 1, 1, 2, 30};
    for (const int n : numbers) {
        writer.add(frame(n), {}, 100);
    }
    writer.finish();
    const auto shown = play(film);
    ASSERT_EQ(shown.size(), 5u);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_EQ(shown[i].first.rgba, frame(numbers[i]).rgba) << i;
        EXPECT_NEAR(shown[i].second, 0.04, 1e-9);
    }
    // What does not change is not written again.
    std::string still;
    ApngWriter again([&](std::string_view bytes) { still += bytes; }, 1, 25);
    again.add(frame(0));
    again.finish();
    EXPECT_LT(film.size(), 3 * still.size());
}

TEST(Apng, RefusesOtherFrames) {
    const auto nowhere = [](std::string_view) {};
    ApngWriter writer(nowhere, 2, 10);
    writer.add(frame(0));
    EXPECT_THROW(writer.finish(), std::runtime_error);
    EXPECT_THROW(writer.add(Image{1, 1, {0, 0, 0, 0}}), std::runtime_error);
    writer.add(frame(1));
    EXPECT_THROW(writer.add(frame(2)), std::runtime_error);
}

}  // namespace
}  // namespace base
