#include "csg/scad/text/ast_text.h"

#include "csg/scad/customizer/annotations.h"
#include "csg/scad/text/expression_writer.h"
#include "csg/scad/value/quoted.h"

namespace csg::scad {
namespace {

class AstWriter {
  public:
    explicit AstWriter(const Program& program) : p_(program), expressions_(program, out_) {}

    std::string text(BlockId block) {
        annotations_ = annotations(p_);
        contents(block, 0);
        return std::move(out_);
    }

  private:
    void indent(int level) { out_.append(static_cast<std::size_t>(level), '\t'); }

    void contents(BlockId id, int level) {
        const Block& block = p_.blocks[id];
        for (const FunctionDefinition& f : p_.functions_of(block)) {
            function(f, level);
        }
        for (const ModuleDefinition& m : p_.modules_of(block)) {
            module(m, level);
        }
        const auto assignments = p_.assignments_of(block);
        for (std::size_t i = 0; i < assignments.size(); ++i) {
            if (id == p_.units[0].block && annotations_[i]) {
                annotation(*annotations_[i]);
            }
            assignment(assignments[i], level);
        }
        for (const Instantiation& i : p_.instantiations_of(block)) {
            instantiation(i, level, level);
        }
    }

    void annotation(const Annotation& a) {
        if (a.group) {
            out_ += "//Group(" + quoted(*a.group) + ")\n";
        }
        if (!a.description.empty()) {
            out_ += "//Description(" + quoted(a.description) + ")\n";
        }
        out_ += "//Parameter(" + comment_value_text(a.form) + ")\n";
    }

    void function(const FunctionDefinition& f, int level) {
        indent(level);
        out_ += "function " + p_.symbols.text(f.name) + '(';
        expressions_.arguments(p_.parameters_of(f));
        out_ += ") = ";
        expressions_.expression(f.body);
        out_ += ";\n";
    }

    void module(const ModuleDefinition& m, int level) {
        indent(level);
        out_ += "module " + p_.symbols.text(m.name) + '(';
        expressions_.arguments(p_.parameters_of(m));
        out_ += ") {\n";
        contents(m.body, level + 1);
        indent(level);
        out_ += "}\n";
    }

    void assignment(const Argument& a, int level) {
        indent(level);
        out_ += p_.symbols.text(a.name) + " = ";
        expressions_.expression(a.value);
        out_ += ";\n";
    }

    /// `level` is that of the line; `first` is what the line still needs: 0 behind a parent on the same line.
    void instantiation(const Instantiation& first, int level, int lead) {
        if (first.modifiers.disabled) {
            return;
        }
        for (const Instantiation* i = &first; i != nullptr;) {
            indent(lead);
            out_ += p_.symbols.text(i->name) + '(';
            expressions_.arguments(p_.arguments_of(*i));
            out_ += ')';
            children(i->children, level);
            if (i->otherwise == kNone) {
                return;
            }
            indent(level);
            out_ += "else";
            const Block& block = p_.blocks[i->otherwise];
            if (!p_.is_else_if(block)) {
                children(i->otherwise, level);
                return;
            }
            out_ += ' ';
            i = &p_.instantiations_of(block)[0];
            lead = 0;
        }
    }

    [[nodiscard]] std::size_t statements(const Block& block) const {
        std::size_t count = block.assignments.count + block.functions.count + block.modules.count;
        for (const Instantiation& i : p_.instantiations_of(block)) {
            count += i.modifiers.disabled ? 0 : 1;
        }
        return count;
    }

    void children(BlockId id, int level) {
        const Block& block = p_.blocks[id];
        switch (statements(block)) {
            case 0:
                out_ += ";\n";
                return;
            case 1:
                out_ += ' ';
                for (const Argument& a : p_.assignments_of(block)) {
                    assignment(a, 0);
                }
                for (const Instantiation& i : p_.instantiations_of(block)) {
                    instantiation(i, level, 0);
                }
                return;
            default:
                out_ += " {\n";
                contents(id, level + 1);
                indent(level);
                out_ += "}\n";
        }
    }

    const Program& p_;
    std::string out_;
    ExpressionWriter expressions_;
    std::vector<std::optional<Annotation>> annotations_;  ///< Of the main file's assignments.
};

}  // namespace

std::string ast_text(const Program& program) {
    const BlockId block = program.units.empty() ? kNone : program.units[0].block;
    return block == kNone ? std::string() : AstWriter(program).text(block);
}

}  // namespace csg::scad
