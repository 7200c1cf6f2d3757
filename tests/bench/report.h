// What the benchmark found, as JSON and as the tables of docs/PERFORMANCE.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace bench {

/// One model at one size with so many layers.
struct Row {
    std::string model, engine;
    int size = 0;
    int layers = 0;  ///< Asked for; 0: all.
    std::size_t leaves = 0, products = 0, triangles = 0;
    int found_layers = 0;
    int passes = 0;
    std::string style;
    Time floor, peel, frame;  ///< frame: peel, style and resolve of one sample.
};

/// What comes before the first picture.
struct Preparation {
    std::string model;
    double evaluate = 0, place = 0, normalize = 0, upload = 0;  ///< Wall milliseconds.
};

struct Report {
    std::string renderer, opengl;
    int repeat = 0;
    std::vector<Preparation> preparations;
    std::vector<Row> rows;
};

[[nodiscard]] nlohmann::ordered_json to_json(const Report& report);
[[nodiscard]] std::string to_markdown(const Report& report);

}  // namespace bench
