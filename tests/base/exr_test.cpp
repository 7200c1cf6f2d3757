// OpenEXR files, read back by the format's description.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <map>

#include "base/exr.h"

namespace {

class Reader {
  public:
    explicit Reader(const std::string& bytes) : bytes_(bytes) {}

    std::uint64_t number(int bytes) {
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) {
            value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_.at(at_++))) << 8 * i;
        }
        return value;
    }
    std::string name() {
        std::string text = bytes_.substr(at_, bytes_.find('\0', at_) - at_);
        at_ += text.size() + 1;
        return text;
    }
    float real() { return std::bit_cast<float>(static_cast<std::uint32_t>(number(4))); }
    std::string bytes(std::size_t count) {
        at_ += count;
        return bytes_.substr(at_ - count, count);
    }
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] bool end() const { return at_ == bytes_.size(); }

  private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

TEST(Exr, HoldsChannelsByNameAndRowsFromTheTop) {
    const float most = std::numeric_limits<float>::max();
    const std::string file =
        base::encode_exr({3, 2, {{"Y", {1, 2, 3, 4, 5, 6.5F}}, {"#ff8000", {0, -1, 0, most, 0, 1e-30F}}}});
    Reader in(file);
    EXPECT_EQ(in.number(4), 20000630U);
    EXPECT_EQ(in.number(4), 2U);
    std::map<std::string, std::pair<std::string, std::string>> attributes;
    for (std::string name = in.name(); !name.empty(); name = in.name()) {
        const std::string type = in.name();
        const auto size = static_cast<std::size_t>(in.number(4));
        attributes[name] = {type, in.bytes(size)};
    }
    for (const char* needed : {"channels", "compression", "dataWindow", "displayWindow", "lineOrder",
                               "pixelAspectRatio", "screenWindowCenter", "screenWindowWidth"}) {
        EXPECT_TRUE(attributes.contains(needed)) << needed;
    }
    Reader list(attributes["channels"].second);
    EXPECT_EQ(list.name(), "#ff8000");
    EXPECT_EQ(list.number(4), 2U) << "32-bit floats";
    (void)list.bytes(12);
    EXPECT_EQ(list.name(), "Y");
    (void)list.bytes(16);
    EXPECT_EQ(list.name(), "");
    EXPECT_TRUE(list.end());
    Reader window(attributes["dataWindow"].second);
    EXPECT_EQ(window.number(8), 0U);
    EXPECT_EQ(window.number(4), 2U);
    EXPECT_EQ(window.number(4), 1U);
    const std::size_t first = static_cast<std::size_t>(in.number(8)), second = static_cast<std::size_t>(in.number(8));
    EXPECT_EQ(in.at(), first);
    for (std::uint32_t y = 0; y < 2; ++y) {
        EXPECT_EQ(in.at(), y == 0 ? first : second);
        EXPECT_EQ(in.number(4), y);
        EXPECT_EQ(in.number(4), 24U);
        if (y == 0) {
            EXPECT_EQ(in.bytes(12).size(), 12U);
            EXPECT_EQ(in.real(), 1);
            (void)in.bytes(8);
        } else {
            EXPECT_EQ(in.real(), most);
            EXPECT_EQ(in.real(), 0);
            EXPECT_EQ(in.real(), 1e-30F);
            (void)in.bytes(8);
            EXPECT_EQ(in.real(), 6.5F);
        }
    }
    EXPECT_TRUE(in.end());
}

TEST(Exr, LongNamesAreSaid) {
    const std::string file = base::encode_exr({1, 1, {{std::string(40, 'n'), {1}}}});
    EXPECT_EQ(static_cast<unsigned char>(file[5]), 4U);
}

}  // namespace
