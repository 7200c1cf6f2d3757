#include "tests/bench/report.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace bench {

namespace {

std::string layers_text(int layers) {
    return layers == 0 ? "all" : fmt::format("{}", layers);
}

nlohmann::ordered_json to_json(const Time& t) {
    return {{"wall_ms", t.wall}, {"cpu_ms", t.cpu}};
}

/// Geometric means of the ratio to the floor, by engine, size and layers, and beside that of one layer.
std::string means(const Report& report) {
    struct Mean {
        double logarithms = 0;
        int count = 0;
        [[nodiscard]] double value() const { return std::exp(logarithms / count); }
    };
    std::map<std::tuple<std::string, int, int>, Mean> means;
    for (const Row& r : report.rows) {
        Mean& mean = means[{r.engine, r.size, r.layers == 0 ? std::numeric_limits<int>::max() : r.layers}];
        mean.logarithms += std::log(ratio(r.peel, r.floor));
        ++mean.count;
    }
    std::string text =
        "| engine | size | layers | peel / floor, geometric mean | peel / peel of one layer |\n"
        "| --- | --- | --- | --- | --- |\n";
    for (const auto& [key, mean] : means) {
        const auto& [engine, size, layers] = key;
        const auto one = means.find({engine, size, 1});
        text += fmt::format("| {} | {}² | {} | {:.2f} | {} |\n", engine, size,
                            layers_text(layers == std::numeric_limits<int>::max() ? 0 : layers), mean.value(),
                            one == means.end() ? "–" : fmt::format("{:.2f}", mean.value() / one->second.value()));
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
                                  {"engine", r.engine},
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
        "\n| model | engine | leaves | products | size | layers | passes | floor | peel | × | style | frame | × |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Row& r : report.rows) {
        text += fmt::format(
            "| {} | {} | {} | {} | {}² | {} ({}) | {} | {:.1f} ({:.1f}) | {:.1f} ({:.1f}) | {:.1f} | {} | "
            "{:.1f} ({:.1f}) | {:.1f} |\n",
            r.model, r.engine, r.leaves, r.products, r.size, layers_text(r.layers), r.found_layers, r.passes,
            r.floor.cpu, r.floor.wall, r.peel.cpu, r.peel.wall, ratio(r.peel, r.floor), r.style, r.frame.cpu,
            r.frame.wall, ratio(r.frame, r.floor));
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
