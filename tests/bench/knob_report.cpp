#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/bench/knobs.h"
#include "tests/plot/plot.h"

namespace bench {

namespace {

/// Over the models: the geometric mean of times, the mean of errors.
struct Point {
    double value = 0, cpu = 0, error = 0;
};

std::vector<std::string> engines(const std::vector<KnobRow>& rows, const std::string& knob) {
    std::vector<std::string> names;
    for (const KnobRow& r : rows) {
        if (r.knob == knob && std::find(names.begin(), names.end(), r.engine) == names.end()) {
            names.push_back(r.engine);
        }
    }
    return names;
}

/// In order of values. A value that not all models have is left out: its mean would be of others.
std::vector<Point> means(const std::vector<KnobRow>& rows, const std::string& knob, const std::string& engine) {
    struct Sum {
        double logarithms = 0, errors = 0;
        std::size_t count = 0;
    };
    std::map<double, Sum> sums;
    for (const KnobRow& r : rows) {
        if (r.knob == knob && r.engine == engine) {
            Sum& sum = sums[r.value];
            sum.logarithms += std::log(std::max(r.cpu, 1e-3));
            sum.errors += r.error;
            ++sum.count;
        }
    }
    std::size_t most = 0;
    for (const auto& [value, sum] : sums) {
        most = std::max(most, sum.count);
    }
    std::vector<Point> points;
    for (const auto& [value, sum] : sums) {
        if (sum.count == most) {
            const auto count = static_cast<double>(sum.count);
            points.push_back({value, std::exp(sum.logarithms / count), sum.errors / count});
        }
    }
    return points;
}

std::string value_text(double value) {
    return std::isinf(value) ? "all" : fmt::format("{:g}", value);
}

std::string table(const std::vector<KnobRow>& rows, const KnobInfo& knob) {
    const std::vector<std::string> names = engines(rows, knob.name);
    std::map<double, std::map<std::string, Point>> by_value;
    for (const std::string& name : names) {
        for (const Point& p : means(rows, knob.name, name)) {
            by_value[p.value][name] = p;
        }
    }
    std::string head = fmt::format("| {} |", knob.value), rule = "| --- |";
    for (const std::string& name : names) {
        head += fmt::format(" {} |", name);
        rule += " --- |";
    }
    std::string text = head + "\n" + rule + "\n";
    for (const auto& [value, points] : by_value) {
        text += fmt::format("| {} |", value_text(value));
        for (const std::string& name : names) {
            const auto found = points.find(name);
            if (found == points.end()) {
                text += " – |";
            } else if (knob.times) {
                text += fmt::format(" {:.1f} ({:.2g} %) |", found->second.cpu, found->second.error);
            } else {
                text += fmt::format(" {:.2g} % |", found->second.error);
            }
        }
        text += "\n";
    }
    return text;
}

std::string plot_name(const KnobInfo& knob) {
    std::string name = "knob_" + knob.name + ".svg";
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

bool has(const std::vector<KnobRow>& rows, const KnobInfo& knob) {
    return std::any_of(rows.begin(), rows.end(), [&](const KnobRow& r) { return r.knob == knob.name; });
}

}  // namespace

const std::vector<KnobInfo>& knobs() {
    static const std::vector<KnobInfo> all{
        {"resolution", "Sides of the picture, one sample a pixel, first surface.", "area wrongly covered", true,
         "side"},
        {"samples", "Samples a pixel, first surface.", "area wrongly covered", true, "samples"},
        {"layers", "Layers asked for.", "surfaces left out", true, "layers"},
        {"minimal fraction",
         "The least share of the pixels for which peeling goes on (--minimal-fraction): whole frames of blueprints of "
         "all layers, of the models with the most.",
         "pixels that differ", true, "share"},
        {"tessellation", "Sides of curved leaves ($fn), first surface.", "area that differs from 512 sides", true,
         "sides"},
        {"depth", "Bits of depth (16 and 24 fixed point, 32 float, 53 double), all layers.", "wrong pixels", false,
         "bits"},
    };
    return all;
}

nlohmann::ordered_json to_json(const std::vector<KnobRow>& rows) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const KnobRow& r : rows) {
        json.push_back(
            {{"knob", r.knob},
             {"model", r.model},
             {"engine", r.engine},
             {"value", std::isinf(r.value) ? nlohmann::ordered_json("all") : nlohmann::ordered_json(r.value)},
             {"cpu_ms", r.cpu},
             {"error_percent", r.error}});
    }
    return json;
}

std::string to_markdown(const std::vector<KnobRow>& rows, const std::string& plots) {
    std::string text;
    for (const KnobInfo& knob : knobs()) {
        if (has(rows, knob)) {
            text += fmt::format("### {}\n{} {}\n\n{}\n![{}]({}/{})\n\n", knob.name, knob.what,
                                knob.times ? fmt::format("CPU milliseconds, and in brackets the {}.", knob.error)
                                           : fmt::format("The {}.", knob.error),
                                table(rows, knob), knob.name, plots, plot_name(knob));
        }
    }
    return text;
}

std::vector<std::pair<std::string, std::string>> to_plots(const std::vector<KnobRow>& rows) {
    std::vector<std::pair<std::string, std::string>> plots;
    for (const KnobInfo& knob : knobs()) {
        if (!has(rows, knob)) {
            continue;
        }
        plot::Plot p{knob.times ? "CPU time against error: " + knob.name : "Error: " + knob.name,
                     {knob.times ? knob.error + ", %" : knob.value, knob.times, false},
                     {knob.times ? "CPU ms" : knob.error + ", %", knob.times, false},
                     {},
                     true,
                     560,
                     320};
        for (const std::string& engine : engines(rows, knob.name)) {
            plot::Series series{engine, {}, {}};
            for (const Point& point : means(rows, knob.name, engine)) {
                series.points.emplace_back(knob.times ? point.error : point.value,
                                           knob.times ? point.cpu : point.error);
                series.labels.push_back(knob.times ? value_text(point.value) : std::string());
            }
            p.series.push_back(std::move(series));
        }
        plots.emplace_back(plot_name(knob), plot::to_svg(p));
    }
    return plots;
}

}  // namespace bench
