#include "ui/command_line/compare_table.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

/// Members by their way down; null where one of them is missing.
const Json& at(const Json& json, std::initializer_list<std::string_view> way) {
    static const Json none;
    const Json* found = &json;
    for (const std::string_view name : way) {
        found = found->find(name);
        if (found == nullptr) {
            return none;
        }
    }
    return *found;
}

std::string word(const Json& value) {
    return value.text() != nullptr ? *value.text() : value.dump();
}

/// A share of pixels: of a million, where it is small.
std::string share(const Json& value) {
    const double part = value.fraction();
    return part == 0 ? "0" : part < 1e-4 ? fmt::format("{:.3g} ppm", 1e6 * part) : fmt::format("{:.3g} %", 100 * part);
}

/// The name of a figure in words: "coverage_error" is "coverage error".
std::string label(std::string_view name) {
    std::string text(name);
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

std::string figure(std::string_view name, const Json& value) {
    return name.ends_with("_error") ? share(value) : short_number(value);
}

std::string volume_text(const Json& found) {
    const Json& volume = at(found, {"volume"});
    std::string text = fmt::format("volume of the mesh {:.6g}", at(found, {"mesh", "volume"}).fraction());
    if (!volume.is_null()) {
        text += fmt::format(", by the picture {:.6g} ± {:.2g}: {}", at(volume, {"picture"}).fraction(),
                            at(volume, {"uncertainty"}).fraction(),
                            at(volume, {"agrees"}).truth() ? "they agree" : "THEY DIFFER");
    }
    return text + "\n";
}

std::string openscad_text(const Json& openscad) {
    std::string text =
        fmt::format("openscad: its tree {}; its volume {:.6g}, ours {:.6g}: {}\n",
                    at(openscad, {"tree_agrees"}).truth() ? "is ours" : "DIFFERS",
                    at(openscad, {"volume", "openscad"}).fraction(), at(openscad, {"volume", "csgscope"}).fraction(),
                    at(openscad, {"volume", "agrees"}).truth() ? "they agree" : "THEY DIFFER");
    const Json& coverage = at(openscad, {"picture", "coverage_error"});
    text += coverage.is_fraction() ? fmt::format("openscad's picture covers others in {}\n", share(coverage))
                                   : "openscad gave no picture: it needs a display\n";
    return text;
}

std::string verdict(const Json& found, const char* within, const char* limit) {
    const std::string bound = share(at(found, {limit}));
    return at(found, {within}).truth() ? fmt::format("within the tolerance of {}", bound)
                                       : fmt::format("BEYOND the tolerance of {}", bound);
}

}  // namespace

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widest;
    for (const auto& row : rows) {
        widest.resize(std::max(widest.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) {
            widest[i] = std::max(widest[i], character_count(row[i]));
        }
    }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widest[i] - character_count(row[i]), ' ');
            text += i == 0 ? row[i] + (row.size() > 1 ? blanks : "") : "  " + blanks + row[i];
        }
        text += '\n';
    }
    return text;
}

std::string short_number(const Json& value) {
    return value.is_fraction() ? fmt::format("{:.3g}", value.fraction()) : value.dump();
}

std::string compare_table(const Json& found) {
    const Json& size = at(found, {"size"});
    std::string text = fmt::format(
        "{} against {}: {}\n{}, {} {}, {} views of {} × {} pixels; the mesh has {} triangles\n\n",
        word(at(found, {"model"})), word(at(found, {"against"})), verdict(found, "within_tolerance", "tolerance"),
        word(at(found, {"engine"})), at(found, {"layers"}).text() != nullptr ? "all" : "the first",
        at(found, {"layers"}).text() != nullptr ? "layers" : short_number(at(found, {"layers"})),
        short_number(at(found, {"views"})), short_number(size.items()[0]), short_number(size.items()[1]),
        short_number(at(found, {"mesh", "triangles"})));
    std::vector<std::vector<std::string>> rows{{"", "all pixels", "without the band"}};
    const Json& all = at(found, {"all"});
    for (const auto& [name, value] : all.members()) {
        if (name != "layers") {
            rows.push_back({label(name), figure(name, value), figure(name, at(found, {"without_band", name}))});
        }
    }
    text += aligned(rows);
    const auto& layers = at(all, {"layers"}).items();
    if (!layers.empty()) {
        rows.assign(1, {"layer, all pixels"});
        for (const auto& [name, value] : layers[0].members()) {
            rows[0].push_back(label(name));
        }
        for (std::size_t i = 0; i < layers.size(); ++i) {
            rows.push_back({fmt::format("{}", i + 1)});
            for (const auto& [name, value] : layers[i].members()) {
                rows.back().push_back(figure(name, value));
            }
        }
        text += '\n' + aligned(rows);
    }
    text += '\n' + volume_text(found);
    const Json& openscad = at(found, {"openscad"});
    return openscad.is_null() ? text : text + openscad_text(openscad);
}

std::string compare_picture_text(const Json& found) {
    return fmt::format("{} against {}: {} of the pixels differ, {}\n", word(at(found, {"model"})),
                       word(at(found, {"reference"})), share(at(found, {"pixels_that_differ"})),
                       verdict(found, "within_threshold", "threshold"));
}

}  // namespace ui
