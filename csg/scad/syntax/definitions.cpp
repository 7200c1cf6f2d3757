#include "csg/scad/syntax/definitions.h"

#include <algorithm>
#include <unordered_map>

#include "csg/scad/syntax/parser_impl.h"

namespace csg::scad {

bool may_name_files(std::span<const std::string> definitions) {
    return std::any_of(definitions.begin(), definitions.end(), [](const std::string& text) {
        return text.find('<') != std::string::npos &&
               (text.find("include") != std::string::npos || text.find("use") != std::string::npos);
    });
}

Definitions::Definitions(const Program& program) : base_(program.blocks[program.units[0].block].assignments) {}

bool Definitions::set(Program& program, std::span<const std::string> texts, const MessageSink& sink, Files* files) {
    reset(program);
    if (texts.empty()) {
        return true;
    }
    std::vector<Argument> definitions;
    try {
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const std::uint32_t file = source(program, i, texts[i]);
            (files != nullptr ? Parser(*files) : Parser(program)).definitions(file, sink, definitions);
        }
    } catch (SyntaxError& error) {
        report(sink, {Severity::Error, error.where, std::move(error.text), true});
        return false;
    }
    std::transform(definitions.begin(), definitions.end(), std::back_inserter(values_),
                   [](const Argument& a) { return a.value; });
    enter(program, merge(program, definitions));
    return true;
}

void Definitions::reset(Program& program) {
    program.blocks[program.units[0].block].assignments = base_;
    for (std::uint32_t i = 0; i < overlay_.count; ++i) {
        program.first_places.erase(overlay_.first + i);
    }
    other_names_.clear();
    values_.clear();
}

/// Texts that are replaced give their place to those that replace them.
std::uint32_t Definitions::source(Program& program, std::size_t index, const std::string& text) {
    SourceFile file{std::string(kCommandLine), text};
    if (index < files_.size()) {
        program.sources.replace(files_[index], std::move(file));
    } else {
        files_.push_back(program.sources.add(std::move(file)));
    }
    return files_[index];
}

/// As BlockBuilder does it: a variable keeps its place and gets the last value.
Definitions::Merged Definitions::merge(const Program& program, std::span<const Argument> definitions) {
    Merged merged;
    std::unordered_map<Symbol, std::size_t> places;
    std::unordered_map<std::size_t, SourceRange> first_places;
    const auto base = program.assignments_of(program.blocks[program.units[0].block]);
    merged.assignments.assign(base.begin(), base.end());
    for (std::size_t i = 0; i < base.size(); ++i) {
        places.emplace(base[i].name, i);
        const auto first = program.first_places.find(base_.first + static_cast<std::uint32_t>(i));
        if (first != program.first_places.end()) {
            first_places.emplace(i, first->second);
        }
    }
    for (const Argument& definition : definitions) {
        const auto [at, is_new] = places.try_emplace(definition.name, merged.assignments.size());
        if (is_new) {
            merged.assignments.push_back(definition);
            other_names_.push_back(definition.name);
        } else {
            Argument& known = merged.assignments[at->second];
            first_places.try_emplace(at->second, known.where);
            known = definition;
        }
    }
    std::sort(other_names_.begin(), other_names_.end());
    merged.first_places.assign(first_places.begin(), first_places.end());
    return merged;
}

/// In the place of the last, where there are as many: what sets one variable after another leaves little behind.
void Definitions::enter(Program& program, const Merged& merged) {
    if (overlay_.count != merged.assignments.size()) {
        overlay_ = {static_cast<std::uint32_t>(program.assignments.size()),
                    static_cast<std::uint32_t>(merged.assignments.size())};
        program.assignments.append(merged.assignments.begin(), merged.assignments.end());
    } else {
        std::copy(merged.assignments.begin(), merged.assignments.end(), program.assignments.begin() + overlay_.first);
    }
    for (const auto& [index, place] : merged.first_places) {
        program.first_places.emplace(overlay_.first + static_cast<std::uint32_t>(index), place);
    }
    program.blocks[program.units[0].block].assignments = overlay_;
}

}  // namespace csg::scad
