// An SVG file as a tree of elements, with the properties that its style sheets give them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "csg/solid/xml.h"

namespace csg::solid {

struct SvgElement {
    std::string name;
    Attributes attributes;
    std::vector<std::size_t> children;  ///< Indices of elements, in document order.
};

class SvgDocument {
  public:
    /// What is wrong with the text is a failure with its line; what came before is there.
    SvgDocument(std::string_view text, std::vector<std::string>& failures);

    [[nodiscard]] bool empty() const { return elements_.empty(); }
    /// The root is element 0.
    [[nodiscard]] const SvgElement& element(std::size_t index) const { return elements_[index]; }
    /// By its id; null where there is none.
    [[nodiscard]] const SvgElement* find(std::string_view id) const;

    /// A property of an element as CSS says: of its style attribute, else of the style sheets' most special rule for it
    /// (selectors are a name, .class, #id, or a name with one of these), else of an attribute. Empty where there is
    /// none; nothing is inherited here.
    [[nodiscard]] std::string_view property(const SvgElement& element, std::string_view name) const;

  private:
    using Declarations = std::map<std::string, std::string, std::less<>>;
    struct Rule {
        std::string tag, id, class_name;
        Declarations declarations;
        [[nodiscard]] int specificity() const {
            return (id.empty() ? 0 : 100) + (class_name.empty() ? 0 : 10) + (tag.empty() ? 0 : 1);
        }
        [[nodiscard]] bool matches(const SvgElement& element) const;
    };
    static Declarations read_declarations(std::string_view text);
    void read_style_sheet(std::string_view text);

    std::vector<SvgElement> elements_;
    std::map<std::string, std::size_t, std::less<>> by_id_;
    std::vector<Rule> rules_;  ///< The most special ones first, of equals the later.
};

}  // namespace csg::solid
