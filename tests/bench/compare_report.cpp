#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/bench/compare.h"
#include "tests/plot/plot.h"

namespace bench {

namespace {

template <typename T>
std::vector<T> distinct(const std::vector<Compared>& rows, T Compared::*field) {
    std::vector<T> values;
    for (const Compared& r : rows) {
        if (std::find(values.begin(), values.end(), r.*field) == values.end()) {
            values.push_back(r.*field);
        }
    }
    return values;
}

std::vector<std::string> engines(const std::vector<Compared>& rows) {
    return distinct(rows, &Compared::engine);
}

/// The row of another engine on the same picture.
const Compared* beside(const std::vector<Compared>& rows, const Compared& row, const std::string& engine) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Compared& r) {
        return r.model == row.model && r.family_size == row.family_size && r.side == row.side && r.engine == engine;
    });
    return found == rows.end() ? nullptr : &*found;
}

/// Geometric means over the gallery of CPU time over the floor's, and the worst error.
std::string means(const std::vector<Compared>& rows) {
    std::string text =
        "| size | engine | CPU time / floor, geometric mean | least | most | models drawn | wrong pixels, most |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const int side : distinct(rows, &Compared::side)) {
        for (const std::string& engine : engines(rows)) {
            double sum = 0, least = 1e300, most = 0, wrong = 0;
            int drawn = 0, all = 0;
            for (const Compared& r : rows) {
                if (r.side != side || r.engine != engine || r.family_size != 0) {
                    continue;
                }
                ++all;
                const Compared* floor = beside(rows, r, "floor");
                if (!r.drawn || floor == nullptr) {
                    continue;
                }
                const double x = ratio(r.time, floor->time);
                sum += std::log(x);
                least = std::min(least, x);
                most = std::max(most, x);
                wrong = std::max(wrong, r.wrong);
                ++drawn;
            }
            if (drawn > 0) {
                text += fmt::format("| {}² | {} | {:.2f} | {:.2f} | {:.2f} | {} of {} | {:.2g} % |\n", side, engine,
                                    std::exp(sum / drawn), least, most, drawn, all, wrong);
            }
        }
    }
    return text;
}

/// How cost grows with size over the last step of each family: the exponent of leaves that gives it.
std::string growth(const std::vector<Compared>& rows) {
    std::string text = "| family | engine | leaves | CPU ms | exponent |\n| --- | --- | --- | --- | --- |\n";
    for (const std::string& model : distinct(rows, &Compared::model)) {
        for (const std::string& engine : engines(rows)) {
            std::vector<const Compared*> grown;
            for (const Compared& r : rows) {
                if (r.model == model && r.engine == engine && r.drawn && r.family_size > 0) {
                    grown.push_back(&r);
                }
            }
            if (grown.size() < 2) {
                continue;
            }
            const Compared &to = *grown.back(), &from = *grown[grown.size() - 2];
            text += fmt::format("| {} | {} | {} … {} | {:.3g} … {:.3g} | {:.2f} |\n", model, engine, from.leaves,
                                to.leaves, from.time.cpu, to.time.cpu,
                                std::log(ratio(to.time, from.time)) /
                                    std::log(static_cast<double>(to.leaves) / static_cast<double>(from.leaves)));
        }
    }
    return text;
}

}  // namespace

nlohmann::ordered_json to_json(const std::vector<Compared>& rows) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Compared& r : rows) {
        nlohmann::ordered_json row{
            {"model", r.model},       {"family_size", r.family_size}, {"size", r.side},     {"leaves", r.leaves},
            {"products", r.products}, {"triangles", r.triangles},     {"engine", r.engine}, {"drawn", r.drawn}};
        if (r.drawn) {
            row["cpu_ms"] = r.time.cpu;
            row["wall_ms"] = r.time.wall;
            row["wrong_percent"] = r.wrong;
            row["peak_megabytes"] = r.peak;
        }
        json.push_back(row);
    }
    return json;
}

std::string to_markdown(const std::vector<Compared>& rows) {
    const std::vector<std::string> names = engines(rows);
    std::string head = "| model | leaves | products | size |", rule = "| --- | --- | --- | --- |";
    for (const std::string& name : names) {
        head += fmt::format(" {} |", name);
        rule += " --- |";
    }
    std::string text = means(rows);
    text += fmt::format("\nCPU milliseconds, wrong pixels in brackets where there are any:\n\n{}\n{}\n", head, rule);
    for (const Compared& r : rows) {
        if (r.engine != names.front()) {
            continue;
        }
        text += fmt::format("| {}{} | {} | {} | {}² |", r.model,
                            r.family_size == 0 ? std::string() : fmt::format(", {:g}", r.family_size), r.leaves,
                            r.products, r.side);
        for (const std::string& name : names) {
            const Compared* other = beside(rows, r, name);
            if (other == nullptr || !other->drawn) {
                text += " – |";
            } else if (other->wrong > 0) {
                text += fmt::format(" {:.1f} ({:.2g} %) |", other->time.cpu, other->wrong);
            } else {
                text += fmt::format(" {:.1f} |", other->time.cpu);
            }
        }
        text += "\n";
    }
    return text + "\nCost against size, over the last step of each family (1 is linear):\n\n" + growth(rows);
}

std::vector<std::pair<std::string, std::string>> to_plots(const std::vector<Compared>& rows) {
    std::vector<std::pair<std::string, std::string>> plots;
    plot::Plot scatter{"Speed against error, all models",
                       {"wrong pixels, %", true, false},
                       {"CPU time / floor", true, false},
                       {},
                       false,
                       640,
                       340};
    for (const std::string& engine : engines(rows)) {
        plot::Series series{engine, {}};
        for (const Compared& r : rows) {
            const Compared* floor = beside(rows, r, "floor");
            if (r.engine == engine && engine != "floor" && r.drawn && floor != nullptr) {
                series.points.emplace_back(r.wrong, ratio(r.time, floor->time));
            }
        }
        if (!series.points.empty()) {
            scatter.series.push_back(std::move(series));
        }
    }
    plots.emplace_back("speed_against_error.svg", plot::to_svg(scatter));
    for (const std::string& model : distinct(rows, &Compared::model)) {
        plot::Plot cost{model, {"leaves", true, false}, {"CPU ms", true, false}, {}, true, 640, 340};
        for (const std::string& engine : engines(rows)) {
            plot::Series series{engine, {}};
            for (const Compared& r : rows) {
                if (r.model == model && r.engine == engine && r.drawn && r.family_size > 0) {
                    series.points.emplace_back(static_cast<double>(r.leaves), r.time.cpu);
                }
            }
            if (!series.points.empty()) {
                cost.series.push_back(std::move(series));
            }
        }
        if (!cost.series.empty()) {
            std::string name = model;
            std::replace(name.begin(), name.end(), ' ', '_');
            plots.emplace_back(fmt::format("cost_{}.svg", name), plot::to_svg(cost));
        }
    }
    return plots;
}

}  // namespace bench
