// How smoothly a solid follows the hand that drags it, and how quickly an undo is seen: plates with holes written out
// one by one, and the programs named. One sample, as the window draws while something is held, by the processor.
//
//     csgscope_drag [--holes N]... [--size W,H] [--frames N] [--styles A,B] [FILE...]
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "npr/style.h"
#include "tests/bench/measure.h"
#include "ui/pipeline/editing/text_document.h"
#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/sections.h"
#include "ui/viewer/revision.h"

namespace {

struct Program {
    std::string name, path, text;
};

/// A square plate less holes of 32 sides in rows, each a statement.
Program plate(int holes) {
    const int side = static_cast<int>(std::ceil(std::sqrt(holes)));
    std::string text = fmt::format("difference() {{\n  cube([{0}, {0}, 2]);\n", 4 * side);
    for (int i = 0; i < holes; ++i) {
        text += fmt::format("  translate([{}, {}, -1]) cylinder(h = 4, r = 1, $fn = 32);\n", 4 * (i % side) + 2,
                            4 * (i / side) + 2);
    }
    return {fmt::format("plate, {} holes", holes), "plate.scad", text + "}\n"};
}

Program from_file(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return {std::filesystem::path(path).stem().string(), path, text.str()};
}

class Window {
  public:
    explicit Window(const Program& program) { source_.path = program.path; }

    /// As the window makes a model of a text.
    const std::shared_ptr<const ui::Model>& take(const std::string& text) {
        source_.edited = text;
        const ui::Revision revision = evaluate_(source_, {}, {});
        if (!revision.model) {
            throw std::runtime_error(source_.path + " makes no model");
        }
        view_ = revision.view;
        model_ = revision.model;
        return model_;
    }
    [[nodiscard]] const csg::scad::ViewSettings& view() const { return view_; }

  private:
    ui::Source source_;
    ui::Evaluate evaluate_ = ui::make_evaluate();
    csg::scad::ViewSettings view_;
    std::shared_ptr<const ui::Model> model_;
};

bench::Time middle(std::vector<bench::Time> times) {
    const auto nth = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    bench::Time both;
    std::nth_element(times.begin(), nth, times.end(), [](auto& a, auto& b) { return a.wall < b.wall; });
    both.wall = nth->wall;
    std::nth_element(times.begin(), nth, times.end(), [](auto& a, auto& b) { return a.cpu < b.cpu; });
    both.cpu = nth->cpu;
    return both;
}

struct Drag {
    bench::Time edit, frame;  ///< The model follows; the same, and the picture.
};

/// The leaf goes round its place, by a third of its size.
Drag drag(const std::shared_ptr<const ui::Model>& model, csg::LeafId leaf, const ui::PictureRequest& request,
          ui::Renderer& renderer, int frames) {
    ui::SectionedModel sectioned;
    const csg::Box& box = model->geometry.leaves[leaf].box;
    const glm::dvec3 reach = (box.hi - box.lo) / 3.0;
    std::vector<bench::Time> edits, all;
    for (int i = 0; i <= frames + 1; ++i) {
        const double angle = 0.1 * (i + 1);
        const bench::Time start = bench::now();
        const ui::Model& held = sectioned.cut(
            model, {},
            {model->scene.leaves[leaf].occurrence, {reach.x * std::cos(angle), reach.y * std::sin(angle), 0}});
        if (!sectioned.change().empty()) {
            renderer.update(held, sectioned.change());
        }
        const bench::Time edited = bench::now();
        renderer.draw_sample(held, request, 0);
        (void)renderer.image();
        if (i > 1) {  // The first make what the others profit from.
            edits.push_back(edited - start);
            all.push_back(bench::now() - start);
        }
    }
    return {middle(edits), middle(all)};
}

/// A number of a translate() changes, and that is undone: from the key to the picture. Zero where there is none.
bench::Time undo(Window& window, const Program& program, const ui::PictureRequest& request, ui::Renderer& renderer) {
    std::size_t digit = program.text.find("translate([", program.text.size() / 2);
    digit = digit == std::string::npos ? program.text.find("translate([") : digit;
    digit = digit == std::string::npos ? digit : program.text.find_first_of(",]", digit) - 1;
    if (digit >= program.text.size() || std::isdigit(static_cast<unsigned char>(program.text[digit])) == 0) {
        return {};
    }
    const auto other = static_cast<char>(program.text[digit] ^ 1);
    ui::TextDocument document(program.text);
    std::vector<bench::Time> times;
    for (int i = 0; i < 5; ++i) {
        document.edit({{{digit, digit + 1}, std::string(1, other)}}, "move");
        (void)window.take(document.text());
        const bench::Time start = bench::now();
        (void)document.undo();
        const auto& model = window.take(document.text());
        renderer.draw_sample(*model, request, 0);
        (void)renderer.image();
        times.push_back(bench::now() - start);
    }
    return middle(times);
}

void measure(const Program& program, const std::vector<std::string>& styles, glm::ivec2 size, int frames) {
    Window window(program);
    const std::shared_ptr<const ui::Model> model = window.take(program.text);
    const auto leaf = static_cast<csg::LeafId>(model->scene.leaves.size() / 2);
    ui::Renderer renderer(nullptr, ui::Painter::Cpu);
    ui::PictureRequest request;
    request.size = size;
    request.samples = 1;
    request.camera = ui::choose_camera({}, window.view(), model->geometry.box);
    const bench::Time undone = undo(window, program, request, renderer);
    for (const std::string& style : styles) {
        request.draw_as(*npr::find_style(style));
        const Drag whole = drag(model, leaf, request, renderer, frames);
        request.size = (size + 1) / 2;
        const Drag half = drag(model, leaf, request, renderer, frames);
        request.size = size;
        fmt::print(
            "| {} | {} | {} | {:.1f} | {:.1f} ({:.1f}) | {:.0f} | {:.1f} ({:.1f}) | {:.0f} | {:.0f} ({:.0f}) |\n",
            program.name, model->scene.leaves.size(), style, whole.edit.wall, whole.frame.wall, whole.frame.cpu,
            1000 / whole.frame.wall, half.frame.wall, half.frame.cpu, 1000 / half.frame.wall, undone.wall, undone.cpu);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> holes{500, 3000}, size{800, 600};
    std::vector<std::string> styles, files;
    std::string named;
    int frames = 15;
    CLI::App app{"Drags a leaf of a plate with holes, and of programs, in every style."};
    app.add_option("--holes", holes, "Of the plates; 0: none");
    app.add_option("--size", size, "Of the picture, in pixels")->delimiter(',')->expected(2);
    app.add_option("--frames", frames)->check(CLI::PositiveNumber);
    app.add_option("--styles", named, "Their names, with commas between; all unless something is said");
    app.add_option("FILE", files)->check(CLI::ExistingFile);
    CLI11_PARSE(app, argc, argv);
    std::istringstream names(named);
    for (std::string name; std::getline(names, name, ',');) {
        styles.push_back(name);
    }
    if (styles.empty()) {
        for (const npr::StyleInfo& style : npr::styles()) {
            styles.emplace_back(style.name);
        }
    }
    for (const std::string& style : styles) {
        if (npr::find_style(style) == nullptr) {
            std::cerr << "error: there is no style " << style << '\n';
            return 2;
        }
    }
    fmt::print(
        "| model | leaves | style | edit, ms | picture, ms (CPU) | pictures/s | half, ms (CPU) | pictures/s | undo, ms "
        "(CPU) |\n| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
    try {
        for (const int count : holes) {
            if (count > 0) {
                measure(plate(count), styles, {size[0], size[1]}, frames);
            }
        }
        for (const std::string& file : files) {
            measure(from_file(file), styles, {size[0], size[1]}, frames);
        }
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
