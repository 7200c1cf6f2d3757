#include "ui/command_line/compare_report.h"

#include <fmt/format.h>

#include "ui/command_line/compare_table.h"
#include "ui/command_line/html.h"

namespace ui {

namespace {

/// Rows of the layers, all pixels; none where a picture was compared with a picture.
std::string layer_table(const ComparedView& view) {
    const Json* layers = view.all.find("layers");
    if (layers == nullptr || layers->items().empty()) {
        return "";
    }
    std::string rows =
        "</table>\n<table><tr><th>layer</th><th>pixels</th><th>coverage error</th><th>normal error</th><th>orientation "
        "error</th>"
        "<th>depth, RMS</th><th>depth, largest</th></tr>\n";
    std::size_t number = 0;
    for (const Json& layer : layers->items()) {
        rows += fmt::format("<tr><td>{}</td>", ++number);
        for (const auto& [name, value] : layer.members()) {
            rows += fmt::format("<td>{}</td>", short_number(value));
        }
        rows += "</tr>\n";
    }
    return rows;
}

constexpr const char* kReportHead = R"(<style>
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 70em; color: #222; }
.view { display: flex; gap: 1em; flex-wrap: wrap; align-items: start; margin-bottom: 2em; }
.pair { position: relative; display: inline-block; line-height: 0; }
.pair .top { position: absolute; left: 0; top: 0; overflow: hidden; width: 50%; border-right: 1px solid #c00; }
.pair .top img, .pair img { max-width: none; }
figure { margin: 0; } figcaption { font-size: 13px; color: #666; line-height: 1.6; }
table { border-collapse: collapse; } td, th { padding: .2em .8em; border-bottom: 1px solid #ddd; text-align: right; }
td:first-child, th:first-child { text-align: left; }
</style>
<script>
function slide(input) { input.closest('figure').querySelector('.top').style.width = input.value + '%'; }
</script>
)";

}  // namespace

std::string report_page(const std::string& title, const std::string& summary, const std::vector<ComparedView>& views) {
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n{1}</head><body>\n"
        "<h1>{0}</h1>\n<p>{2}</p>\n",
        html(title), kReportHead, html(summary));
    for (const ComparedView& view : views) {
        page += fmt::format(
            "<h2>{}</h2>\n<div class=\"view\">\n<figure><div class=\"pair\">{}<div class=\"top\">{}</div></div>"
            "<br><input type=\"range\" aria-label=\"picture or mesh\" value=\"50\" oninput=\"slide(this)\">"
            "<figcaption>left of the line the picture, right of it the reference</figcaption></figure>\n"
            "<figure>{}<figcaption>the picture</figcaption></figure>\n"
            "<figure>{}<figcaption>the reference</figcaption></figure>\n"
            "<figure>{}<figcaption>gray: agrees; blue: differs within the band; red: outside it; the darker, the more "
            "layers"
            "</figcaption></figure>\n<table><tr><th></th><th>all pixels</th><th>without the band</th></tr>\n",
            html(view.title), picture(view.expected, "reference"), picture(view.drawn, "picture"),
            picture(view.drawn, "picture"), picture(view.expected, "reference"),
            picture(view.difference, "differences"));
        for (const auto& [name, value] : view.all.members()) {
            const Json* outside = view.outside.find(name);
            if (name != "layers") {
                page += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", html(name), short_number(value),
                                    outside == nullptr || name == "edge_f_score" ? "" : short_number(*outside));
            }
        }
        page += layer_table(view);
        page += "</table></div>\n";
    }
    return page + "</body></html>\n";
}

}  // namespace ui
