#include "ui/command_line/export_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "csg/scad/builtin/color_names.h"
#include "ui/command_line/options.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

/// What an option takes, for people, and how it is taken; false where the value does not fit.
struct Value {
    std::string expected;
    std::function<bool(ExportOptions&, const std::string&)> take;
};

struct Entry {
    std::string section, key, otherwise;
    Value value;
};

template <typename Place>
Value boolean(Place place) {
    return {"true or false", [place](ExportOptions& o, const std::string& text) {
                const bool yes = text == "true" || text == "1";
                place(o) = yes;
                return yes || text == "false" || text == "0";
            }};
}

template <typename Number, typename Place>
Value number(Number lowest, Number highest, Place place) {
    return {fmt::format("{} to {}", lowest, highest), [=](ExportOptions& o, const std::string& text) {
                Number value{};
                const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
                place(o) = value;
                return error == std::errc{} && end == text.data() + text.size() && value >= lowest && value <= highest;
            }};
}

template <typename Place>
Value text(Place place) {
    return {"any text", [place](ExportOptions& o, const std::string& value) {
                place(o) = value;
                return true;
            }};
}

/// `as`: makes what is stored of the color's components, 0 to 1.
template <typename Place, typename As>
Value color(Place place, As as) {
    return {"a CSS name or #rrggbb", [place, as](ExportOptions& o, const std::string& value) {
                const auto found = csg::scad::find_color(value);
                if (found) {
                    place(o) = as(*found);
                }
                return found.has_value();
            }};
}

csg::solid::Rgb8 to_bytes(const csg::Rgba& color) {
    const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(255 * c)); };
    return {byte(color.r), byte(color.g), byte(color.b)};
}

template <typename Type, typename Place>
Value choice(std::vector<std::pair<std::string, Type>> values, Place place) {
    std::vector<std::string> names;
    for (const auto& value : values) {
        names.push_back(value.first);
    }
    return {fmt::format("{}", fmt::join(names, ", ")),
            [values = std::move(values), place](ExportOptions& o, const std::string& name) {
                const auto at =
                    std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
                if (at != values.end()) {
                    place(o) = at->second;
                }
                return at != values.end();
            }};
}

template <typename Place>
void add_paint(std::vector<Entry>& entries, const std::string& section, const csg::solid::Paint& otherwise,
               Place paint) {
    const auto css = [](const csg::solid::Rgb8& c) { return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]); };
    const auto yes = [](bool value) { return std::string(value ? "true" : "false"); };
    entries.push_back({section, "fill", yes(otherwise.fill), boolean([=](auto& o) -> bool& { return paint(o).fill; })});
    entries.push_back({section, "fill-color", css(otherwise.fill_color),
                       color(
                           [=](auto& o) -> auto& { return paint(o).fill_color; }, to_bytes)});
    entries.push_back(
        {section, "stroke", yes(otherwise.stroke), boolean([=](auto& o) -> bool& { return paint(o).stroke; })});
    entries.push_back({section, "stroke-color", css(otherwise.stroke_color),
                       color(
                           [=](auto& o) -> auto& { return paint(o).stroke_color; }, to_bytes)});
    entries.push_back({section, "stroke-width", fmt::format("{}", otherwise.stroke_width),
                       number(0.01, 999.0, [=](auto& o) -> double& { return paint(o).stroke_width; })});
}

void add_pdf(std::vector<Entry>& entries, const ExportOptions& otherwise) {
    using csg::solid::PageTurn;
    const std::string section = "export-pdf";
    const auto add = [&](const char* key, const char* value, Value how) {
        entries.push_back({section, key, value, std::move(how)});
    };
    const auto millimeters = [](double x, double y) { return glm::dvec2(x, y); };
    add("paper-size", "a4",
        choice<glm::dvec2>(
            {{"a6", millimeters(105, 148)},
             {"a5", millimeters(148, 210)},
             {"a4", millimeters(210, 297)},
             {"a3", millimeters(297, 420)},
             {"letter", millimeters(215.9, 279.4)},
             {"legal", millimeters(215.9, 355.6)},
             {"tabloid", millimeters(279.4, 431.8)}},
            [](auto& o) -> auto& { return o.pdf.paper; }));
    add("orientation", "portrait",
        choice<PageTurn>(
            {{"portrait", PageTurn::Portrait}, {"landscape", PageTurn::Landscape}, {"auto", PageTurn::Auto}},
            [](auto& o) -> auto& { return o.pdf.turn; }));
    add("show-filename", "false", boolean([](auto& o) -> bool& { return o.pdf_file_name; }));
    add("show-scale", "true", boolean([](auto& o) -> bool& { return o.pdf.scale; }));
    add("show-scale-message", "true", boolean([](auto& o) -> bool& { return o.pdf.scale_message; }));
    add("show-grid", "false", boolean([](auto& o) -> bool& { return o.pdf.grid; }));
    add("grid-size", "10", number(1.0, 100.0, [](auto& o) -> double& { return o.pdf.grid_size; }));
    add("add-meta-data", "true", boolean([](auto& o) -> bool& { return o.pdf_meta_data; }));
    add("meta-data-title", "", text([](auto& o) -> auto& { return o.pdf.title; }));
    add("meta-data-author", "", text([](auto& o) -> auto& { return o.pdf.author; }));
    add("meta-data-subject", "", text([](auto& o) -> auto& { return o.pdf.subject; }));
    add("meta-data-keywords", "", text([](auto& o) -> auto& { return o.pdf.keywords; }));
    add_paint(
        entries, section, otherwise.pdf.paint, [](auto& o) -> auto& { return o.pdf.paint; });
}

void add_three_mf(std::vector<Entry>& entries) {
    using csg::reference::ThreeMfColors;
    const auto add = [&](const char* key, const char* value, Value how) {
        entries.push_back({"export-3mf", key, value, std::move(how)});
    };
    add("unit", "millimeter",
        choice<std::string>(
            {{"micron", "micron"},
             {"millimeter", "millimeter"},
             {"centimeter", "centimeter"},
             {"meter", "meter"},
             {"inch", "inch"},
             {"foot", "foot"}},
            [](auto& o) -> auto& { return o.three_mf.unit; }));
    add("color-mode", "model",
        choice<ThreeMfColors>(
            {{"model", ThreeMfColors::Model},
             {"none", ThreeMfColors::None},
             {"selected-only", ThreeMfColors::Selected}},
            [](auto& o) -> auto& { return o.three_mf.colors; }));
    add("color", "#f9d72c",
        color(
            [](auto& o) -> auto& { return o.three_mf.selected; },
            [](const csg::Rgba& c) {
                return std::array{c.r, c.g, c.b, c.a};
            }));
    add("material-type", "basematerial", choice<bool>({{"basematerial", false}, {"color", true}}, [](auto& o) -> bool& {
            return o.three_mf.color_group;
        }));
    add("decimal-precision", "all digits", number(1, 16, [](auto& o) -> int& { return o.three_mf.decimals; }));
    add("add-meta-data", "true", boolean([](auto& o) -> bool& { return o.three_mf_meta_data; }));
    for (const auto& [key, name] :
         {std::pair("meta-data-title", "Title"), std::pair("meta-data-designer", "Designer"),
          std::pair("meta-data-description", "Description"), std::pair("meta-data-copyright", "Copyright"),
          std::pair("meta-data-license-terms", "LicenseTerms"), std::pair("meta-data-rating", "Rating")}) {
        add(key, "", text([name = std::string(name)](auto& o) -> auto& { return o.three_mf.meta_data[name]; }));
    }
}

std::vector<Entry> make_entries() {
    const ExportOptions otherwise;
    std::vector<Entry> entries;
    add_three_mf(entries);
    add_pdf(entries, otherwise);
    add_paint(
        entries, "export-svg", otherwise.svg, [](auto& o) -> auto& { return o.svg; });
    return entries;
}

const Entry& find_entry(const std::vector<Entry>& entries, const std::string& name) {
    std::vector<std::string> names;
    for (const Entry& entry : entries) {
        names.push_back(entry.section + '/' + entry.key);
        if (names.back() == name) {
            return entry;
        }
    }
    throw UsageError(fmt::format("-O {}: there is no such option.{}", name,
                                 suggestion(name, names, " See csgscope --help-export.")));
}

}  // namespace

ExportOptions read_export_options(const std::vector<std::string>& assignments) {
    ExportOptions options;
    const std::vector<Entry> entries = make_entries();
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos) {
            throw UsageError(fmt::format("-O {}: expected section/key=value", assignment));
        }
        const Entry& entry = find_entry(entries, assignment.substr(0, equals));
        if (!entry.value.take(options, assignment.substr(equals + 1))) {
            throw UsageError(fmt::format("-O {}: expected {}", assignment, entry.value.expected));
        }
    }
    return options;
}

std::string export_options_help() {
    std::string out = "Options of file formats, as in  csgscope -O export-pdf/paper-size=a5 -o x.pdf x.scad\n";
    std::string section;
    for (const Entry& entry : make_entries()) {
        if (entry.section != section) {
            section = entry.section;
            out += fmt::format("\n{}\n", section);
        }
        out += fmt::format("  {:<24}{} ({})\n", entry.key, entry.value.expected,
                           entry.otherwise.empty() ? "none" : entry.otherwise);
    }
    return out;
}

}  // namespace ui
