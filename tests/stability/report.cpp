#include "tests/stability/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "tests/plot/plot.h"

namespace stability {

namespace {

constexpr const char* kForeign = "OpenCSG";

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

double wrong_share(const Measure& m) {
    return percent(m.errors.wrong, std::max(m.pixels, m.errors.wrong));
}

std::vector<std::string> engines(const std::vector<FamilyResult>& results) {
    std::vector<std::string> names;
    for (const FamilyResult& r : results) {
        for (const Measure& m : r.measures) {
            if (std::find(names.begin(), names.end(), m.engine) == names.end()) {
                names.push_back(m.engine);
            }
        }
    }
    return names;
}

/// The worst of an engine over a family.
struct Worst {
    std::size_t pictures = 0, refused = 0;
    double wrong = 0, depth = 0;
};

Worst worst(const FamilyResult& result, const std::string& engine) {
    Worst w;
    for (const Measure& m : result.measures) {
        if (m.engine != engine) {
            continue;
        }
        ++w.pictures;
        w.refused += m.errors.drawn ? 0 : 1;
        w.wrong = std::max(w.wrong, wrong_share(m));
        w.depth = std::max(w.depth, m.errors.depth_most);
    }
    return w;
}

std::string text(const Worst& w) {
    if (w.refused == w.pictures) {
        return "not drawn";
    }
    const std::string wrong = w.wrong == 0 ? "0" : fmt::format("{:.2g} %", w.wrong);
    return w.refused == 0 ? wrong : fmt::format("{} ({} of {} not drawn)", wrong, w.refused, w.pictures);
}

}  // namespace

nlohmann::ordered_json to_json(const std::vector<FamilyResult>& results) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const FamilyResult& r : results) {
        for (const Measure& m : r.measures) {
            nlohmann::ordered_json row{{"family", m.family},
                                       {"level", m.level},
                                       {"projection", m.orthographic ? "orthographic" : "perspective"},
                                       {"engine", m.engine},
                                       {"drawn", m.errors.drawn},
                                       {"pixels", m.pixels},
                                       {"in_band", m.undecided}};
            if (m.errors.drawn) {
                row["wrong"] = m.errors.wrong;
                row["coverage_errors"] = m.errors.coverage;
                row["depth_rms"] = m.errors.depth_rms;
                row["depth_most"] = m.errors.depth_most;
                row["milliseconds"] = m.errors.milliseconds;
                if (m.engine != kForeign) {
                    row["layer_errors"] = m.errors.layers;
                    row["normal_errors"] = m.errors.normal;
                }
            }
            json.push_back(row);
        }
    }
    return json;
}

std::string plot_name(const Family& family) {
    std::string name;
    for (const char c : family.name) {
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return name + ".svg";
}

std::string to_svg(const FamilyResult& result) {
    const Family& f = result.family;
    const auto [least, most] = std::minmax_element(f.levels.begin(), f.levels.end());
    const bool logarithmic = *most > 40 * std::max(*least, 0.0) && *most > 1e-9;
    plot::Plot p{
        f.name, {f.difficulty, logarithmic, f.levels.front() > f.levels.back()}, {"wrong pixels, %", false, false}, {}};
    for (const std::string& engine : engines({result})) {
        std::map<double, double> worst_at;
        for (const Measure& m : result.measures) {
            if (m.engine == engine && m.errors.drawn) {
                worst_at[m.level] = std::max(worst_at[m.level], wrong_share(m));
            }
        }
        p.series.push_back({engine, {worst_at.begin(), worst_at.end()}});
    }
    return plot::to_svg(p);
}

std::string to_markdown(const std::vector<FamilyResult>& results, const std::string& plots) {
    const std::vector<std::string> names = engines(results);
    std::string head = "| family | difficulty | levels | in the band, most |", rule = "| --- | --- | --- | --- |";
    for (const std::string& name : names) {
        head += fmt::format(" wrong: {} |", name);
        rule += " --- |";
    }
    std::string table = head + " depth error, most |\n" + rule + " --- |\n";
    std::string sections;
    for (const FamilyResult& r : results) {
        double band = 0, depth = 0;
        for (const Measure& m : r.measures) {
            band = std::max(band, percent(m.undecided, std::max(m.pixels, m.undecided)));
        }
        table += fmt::format("| {} | {} | {:g} … {:g} | {:.1f} % |", r.family.name, r.family.difficulty,
                             r.family.levels.front(), r.family.levels.back(), band);
        for (const std::string& name : names) {
            const Worst w = worst(r, name);
            table += fmt::format(" {} |", text(w));
            depth = name == kForeign ? depth : std::max(depth, w.depth);
        }
        table += fmt::format(" {:.1e} |\n", depth);
        sections += fmt::format("\n### {}\n{}\n\n![{}]({}/{})\n", r.family.name, r.family.what, r.family.name, plots,
                                plot_name(r.family));
    }
    if (std::find(names.begin(), names.end(), kForeign) != names.end()) {
        table += fmt::format(
            "\n{} finds what is inside by parity, in as many layers of a leaf as its convexity says: where the shells "
            "of "
            "a leaf overlap, it is wrong by that.\n",
            kForeign);
    }
    return table + sections;
}

std::vector<std::string> wrong_pictures(const std::vector<FamilyResult>& results) {
    std::vector<std::string> lines;
    for (const FamilyResult& r : results) {
        for (const Measure& m : r.measures) {
            if (m.engine != kForeign && m.errors.wrong > 0) {
                lines.push_back(fmt::format("{} at {:g}, {}, {}: {} wrong pixels of {}", m.family, m.level,
                                            m.orthographic ? "orthographic" : "perspective", m.engine, m.errors.wrong,
                                            m.pixels));
            }
        }
    }
    return lines;
}

}  // namespace stability
