#include "csg/scad/customizer/annotations.h"

#include <algorithm>

#include "csg/scad/syntax/parser.h"

namespace csg::scad {
namespace {

struct Group {
    std::uint32_t line = 0;
    std::string name;
};

struct Comments {
    std::vector<Group> groups;  ///< In the order of lines.
    std::uint32_t end = ~0U;    ///< The line of the first brace: parameters stand above it.
};

/// "[a] [b]" is "a-b"; a comment without brackets names the empty group.
std::string group_name(std::string_view comment) {
    std::string name;
    bool first = true;
    for (std::size_t open = comment.find('['); open != std::string_view::npos; open = comment.find('[', open)) {
        const std::size_t close = comment.find(']', open);
        if (close == std::string_view::npos) {
            break;
        }
        name += first ? "" : "-";
        name += comment.substr(open + 1, close - open - 1);
        first = false;
        open = close;
    }
    return name;
}

/// Walks over the text once. Braces in strings count, as in OpenSCAD.
class CommentScanner {
  public:
    explicit CommentScanner(const SourceFile& file) : text_(file.text()) {}

    Comments scan() {
        while (at_ < text_.size()) {
            const std::string_view rest = text_.substr(at_);
            if (rest.starts_with("//")) {
                line_comment();
            } else if (rest.starts_with("/*")) {
                block_comment();
            } else if (rest[0] == '"') {
                string();
            } else {
                step();
            }
        }
        return std::move(found_);
    }

  private:
    void step() {
        const char c = text_[at_++];
        if (c == '{') {
            found_.end = std::min(found_.end, line_);
        }
        line_ += c == '\n' || (c == '\r' && (at_ == text_.size() || text_[at_] != '\n')) ? 1 : 0;
    }

    void string() {
        step();
        while (at_ < text_.size() && text_[at_] != '"') {
            at_ += text_[at_] == '\\' && at_ + 1 < text_.size() ? 1 : 0;
            step();
        }
        at_ += at_ < text_.size() ? 1 : 0;
    }

    void line_comment() {
        const std::uint32_t brace = found_.end;
        while (at_ < text_.size() && text_[at_] != '\n') {
            step();
        }
        found_.end = brace;
    }

    void block_comment() {
        const std::size_t close = text_.find("*/", at_ + 2);
        const std::size_t end = close == std::string_view::npos ? text_.size() : close;
        const std::string_view comment = text_.substr(at_ + 2, end - std::min(at_ + 2, end));
        if (comment.find_first_of("\r\n") == std::string_view::npos) {
            found_.groups.push_back({line_, group_name(comment)});
        }
        const std::uint32_t brace = found_.end;
        while (at_ < end) {
            step();
        }
        found_.end = brace;
        at_ = std::min(end + 2, text_.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::uint32_t line_ = 1;
    Comments found_;
};

/// The comment above a parameter, with what introduces comments inside it blanked.
std::string description(std::string_view line) {
    if (!line.starts_with("//")) {
        return {};
    }
    line.remove_prefix(2);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool slashes = line.substr(i).starts_with("//");
        text += slashes ? ' ' : line[i];
        i += slashes ? 1 : 0;
    }
    return text;
}

/// What stands after `//` behind the only statement of a line.
std::string_view comment_behind(std::string_view line) {
    int semicolons = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') {
            for (++i; i < line.size() && line[i] != '"'; ++i) {
                i += line[i] == '\\' ? 1 : 0;
            }
        } else if (line[i] == ';') {
            ++semicolons;
        } else if (line.substr(i).starts_with("//")) {
            return semicolons < 2 ? line.substr(i + 2) : std::string_view();
        }
    }
    return {};
}

}  // namespace

bool is_literal(const Program& program, ExprId id) {
    std::vector<ExprId> left{id};
    while (!left.empty()) {
        const Expr& e = program[left.back()];
        left.pop_back();
        switch (e.kind) {
            case ExprKind::Undef:
            case ExprKind::Boolean:
            case ExprKind::Number:
            case ExprKind::String:
                break;
            case ExprKind::Vector:
                left.insert(left.end(), program.elements_of(e).begin(), program.elements_of(e).end());
                break;
            case ExprKind::Range:
            case ExprKind::Unary:
                std::copy_if(e.operands.begin(), e.operands.end(), std::back_inserter(left),
                             [](ExprId operand) { return operand != kNone; });
                break;
            default:
                return false;
        }
    }
    return true;
}

std::vector<std::optional<Annotation>> annotations(const Program& program) {
    const Unit& main = program.units[0];
    const auto assignments = program.assignments_of(program.blocks[main.block]);
    const SourceFile& file = program.sources[main.file];
    const Comments comments = CommentScanner(file).scan();
    std::vector<std::optional<Annotation>> result;
    for (const Argument& a : assignments) {
        result.emplace_back();
        // A definition takes the place of what the file says, comments included.
        const auto place = program.first_places.find(static_cast<std::uint32_t>(&a - program.assignments.data()));
        const bool outside =
            program.sources[a.where.file].name() == kCommandLine && place != program.first_places.end();
        const SourceRange& where = outside ? place->second : a.where;
        const std::uint32_t line = where.line;
        if (where.file != main.file || line >= comments.end || !is_literal(program, a.value)) {
            continue;
        }
        Annotation& annotation = result.back().emplace();
        const auto below = std::partition_point(comments.groups.begin(), comments.groups.end(),
                                                [&](const Group& group) { return group.line < line; });
        if (below != comments.groups.begin()) {
            annotation.group = std::prev(below)->name;
        }
        annotation.description = description(file.line(line - 1));
        annotation.form = parse_parameter_comment(comment_behind(file.line(line)));
    }
    return result;
}

}  // namespace csg::scad
