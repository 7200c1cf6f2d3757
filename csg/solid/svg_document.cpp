#include "csg/solid/svg_document.h"

#include <algorithm>

namespace csg::solid {
namespace {

constexpr std::string_view kBlank = " \t\r\n\f";
constexpr std::size_t kMostRules = std::size_t{1} << 12;

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
    text.remove_suffix(text.size() - (text.find_last_not_of(kBlank) + 1));
    return text;
}

/// Up to the separator, which is taken off `rest`, too.
std::string_view cut(std::string_view& rest, char separator) {
    const std::size_t end = std::min(rest.find(separator), rest.size());
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return trimmed(part);
}

std::string without_comments(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t begin = std::min(text.find("/*"), text.size());
        result += text.substr(0, begin);
        const std::size_t end = text.find("*/", begin);
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 2);
    }
    return result;
}

}  // namespace

bool SvgDocument::Rule::matches(const SvgElement& element) const {
    if ((!tag.empty() && tag != element.name) || (!id.empty() && id != attribute(element.attributes, "id"))) {
        return false;
    }
    if (class_name.empty()) {
        return true;
    }
    std::string_view classes = trimmed(attribute(element.attributes, "class"));
    while (!classes.empty()) {
        if (cut(classes, ' ') == class_name) {
            return true;
        }
    }
    return false;
}

SvgDocument::Declarations SvgDocument::read_declarations(std::string_view text) {
    Declarations declarations;
    while (!text.empty()) {
        std::string_view declaration = cut(text, ';');
        const std::string_view name = cut(declaration, ':');
        std::string_view value = trimmed(declaration);
        if (const std::size_t important = value.find('!'); important != std::string_view::npos) {
            value = trimmed(value.substr(0, important));
        }
        if (!name.empty() && !value.empty()) {
            declarations.insert_or_assign(std::string(name), std::string(value));
        }
    }
    return declarations;
}

void SvgDocument::read_style_sheet(std::string_view text) {
    const std::string bare = without_comments(text);
    std::string_view rest = bare;
    while (!rest.empty() && rules_.size() < kMostRules) {
        std::string_view selectors = cut(rest, '{');
        const Declarations declarations = read_declarations(cut(rest, '}'));
        while (!selectors.empty() && !declarations.empty()) {
            const std::string_view selector = cut(selectors, ',');
            const std::size_t mark = std::min(selector.find_first_of(".#"), selector.size());
            // Selectors of other kinds, such as "a > b" or "@media", name what nothing matches.
            Rule rule;
            rule.tag = selector.substr(0, mark);
            if (rule.tag == "*") {
                rule.tag.clear();
            }
            if (mark < selector.size()) {
                (selector[mark] == '.' ? rule.class_name : rule.id) = selector.substr(mark + 1);
            }
            rule.declarations = declarations;
            if (!selector.empty()) {
                rules_.push_back(std::move(rule));
            }
        }
    }
}

SvgDocument::SvgDocument(std::string_view text, std::vector<std::string>& failures) {
    std::vector<std::size_t> open;
    XmlEvents events;
    events.open = [&](const std::string& name, const Attributes& attributes) {
        const std::size_t index = elements_.size();
        if (!open.empty()) {
            elements_[open.back()].children.push_back(index);
        }
        open.push_back(index);
        elements_.push_back({name, attributes, {}});
        if (const std::string_view id = attribute(attributes, "id"); !id.empty()) {
            by_id_.emplace(id, index);
        }
    };
    events.close = [&](const std::string& name, const std::string& content) {
        if (name == "style") {
            read_style_sheet(content);
        }
        open.pop_back();
    };
    read_xml(text, events, failures);
    std::reverse(rules_.begin(), rules_.end());
    std::stable_sort(rules_.begin(), rules_.end(),
                     [](const Rule& a, const Rule& b) { return a.specificity() > b.specificity(); });
}

const SvgElement* SvgDocument::find(std::string_view id) const {
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? nullptr : &elements_[found->second];
}

std::string_view SvgDocument::property(const SvgElement& element, std::string_view name) const {
    // The last declaration of the attribute counts.
    std::string_view style = attribute(element.attributes, "style"), own;
    while (!style.empty()) {
        std::string_view declaration = cut(style, ';');
        if (cut(declaration, ':') == name) {
            own = trimmed(declaration);
        }
    }
    if (!own.empty()) {
        return own;
    }
    for (const Rule& rule : rules_) {
        const auto found = rule.declarations.find(name);
        if (found != rule.declarations.end() && rule.matches(element)) {
            return found->second;
        }
    }
    return attribute(element.attributes, name);
}

}  // namespace csg::solid
