// Sweeps families of hard models over their difficulty. See tools/robustness and docs/ROBUSTNESS.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>

#include "tests/stability/report.h"
#include "tests/support/output.h"

namespace {

using test_support::write_output;

struct Settings {
    std::string json, markdown, plots, plots_in_text = "robustness";
    std::vector<std::string> only;
    stability::SweepOptions sweep;
};

int run(const Settings& settings) {
    stability::Sweep sweep(settings.sweep);
    for (const std::string& reason : sweep.missing()) {
        std::cerr << "left out: " << reason << '\n';
    }
    std::vector<stability::FamilyResult> results;
    for (stability::Family& family : stability::families()) {
        if (!settings.only.empty() &&
            std::find(settings.only.begin(), settings.only.end(), family.name) == settings.only.end()) {
            continue;
        }
        const auto start = std::chrono::steady_clock::now();
        auto measures = sweep.run(family);
        results.push_back({std::move(family), std::move(measures)});
        std::cerr << fmt::format("{}: {:.1f} s\n", results.back().family.name,
                                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    if (results.empty()) {
        std::cerr << "no such family\n";
        return 2;
    }
    if (!settings.plots.empty()) {
        std::filesystem::create_directories(settings.plots);
        for (const auto& result : results) {
            write_output(settings.plots + "/" + plot_name(result.family), to_svg(result));
        }
    }
    write_output(settings.json, to_json(results).dump(1));
    write_output(settings.markdown, to_markdown(results, settings.plots_in_text));
    const auto wrong = stability::wrong_pictures(results);
    for (const std::string& line : wrong) {
        std::cout << line << '\n';
    }
    std::size_t pictures = 0;
    for (const auto& result : results) {
        pictures += result.measures.size();
    }
    std::cout << fmt::format("{} families, {} pictures, {} of our engines' with wrong pixels\n", results.size(),
                             pictures, wrong.size());
    return wrong.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    CLI::App app(
        "Families of hard models over their difficulty, every engine against the exact ray caster. Inside is a winding "
        "number that is not zero; OpenCSG, beside, counts parity.");
    app.add_option("--only", settings.only, "Names of families instead of all")->delimiter(';');
    app.add_option("--size", settings.sweep.size, "Side of the pictures in pixels")->capture_default_str();
    app.add_option("--most-leaves", settings.sweep.most_leaves, "Leave out levels with more leaves");
    app.add_flag("--few-levels", settings.sweep.few_levels, "The first, the middle and the last level only");
    app.add_option("--json", settings.json, "Write JSON; - is standard output");
    app.add_option("--markdown", settings.markdown, "Write tables; - is standard output");
    app.add_option("--plots", settings.plots, "Folder for plots (SVG)");
    app.add_option("--plots-in-text", settings.plots_in_text, "Where the tables' text finds the plots");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(settings);
    } catch (const std::exception& error) {
        std::cerr << "csgscope_stability: error: " << error.what() << '\n';
        return 2;
    }
}
