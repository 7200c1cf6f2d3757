#include "tests/bench/report.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace bench {

namespace {

double ratio(const Time& a, const Time& b) {
    return a.cpu / std::max(b.cpu, 1e-3);
}

std::string layers_text(int layers) {
    return layers == 0 ? "all" : fmt::format("{}", layers);
}

nlohmann::ordered_json to_json(const Time& t) {
    return {{"wall_ms", t.wall}, {"cpu_ms", t.cpu}};
}

/// Geometric means of the ratio to the floor, by size and layers.
std::string means(const Report& report) {
    std::map<std::pair<int, int>, std::pair<double, int>> sums;
    for (const Row& r : report.rows) {
        auto& [sum, count] = sums[{r.size, r.layers == 0 ? 1 << 20 : r.layers}];
        sum += std::log(ratio(r.peel, r.floor));
        ++count;
    }
    std::string text = "| size | layers | peel / floor, geometric mean |\n| --- | --- | --- |\n";
    for (const auto& [key, value] : sums) {
        text += fmt::format("| {}² | {} | {:.1f} |\n", key.first,
                            key.second == 1 << 20 ? "all" : std::to_string(key.second),
                            std::exp(value.first / value.second));
    }
    return text;
}

}  // namespace

nlohmann::ordered_json to_json(const Report& report) {
    nlohmann::ordered_json json{{"renderer", report.renderer}, {"opengl", report.opengl}, {"repeat", report.repeat}};
    for (const Preparation& p : report.preparations) {
        json["preparation"].push_back({{"model", p.model},
                                       {"evaluate_ms", p.evaluate},
                                       {"place_ms", p.place},
                                       {"normalize_ms", p.normalize},
                                       {"upload_ms", p.upload}});
    }
    for (const Row& r : report.rows) {
        json["frames"].push_back({{"model", r.model},
                                  {"size", r.size},
                                  {"layers", layers_text(r.layers)},
                                  {"leaves", r.leaves},
                                  {"products", r.products},
                                  {"triangles", r.triangles},
                                  {"found_layers", r.found_layers},
                                  {"passes", r.passes},
                                  {"style", r.style},
                                  {"floor", to_json(r.floor)},
                                  {"peel", to_json(r.peel)},
                                  {"frame", to_json(r.frame)},
                                  {"peel_over_floor", ratio(r.peel, r.floor)},
                                  {"frame_over_floor", ratio(r.frame, r.floor)}});
    }
    return json;
}

std::string to_markdown(const Report& report) {
    std::string text = fmt::format(
        "Renderer: {} (OpenGL {}); medians of {} frames of one sample each; CPU milliseconds of all threads, wall "
        "milliseconds in brackets; × is the ratio to the floor in CPU time.\n\n",
        report.renderer, report.opengl, report.repeat);
    text += means(report);
    text +=
        "\n| model | leaves | products | size | layers | passes | floor | peel | × | style | frame | × |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Row& r : report.rows) {
        text += fmt::format(
            "| {} | {} | {} | {}² | {} ({}) | {} | {:.1f} ({:.1f}) | {:.1f} ({:.1f}) | {:.1f} | {} | "
            "{:.1f} ({:.1f}) | {:.1f} |\n",
            r.model, r.leaves, r.products, r.size, layers_text(r.layers), r.found_layers, r.passes, r.floor.cpu,
            r.floor.wall, r.peel.cpu, r.peel.wall, ratio(r.peel, r.floor), r.style, r.frame.cpu, r.frame.wall,
            ratio(r.frame, r.floor));
    }
    text +=
        "\nBefore the first picture, wall milliseconds:\n\n"
        "| model | evaluate | leaves as meshes | normalize | upload |\n| --- | --- | --- | --- | --- |\n";
    for (const Preparation& p : report.preparations) {
        text += fmt::format("| {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", p.model, p.evaluate, p.place, p.normalize,
                            p.upload);
    }
    return text;
}

}  // namespace bench
