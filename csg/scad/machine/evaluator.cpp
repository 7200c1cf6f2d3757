// Setting up and ending an evaluation; `$` variables.
#include "csg/scad/machine/evaluator.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "csg/scad/builtin/data_file.h"
#include "csg/tree/least_fineness.h"

namespace csg::scad {

namespace {

std::uint32_t index_of_special(const Program& program, const Resolution& resolution, std::string_view name) {
    const Symbol symbol = program.symbols.find(name);
    return symbol == kNoSymbol ? kNone : resolution.dynamic_of_symbol[symbol];
}

Value vector_of(const std::array<double, 3>& v) {
    return std::vector<Value>{v[0], v[1], v[2]};
}

}  // namespace

Evaluator::Evaluator(const Program& program, Compiled& compiled, const Request& request, MessageSink sink,
                     const char* stack_limit)
    : p_(program),
      request_(request),
      sink_(std::move(sink)),
      stack_limit_(stack_limit),
      r_(compiled.resolver.resolution()),
      is_undef_(find_builtin_function("is_undef")),
      len_(find_builtin_function("len")),
      parent_modules_index_(index_of_special(program, r_, "$parent_modules")),
      fn_index_(index_of_special(program, r_, "$fn")),
      fa_index_(index_of_special(program, r_, "$fa")),
      fs_index_(index_of_special(program, r_, "$fs")),
      fe_index_(index_of_special(program, r_, "$fe")),
      resolver_(compiled.resolver),
      compiled_(compiled) {
    host_.warn = [this](std::string text) { warn(p_[call_].where, std::move(text)); };
    host_.warn_without_place = [this](std::string text) { warn({}, std::move(text)); };
    host_.argument_name = [this](std::size_t i) {
        const Symbol argument = p_.arguments_of(p_[call_])[i].name;
        return argument == kNoSymbol ? std::string_view() : std::string_view(name(argument));
    };
    host_.data_file = [this](const std::string& file) { return find_data_file(*this, p_[call_].where, file); };
    host_.read = request.reader;
    host_.measures = request.measures.get();
    host_.font_files = program.fonts();
    host_.random.seed(std::mt19937::default_seed);
    host_.max_elements = request.limits.list_elements;
    limit_elements(request.limits.list_elements);
    end_values_at(request.stop);
    dynamic_.assign(r_.dynamics, Value::unset());
    units_.resize(p_.units.size());
    for (std::uint32_t file = 0; file < p_.sources.size(); ++file) {
        tree_files_.push_back(builder_.file(p_.sources[file].name()));
        source_of_.resize(std::max<std::size_t>(source_of_.size(), tree_files_.back() + 1));
        source_of_[tree_files_.back()] = file;
    }
    set_special("$fn", 0.0);
    set_special("$fa", 12.0);
    set_special("$fs", 2.0);
    if (request.by_error) {
        set_special("$fe", 0.0);
    }
    set_special("$t", request.time);
    set_special("$preview", request.preview);
    set_special("$vpt", vector_of(request.view.translation));
    set_special("$vpr", vector_of(request.view.rotation));
    set_special("$vpd", request.view.distance);
    set_special("$vpf", request.view.fov);
    exchange_code();
}

void Evaluator::exchange_code() {
    strings_.swap(compiled_.strings);
    codes_.swap(compiled_.codes);
    function_codes_.swap(compiled_.function_codes);
    literal_codes_.swap(compiled_.literal_codes);
    std::swap(statement_codes_, compiled_.statement_codes);
}

Evaluator::~Evaluator() {
    exchange_code();
    // Closures that hold each other would keep each other alive.
    std::vector<Value> captures;
    for (const Value& value : knotted_) {
        value.function().take_captures(captures);
    }
}

void Evaluator::set_special(std::string_view name, Value value) {
    if (const std::uint32_t index = index_of_special(p_, r_, name); index != kNone) {
        dynamic_[index] = std::move(value);
    }
}

void Evaluator::bind_dynamic(std::uint32_t index, Value value) {
    if (index == kNone) {
        return;  // Nobody asks for it.
    }
    undo_.push_back({index, std::move(dynamic_[index])});
    dynamic_[index] = std::move(value);
}

void Evaluator::unwind(std::size_t mark) {
    while (undo_.size() > mark) {
        dynamic_[undo_.back().index] = std::move(undo_.back().before);
        undo_.pop_back();
    }
}

Fineness Evaluator::fineness(const SourceRange& where) {
    Fineness fineness;
    const auto read = [&](std::uint32_t index, double& number) {
        if (const Value* const value = special(index)) {
            number = value->is_number() ? value->number() : 0;
        }
    };
    read(fn_index_, fineness.fn);
    read(fa_index_, fineness.fa);
    read(fs_index_, fineness.fs);
    if (request_.by_error) {
        double most = 0;
        read(fe_index_, most);
        if (most < 0) {
            warn(where, "$fe negative - setting to 0");
        }
        fineness.fe = std::max(most, 0.0);
    }
    const auto clamp = [&](const char* name, double& number) {
        if (number < kLeastFineness) {
            warn(where, fmt::format("{} too small - clamping to {:f}", name, kLeastFineness));
            number = kLeastFineness;
        }
    };
    clamp("$fs", fineness.fs);
    clamp("$fa", fineness.fa);
    return fineness;
}

void Evaluator::warn(const SourceRange& where, std::string text) {
    emit(Severity::Warning, where, std::move(text));
}

void Evaluator::emit(Severity severity, const SourceRange& where, std::string text) {
    ++host_.effects;
    report(sink_, {severity, where, std::move(text)});
}

void Evaluator::fail(const SourceRange& where, std::string text) {
    throw EvaluationError{
        {Severity::Error, where, std::move(text)}, false, trace_messages(p_, innermost_, request_.trace_depth)};
}

void Evaluator::fail_stopped(const SourceRange& where) {
    throw EvaluationError{{Severity::Error, where, "Stopped"}, true, {}};
}

void Evaluator::fail_limit(const SourceRange& where, const ValueLimit& limit) {
    fail(where, limit.what());
}

void Evaluator::fail_out_of_memory(const SourceRange& where) {
    EvaluationError error{{Severity::Error, where, "Out of memory"}, false, {}, true};
    throw error;
}

void Evaluator::fail_recursion(const SourceRange& where, std::string_view what, Symbol callee) {
    fail(where, callee == kNoSymbol ? fmt::format("Recursion detected {}", what)
                                    : fmt::format("Recursion detected {} '{}'", what, name(callee)));
}

SourceLocation Evaluator::location(const SourceRange& where) const {
    return {where.file < tree_files_.size() ? tree_files_[where.file] : 0, where.line, where.column};
}

/// The node of the first `!`, outside in; `top` where there is none.
NodeId Evaluator::find_root(NodeId top) {
    NodeId root = kNoNode;
    std::vector<bool> seen(std::size_t{top} + 1);  // Children come before their parents.
    std::vector<NodeId> pending{top};
    while (!pending.empty()) {
        const NodeId id = pending.back();
        pending.pop_back();
        if (seen[id]) {
            continue;
        }
        seen[id] = true;
        const Node& node = builder_.node(id);
        if (node.modifiers.root && root == kNoNode) {
            root = id;
        } else if (node.modifiers.root && !(node.where == builder_.node(root).where)) {
            const SourceLocation& where = node.where;
            warn({source_of_[where.file], where.line, where.column, where.line, where.column + 1},
                 "More than one Root Modifier (!)");
            break;
        }
        const auto children = builder_.children(id);
        pending.insert(pending.end(), children.rbegin(), children.rend());
    }
    return root == kNoNode ? top : builder_.combine(Operation::Group, std::array{root}, {});
}

void Evaluator::take_view(ViewSettings& view) {
    const auto assigned = [&](std::string_view name) -> const Value* {
        const Symbol symbol = p_.symbols.find(name);
        const auto assignments = p_.assignments_of(p_.blocks[p_.units[0].block]);
        const bool set = symbol != kNoSymbol && std::any_of(assignments.begin(), assignments.end(),
                                                            [&](const Argument& a) { return a.name == symbol; });
        return set ? special(r_.dynamic_of_symbol[symbol]) : nullptr;
    };
    const auto take_vector = [&](const char* name, std::optional<std::array<double, 3>>& out) {
        const Value* const value = assigned(name);
        if (value == nullptr) {
            return;
        }
        std::array<double, 3> v{};
        const auto elements = value->is_vector() ? value->elements() : std::span<const Value>();
        bool good = elements.size() == 2 || elements.size() == 3;
        for (std::size_t i = 0; good && i < elements.size(); ++i) {
            good = elements[i].is_number() && std::isfinite(elements[i].number());
            v[i] = good ? elements[i].number() : 0;
        }
        if (good) {
            out = v;
        } else {
            warn({}, fmt::format("Unable to convert {}={} to a vec3 or vec2 of numbers", name, value->echo_text()));
        }
    };
    const auto take_number = [&](const char* name, std::optional<double>& out) {
        const Value* const value = assigned(name);
        if (value == nullptr) {
            return;
        }
        if (value->is_number() && std::isfinite(value->number())) {
            out = value->number();
        } else {
            warn({}, fmt::format("Unable to convert {}={} to a number", name, value->echo_text()));
        }
    };
    take_vector("$vpr", view.rotation);
    take_vector("$vpt", view.translation);
    take_number("$vpd", view.distance);
    take_number("$vpf", view.fov);
}

void Evaluator::note_statement(const Instantiation& i) {
    const auto index = static_cast<std::size_t>(&i - p_.instantiations.data());
    if (index >= noted_.size()) {
        noted_.resize(p_.instantiations.size());
    }
    noted_[index] = 1;
}

std::vector<Statement> Evaluator::noted_statements() const {
    std::vector<Statement> statements;
    for (std::size_t index = 0; index < noted_.size(); ++index) {
        if (noted_[index] == 0) {
            continue;
        }
        const Instantiation& i = p_.instantiations[index];
        statements.push_back({location(i.where), i.where.end_line, i.where.end_column, name(i.name),
                              !i.is_if && r_.module_of_instantiation[index].user.id != kNone});
    }
    // A file that is read twice has its statements twice.
    std::ranges::sort(statements, {}, &Statement::where);
    const auto same_place = [](const Statement& a, const Statement& b) { return a.where == b.where; };
    statements.erase(std::unique(statements.begin(), statements.end(), same_place), statements.end());
    return statements;
}

Tree Evaluator::run(ViewSettings& view) {
    const BlockId block = p_.units[0].block;
    UnitFrame& main = units_[0].frames.emplace_back();
    units_[0].running = &main;  // Used files may use the main file.
    main.slots.assign(r_.frame_slots[block], Value::unset());
    main.frame = {nullptr, main.slots.data(), nullptr};
    Nodes nodes;
    run_block(block, &main.frame, nodes);
    take_view(view);
    if (nodes.empty()) {
        return builder_.finish(kNoNode);
    }
    const NodeId top = builder_.combine(Operation::Group, nodes, {});
    return builder_.finish(has_root_modifier_ ? find_root(top) : top, noted_statements());
}

}  // namespace csg::scad
