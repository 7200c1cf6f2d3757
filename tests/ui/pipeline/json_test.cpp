#include "ui/pipeline/json.h"

#include <gtest/gtest.h>

namespace {

using ui::Json;

TEST(Json, ListsOfNamedValuesAreObjectsOthersAreArrays) {
    const Json json = {{"count", 3U}, {"of", {"a", 1.5}}, {"none", nullptr}, {"inner", {{"yes", true}}}, {"least", -1}};
    EXPECT_EQ(json.dump(), R"({"count":3,"of":["a",1.5],"none":null,"inner":{"yes":true},"least":-1})");
    EXPECT_EQ(json.find("inner")->dump(2), "{\n  \"yes\": true\n}");
    EXPECT_EQ(Json::array().dump() + Json::object().dump(), "[]{}");
}

TEST(Json, MembersKeepTheirPlaces) {
    Json json = {{"first", 1}, {"second", 2}};
    json.update({{"third", 3}, {"first", 4}});
    json["fourth"]["inner"] = 5.0;
    EXPECT_EQ(json.dump(), R"({"first":4,"second":2,"third":3,"fourth":{"inner":5.0}})");
    json.erase("first");
    EXPECT_EQ(json.find("first"), nullptr);
    EXPECT_EQ(json.members().front().first, "second");
}

TEST(Json, FractionsAreTheNumbersOfFloatingPoint) {
    EXPECT_TRUE(Json(2.0).is_fraction());
    EXPECT_FALSE(Json(2).is_fraction());
    EXPECT_EQ(Json(0.1).dump(), "0.1");
    EXPECT_EQ(Json(1e300).dump(), "1e+300");
}

TEST(Json, ReadsWhatItWrites) {
    const char* const text = R"({"a":[1,-2,0.5,"t",true,null],"b":{"c":18446744073709551615}})";
    EXPECT_EQ(Json::read(text, 100).dump(), text);
    EXPECT_EQ(Json::read(text, 1).dump(), "{}");  // What is nested deeper is left out.
    EXPECT_TRUE(Json::read("{", 100).is_null());
}

TEST(Json, BytesThatAreNoTextAreReplaced) {
    EXPECT_EQ(Json("a\xFFz").dump(), "\"a\xEF\xBF\xBDz\"");
}

}  // namespace
