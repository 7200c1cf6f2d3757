#include "ui/pipeline/inspection/finding_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ui {

namespace {

const char* unit(const Finding& finding) {
    const bool volume = finding.kind == FindingKind::Size && !finding.direction;
    return finding.kind == FindingKind::Overhang ? "°" : volume ? " mm³" : " mm";
}

std::string six_digits(double value) {
    return fmt::format("{:.6g}", std::abs(value) < 1e-9 ? 0.0 : value);
}

}  // namespace

const FindingKindInfo& info(FindingKind kind) {
    return *std::find_if(finding_kinds().begin(), finding_kinds().end(),
                         [&](const FindingKindInfo& each) { return each.kind == kind; });
}

std::string headline(const Model& model, const Finding& finding) {
    std::string text = info(finding.kind).headline;
    if (!finding.text.empty()) {
        text += ": " + finding.text;
    }
    if (finding.value) {
        text += fmt::format(", {}{}", six_digits(*finding.value), unit(finding));
        if (finding.error > 1e-6 * std::abs(*finding.value)) {
            text += fmt::format(" (the worst may be {:.2g} {})", finding.error,
                                finding.kind == FindingKind::Size           ? "off"
                                : finding.kind == FindingKind::Interference ? "more"
                                                                            : "less");
        }
    }
    if (finding.limit && finding.kind != FindingKind::Interference) {
        text += fmt::format(", limit {}", six_digits(*finding.limit));
    }
    if (finding.part && finding.other_part && finding.part != finding.other_part) {
        const auto& parts = model.scene.parts;
        text += fmt::format(", {} and {}", parts[*finding.part].name, parts[*finding.other_part].name);
    }
    return text;
}

std::string point_text(const glm::dvec3& p) {
    return fmt::format("[{}, {}, {}]", six_digits(p.x), six_digits(p.y), six_digits(p.z));
}

}  // namespace ui
