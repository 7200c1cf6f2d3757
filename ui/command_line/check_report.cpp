#include "ui/command_line/check_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ui/command_line/html.h"
#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/inspection/finding_text.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

bool was_asked(FindingKind kind, const CheckRequest& r) {
    switch (kind) {
        case FindingKind::Wall:
            return r.min_wall.has_value();
        case FindingKind::Gap:
            return r.min_gap.has_value();
        case FindingKind::Feature:
            return r.min_feature.has_value();
        case FindingKind::Interference:
            return r.interference.has_value();
        case FindingKind::Clearance:
            return !r.clearances.empty();
        case FindingKind::NoEffect:
            return r.no_effect;
        case FindingKind::Coincident:
            return r.coincident;
        case FindingKind::Overhang:
            return r.max_overhang.has_value();
        case FindingKind::Size:
            return r.max_size || r.min_volume || r.max_volume;
    }
    return false;
}

Json part_json(const CheckReport& report, const std::optional<csg::PartId>& part) {
    return part ? Json(report.model.scene.parts[*part].name) : Json(nullptr);
}

Json calls_json(const CheckReport& report, csg::OccurrenceId occurrence) {
    Json calls = Json::array();
    for (const CallStep& step : steps_to(report.model, occurrence)) {
        calls.push_back(call_json(report.model, report.sources, step));
    }
    return calls;
}

/// The innermost call: where the text is to be changed, more often than not.
std::optional<csg::SourceLocation> place(const CheckReport& report, csg::OccurrenceId occurrence) {
    const std::vector<CallStep> steps = steps_to(report.model, occurrence);
    return steps.empty() ? std::nullopt : std::optional(steps.back().node.where);
}

Json location(const CheckReport& report, const csg::SourceLocation& where) {
    return {{"physicalLocation",
             {{"artifactLocation", {{"uri", report.model.tree->files()[where.file]}}},
              {"region", {{"startLine", where.line}, {"startColumn", where.column}}}}}};
}

std::string counted(const CheckReport& report) {
    const std::size_t count = report.result.findings.size();
    return count == 0 ? "no findings" : count == 1 ? "1 finding" : fmt::format("{} findings", count);
}

}  // namespace

std::string check_text(const CheckReport& report) {
    std::string out;
    for (const Finding& f : report.result.findings) {
        out += fmt::format("{}\n   at {}", headline(report.model, f), point_text(f.point));
        if (f.part) {
            out += fmt::format(", part {}", report.model.scene.parts[*f.part].name);
        }
        if (f.leaf) {
            out += fmt::format(", leaf {}", *f.leaf);
        }
        out += '\n' + calls_text(report.model, report.sources, steps_to(report.model, f.occurrence));
        if (f.other_occurrence != csg::kNoOccurrence && f.other_occurrence != f.occurrence) {
            out += "   and\n" + calls_text(report.model, report.sources, steps_to(report.model, f.other_occurrence));
        }
        out += '\n';
    }
    out += fmt::format("{}: {}", report.input, counted(report));
    if (report.result.samples != 0) {
        out += fmt::format("; faces looked at every {:.3g} mm, so what holds a disc of radius {:.3g} is found",
                           report.result.spacing, report.result.reach);
    }
    return out + '\n';
}

Json check_json(const CheckReport& report) {
    Json findings = Json::array();
    for (const Finding& f : report.result.findings) {
        const auto optional = [](const auto& value) { return value ? Json(*value) : Json(nullptr); };
        findings.push_back({{"kind", info(f.kind).name},
                            {"message", headline(report.model, f)},
                            {"value", optional(f.value)},
                            {"error", f.error},
                            {"limit", optional(f.limit)},
                            {"point", to_json(f.point)},
                            {"direction", f.direction ? to_json(*f.direction) : Json(nullptr)},
                            {"part", part_json(report, f.part)},
                            {"other_part", part_json(report, f.other_part)},
                            {"leaf", optional(f.leaf)},
                            {"other_leaf", optional(f.other_leaf)},
                            {"samples", f.samples},
                            {"calls", calls_json(report, f.occurrence)},
                            {"other_calls", calls_json(report, f.other_occurrence)}});
    }
    return {{"model", report.input},
            {"spacing", report.result.spacing},
            {"reach", report.result.reach},
            {"samples", report.result.samples},
            {"findings", findings}};
}

Json check_sarif(const CheckReport& report) {
    Json rules = Json::array(), results = Json::array();
    for (const FindingKindInfo& kind : finding_kinds()) {
        if (was_asked(kind.kind, report.request)) {
            rules.push_back({{"id", kind.name}, {"shortDescription", {{"text", kind.headline}}}});
        }
    }
    for (const Finding& f : report.result.findings) {
        Json result = {
            {"ruleId", info(f.kind).name},
            {"level", "error"},
            {"message", {{"text", fmt::format("{}, at {}", headline(report.model, f), point_text(f.point))}}}};
        Json locations = Json::array(), related = Json::array();
        if (const auto where = place(report, f.occurrence)) {
            locations.push_back(location(report, *where));
        } else {
            locations.push_back({{"physicalLocation", {{"artifactLocation", {{"uri", report.input}}}}}});
        }
        if (const auto where = place(report, f.other_occurrence)) {
            related.push_back(location(report, *where));
        }
        result["locations"] = locations;
        result["relatedLocations"] = related;
        results.push_back(result);
    }
    const Json driver = {{"name", "csgscope"}, {"version", CSGSCOPE_VERSION}, {"rules", rules}};
    Json runs = Json::array();
    runs.push_back({{"tool", {{"driver", driver}}}, {"results", results}});
    return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}, {"runs", runs}};
}

std::string check_junit(const CheckReport& report) {
    std::string cases;
    std::size_t tests = 0;
    for (const FindingKindInfo& kind : finding_kinds()) {
        if (!was_asked(kind.kind, report.request)) {
            continue;
        }
        std::size_t found = 0;
        const auto add = [&](const std::string& failure) {
            ++tests;
            cases += fmt::format("  <testcase classname=\"{}\" name=\"{}{}\">{}</testcase>\n", attribute(report.input),
                                 kind.name, found > 1 ? fmt::format(" {}", found) : "", failure);
        };
        for (const Finding& f : report.result.findings) {
            if (f.kind == kind.kind) {
                ++found;
                const std::string calls =
                    calls_text(report.model, report.sources, steps_to(report.model, f.occurrence));
                add(fmt::format("\n    <failure message=\"{}\">at {}\n{}</failure>\n  ",
                                attribute(headline(report.model, f)), html(point_text(f.point)), html(calls)));
            }
        }
        if (found == 0) {
            add("");
        }
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"csgscope check\" tests=\"{}\" "
        "failures=\"{}\">\n{}</testsuite>\n",
        tests, report.result.findings.size(), cases);
}

}  // namespace ui
