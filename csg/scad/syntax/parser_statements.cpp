// Statements: assignments, definitions, instantiations.
#include <fmt/format.h>

#include "csg/scad/syntax/parser_impl.h"

namespace csg::scad {

BlockId Parser::unit() {
    BlockBuilder block;
    while (!at(TokenKind::End)) {
        if (at(TokenKind::Piece)) {
            place_piece(block);
        } else if (!accept(TokenKind::Use)) {  // The stream of tokens has taken note of it.
            statement(block, Level::Top);
        }
    }
    return block.finish(program_);
}

void Parser::definitions(std::uint32_t file, const MessageSink& sink, std::vector<Argument>& out) {
    files_ != nullptr ? tokens_.emplace(*files_, file, unit_) : tokens_.emplace(program_, file, sink);
    while (!at(TokenKind::End)) {
        if (!at_assignment()) {
            fail_expected("name=expression as a definition");
        }
        const Token name = take();
        take();
        const ExprId value = expression();
        out.push_back({name.name, value, from(name.where)});
        if (!at(TokenKind::End)) {
            expect_semicolon("the definition");
        }
    }
}

void Parser::statement(BlockBuilder& block, Level level) {
    switch (current().kind) {
        case TokenKind::Semicolon:
            take();
            return;
        case TokenKind::BraceOpen:
            braces(block, level == Level::Child ? Level::Children : level);
            return;
        case TokenKind::Module:
        case TokenKind::Function:
            if (level == Level::Children || level == Level::Child) {
                fail(current().where, fmt::format("a {} cannot be defined inside an instantiation; only a file or "
                                                  "a module can hold definitions",
                                                  token_text(current().kind)));
            }
            at(TokenKind::Module) ? module_definition(block, level) : function_definition(block, level);
            return;
        default:
            break;
    }
    if (level != Level::Child && at_assignment()) {
        assignment(block);
        return;
    }
    switch (current().kind) {
        case TokenKind::Not:
        case TokenKind::Hash:
        case TokenKind::Percent:
        case TokenKind::Star:
        case TokenKind::If:
            block.add(instantiation());
            return;
        default:
            break;
    }
    if (!at_module_name()) {
        fail_statement(level);
    }
    block.add(instantiation());
}

void Parser::fail_statement(Level level) const {
    switch (current().kind) {
        case TokenKind::BraceClose:
            fail(current().where, "'}' closes nothing: there is no '{' before it");
        case TokenKind::Else:
            fail(current().where, "'else' without an 'if' before it");
        case TokenKind::Use:
            fail(current().where, "'use' can only stand at the top level of a file");
        case TokenKind::Error:
            fail_expected("");
        default:
            break;
    }
    fail_expected(level == Level::Child ? "a child" : "a statement");
}

/// Statements in braces, into the block around them.
void Parser::braces(BlockBuilder& block, Level level) {
    const Nesting nesting(*this);
    const Token open = take();
    while (!at(TokenKind::BraceClose)) {
        if (at(TokenKind::End)) {
            close(TokenKind::BraceClose, open);
        }
        statement(block, level == Level::Top ? Level::Module : level);
    }
    take();
}

void Parser::assignment(BlockBuilder& block) {
    const Token name = take();
    take();
    Argument a;
    a.name = name.name;
    a.value = expression();
    a.where = from(name.where);
    expect_semicolon("the assignment");
    if (const auto before = block.assign(a)) {
        warn_overwritten(a, *before);
    }
}

/// Worth a word within one file, and where an included file takes away what the main file says. What the main file
/// sets may be meant to replace what it includes; and two included files know nothing of each other. Whether it was
/// worth one.
bool Parser::warn_overwritten(const Argument& assignment, const SourceRange& before) const {
    const std::uint32_t main = 0;
    const bool by_main = assignment.where.file == main;
    const bool one_file = assignment.where.file == before.file;
    if (one_file ? !by_main && assignment.where.line == before.line  // A file that is included again.
                 : by_main || before.file != main) {
        return false;
    }
    if (files_ == nullptr) {  // A piece has nothing to say.
        fail(assignment.where, {});
    }
    const std::string file = by_main ? "" : fmt::format(" of \"{}\"", files_->name_in_messages(before.file));
    report(files_->sink(), {Severity::Warning, assignment.where,
                            fmt::format("\"{}\" was assigned on line {}{} but was overwritten",
                                        program_.symbols.text(assignment.name), before.line, file)});
    return true;
}

bool Parser::pass_over(std::size_t (Preparser::*read)(std::size_t), Level level, std::uint32_t& lazy) {
    if (!lazy_ || level != Level::Top || depth_ + Preparser::kMostNesting > kMaxNesting || !tokens_->can_skip()) {
        return false;
    }
    const Token& first = current();
    if (first.kind == TokenKind::Semicolon) {
        return false;  // All of it; what comes behind has been read already, and would be told of twice.
    }
    const std::string& text = program_.sources[first.where.file].text();
    const std::size_t end = (Preparser(text, program_.symbols, program_.lazy).*read)(first.at);
    if (end == 0) {
        return false;
    }
    lazy = static_cast<std::uint32_t>(program_.lazy.bodies.size());
    program_.lazy.bodies.push_back(
        {first.where.file, first.at, static_cast<std::uint32_t>(end), first.where.line, first.where.column});
    tokens_->skip(end);
    return true;
}

ExprId Parser::function_body(const LazyBody& body) {
    tokens_.emplace(program_, body);
    return expression();
}

BlockId Parser::module_body(const LazyBody& body) {
    tokens_.emplace(program_, body);
    BlockBuilder block;
    statement(block, Level::Module);
    return block.finish(program_);
}

void Parser::module_definition(BlockBuilder& block, Level level) {
    const Nesting nesting(*this);
    const Token word = take();
    ModuleDefinition m;
    m.name = expect_name("the name of the module").name;
    m.parameters = parameters("after the name of the module");
    if (!pass_over(&Preparser::module_body, level, m.lazy)) {
        BlockBuilder body;
        statement(body, Level::Module);
        m.body = body.finish(program_);
    }
    m.where = from(word.where);
    block.add(m);
}

void Parser::function_definition(BlockBuilder& block, Level level) {
    const Token word = take();
    FunctionDefinition f;
    f.name = expect_name("the name of the function").name;
    f.parameters = parameters("after the name of the function");
    expect(TokenKind::Assign, "after the parameters of the function");
    if (!pass_over(&Preparser::function_body, level, f.lazy)) {
        f.body = expression();
        expect_semicolon("the function");
    }
    f.where = from(word.where);
    block.add(f);
}

Modifiers Parser::modifiers() {
    Modifiers m;
    for (;;) {
        if (accept(TokenKind::Not)) {
            m.root = true;
        } else if (accept(TokenKind::Hash)) {
            m.highlight = true;
        } else if (accept(TokenKind::Percent)) {
            m.background = true;
        } else if (accept(TokenKind::Star)) {
            m.disabled = true;
        } else {
            return m;
        }
    }
}

/// `of` is for messages: what the children belong to.
template <typename Text>
BlockId Parser::children(const Text& of) {
    BlockBuilder block;
    if (begins_child()) {
        statement(block, Level::Child);
    } else if (at(TokenKind::Semicolon)) {
        take();
    } else {
        expect_semicolon(of());
    }
    return block.finish(program_);
}

Instantiation Parser::instantiation() {
    const Nesting nesting(*this);
    const Modifiers set = modifiers();
    if (at(TokenKind::If)) {
        return if_chain(set);
    }
    if (!at_module_name()) {
        fail_expected("the name of a module");
    }
    const Token name = take();
    Instantiation i;
    i.name = name.name;
    i.modifiers = set;
    const std::string& text = program_.symbols.text(name.name);
    if (!at(TokenKind::ParenOpen)) {
        fail_expected(fmt::format("'('{} after '{}'", name.kind == TokenKind::Identifier ? " or '='" : "", text));
    }
    i.arguments = call_arguments("");
    i.where = from(name.where);
    i.children = children([&text] { return fmt::format("'{}(…)'", text); });
    return i;
}

BlockId Parser::block_of(const Instantiation& only) {
    BlockBuilder block;
    block.add(only);
    return block.finish(program_);
}

/// "if … else if …": a loop forwards, then the blocks from the last one back.
Instantiation Parser::if_chain(Modifiers first) {
    std::vector<Instantiation> chain;
    BlockId otherwise = kNone;
    Modifiers set = first;
    for (;;) {
        const Token word = take();
        Instantiation i;
        i.name = word.name;
        i.is_if = true;
        i.modifiers = set;
        const Token open = expect(TokenKind::ParenOpen, "after 'if'");
        const std::size_t mark = pending_arguments_.size();
        const ExprId condition = expression();
        pending_arguments_.push_back({kNoSymbol, condition, program_[condition].where});
        i.arguments = gather(mark);
        close(TokenKind::ParenClose, open);
        i.where = from(word.where);
        i.children = children([] { return "'if(…)'"; });
        chain.push_back(i);
        if (!accept(TokenKind::Else)) {
            break;
        }
        if (!at(TokenKind::If)) {
            otherwise = children([] { return "'else'"; });
            break;
        }
        set = {};
    }
    for (; chain.size() > 1; chain.pop_back()) {
        chain.back().otherwise = otherwise;
        otherwise = block_of(chain.back());
    }
    chain.front().otherwise = otherwise;
    return chain.front();
}

}  // namespace csg::scad
