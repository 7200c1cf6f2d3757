// Engines side by side over the gallery and over families that grow. See tools/benchmark and docs/PERFORMANCE.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "tests/bench/compare.h"
#include "tests/bench/growth.h"
#include "tests/support/output.h"
#include "ui/pipeline/heap.h"

namespace {

using test_support::write_output;

struct Settings {
    std::string models = "models", json, markdown, plots;
    std::vector<std::string> only, families;
    std::vector<int> sizes{512};
    int repeat = 5;
    std::size_t most_leaves = 1'000'000;
};

std::vector<std::string> model_files(const Settings& settings) {
    std::vector<std::string> files;
    for (const std::filesystem::path& path : bench::gallery(settings.models)) {
        if (settings.only.empty() ||
            std::find(settings.only.begin(), settings.only.end(), path.stem().string()) != settings.only.end()) {
            files.push_back(path.string());
        }
    }
    return files;
}

std::vector<bench::Compared> run(const Settings& settings, gl::Context& context) {
    bench::Comparison comparison(context, *std::max_element(settings.sizes.begin(), settings.sizes.end()),
                                 settings.repeat);
    if (!comparison.missing().empty()) {
        std::cerr << "left out: " << comparison.missing() << '\n';
    }
    std::vector<bench::Compared> rows;
    const std::vector<int> family_sizes{settings.sizes.front()};
    const auto measure = [&](const bench::Subject& subject, const std::vector<int>& sizes) {
        for (const int size : sizes) {
            for (auto& row : comparison.run(subject, size)) {
                std::cerr << fmt::format("{} {:g}, {}², {}: {}\n", row.model, row.family_size, size, row.engine,
                                         row.drawn
                                             ? fmt::format("{:.1f} CPU ms, {:.2g} % wrong", row.time.cpu, row.wrong)
                                             : std::string("not drawn"));
                rows.push_back(std::move(row));
            }
        }
    };
    for (const std::string& file : model_files(settings)) {
        measure(bench::from_file(file), settings.sizes);
    }
    for (const stability::Family& family : bench::growing_families()) {
        if (!settings.families.empty() &&
            std::find(settings.families.begin(), settings.families.end(), family.name) == settings.families.end()) {
            continue;
        }
        for (const double level : family.levels) {
            stability::Case shown = family.make(level);
            const bench::Subject subject = bench::from_tree(family.name, level, std::move(shown.tree), shown.camera);
            if (subject.model->statistics.leaves <= settings.most_leaves) {
                measure(subject, family_sizes);
            }
        }
    }
    return rows;
}

}  // namespace

int main(int argc, char** argv) {
    ui::keep_freed_memory();
    Settings settings;
    CLI::App app("CPU time and error of the engines and of OpenCSG, beside one plain z-buffer draw of all leaves.");
    app.add_option("--models", settings.models, "Folder with manifest.json")->capture_default_str();
    app.add_option("--only", settings.only, "Names of models of the gallery instead of all")->delimiter(',');
    app.add_option("--families", settings.families, "Names of families instead of all; none")->delimiter(';');
    app.add_option("--most-leaves", settings.most_leaves, "Leave out models of families with more leaves");
    app.add_option("--sizes", settings.sizes, "Sides of the picture in pixels; families at the first")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--repeat", settings.repeat, "Frames per figure")->capture_default_str()->check(CLI::PositiveNumber);
    app.add_option("--json", settings.json, "Write JSON; - is standard output");
    app.add_option("--markdown", settings.markdown, "Write tables; - is standard output");
    app.add_option("--plots", settings.plots, "Folder for plots (SVG)");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto context = gl::create_context(gl::ContextKind::Auto);
        const auto rows = run(settings, *context);
        write_output(settings.json, to_json(rows).dump(1));
        write_output(settings.markdown, bench::to_markdown(rows));
        if (!settings.plots.empty()) {
            std::filesystem::create_directories(settings.plots);
            for (const auto& [name, text] : to_plots(rows)) {
                write_output(settings.plots + "/" + name, text);
            }
        }
    } catch (const std::exception& error) {
        std::cerr << "csgscope_compare: error: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
