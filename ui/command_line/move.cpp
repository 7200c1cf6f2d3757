#include "ui/command_line/move.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "ui/command_line/call_place.h"
#include "ui/command_line/files.h"
#include "ui/command_line/language_run.h"
#include "ui/command_line/messages.h"
#include "ui/command_line/option_table.h"
#include "ui/command_line/option_values.h"
#include "ui/command_line/subcommand.h"
#include "ui/pipeline/editable_model.h"
#include "ui/pipeline/editing/movable_survey.h"
#include "ui/pipeline/editing/move_leaf.h"
#include "ui/pipeline/editing/scale_leaf.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

struct MoveOptions {
    Options run;
    std::string call;  ///< [FILE:]LINE[:COLUMN]
    int number = 1;    ///< Of the solids that come from there.
    /// What is done, of one of these.
    std::optional<glm::dvec3> by, turn, scale;
    std::optional<HeldSide> stretch;
    int choice = 1;
    int survey = 0;      ///< Of so many solids it is told whether they can be moved; 0: of none.
    std::string output;  ///< Empty: the ways are told.
    bool help = false;
};

/// Of "+x,5".
HeldSide read_stretch(const std::string& text) {
    constexpr std::string_view kAxisNames = "xyz", kSideNames = "+-";
    if (text.size() < 4 || kSideNames.find(text[0]) == std::string_view::npos ||
        kAxisNames.find(text[1]) == std::string_view::npos || text[2] != ',') {
        throw UsageError(
            fmt::format("--stretch {}: expected a side and how far, as +x,5 (or -x, +y, -y, +z, -z)", text));
    }
    HeldSide stretch{static_cast<int>(kAxisNames.find(text[1])), text[0] == '+', 0};
    stretch.by = read_numbers("--stretch", text.substr(3), {1}, "a number behind the side")[0];
    if (stretch.by == 0) {
        throw UsageError(fmt::format("--stretch {} stretches nothing", text));
    }
    return stretch;
}

std::optional<glm::dvec3> read_vector(const char* option, const std::string& text, const char* does) {
    if (text.empty()) {
        return std::nullopt;
    }
    const auto n = read_numbers(option, text, {3}, "x,y,z");
    const glm::dvec3 v(n[0], n[1], n[2]);
    if (v == glm::dvec3(0.0)) {
        throw UsageError(fmt::format("{} {} {} nothing", option, text, does));
    }
    return v;
}

std::optional<glm::dvec3> read_factors(const std::string& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    const auto n = read_numbers("--scale", text, {1, 3}, "a factor, or x,y,z");
    const glm::dvec3 factors = n.size() == 1 ? glm::dvec3(n[0]) : glm::dvec3(n[0], n[1], n[2]);
    if (!(factors.x > 0 && factors.y > 0 && factors.z > 0)) {
        throw UsageError(fmt::format("--scale {}: factors above 0 are expected", text));
    }
    if (factors == glm::dvec3(1.0)) {
        throw UsageError(fmt::format("--scale {} scales nothing", text));
    }
    return factors;
}

MoveOptions read_move_options(const std::vector<std::string>& arguments) {
    MoveOptions o;
    std::string by, turn, scale, stretch;
    double time_limit = 0;
    OptionTable table(
        "csgscope move moves, turns, scales or stretches a solid: it finds the numbers of the text that are to change, "
        "or where a translate(), rotate() or scale() is to stand.\nWithout -o it tells the ways there are.",
        "csgscope move");
    table.lay_out_help("The model", 34);
    table.add({"file", "The .scad file"}, o.run.input, true);
    const char* const what = "What to do";
    table.add({"--call", "The solid that the call on that line makes, or is part of", "[FILE:]LINE[:COLUMN]", what},
              o.call);
    table.add({"--number", "Of several solids that come from there, which (1)", "N", what}, o.number, 1, 1'000'000'000);
    table.add({"--by", "How far, in the world", "X,Y,Z", what}, by);
    table.add({"--turn", "Turn it about its own origin: degrees about the world's axes, as one turn", "X,Y,Z", what},
              turn);
    table.add({"--scale", "Make it so many times as large along its own axes, or all of them alike, from its origin",
               "X,Y,Z", what},
              scale);
    table.add({"--stretch", "Move one side of its box outwards, in its own coordinates: +x,5", "SIDE,DISTANCE", what},
              stretch);
    table.add({"--choice", "Which of the ways (1)", "N", what}, o.choice, 1, 1'000'000);
    table.add({"-o,--o", "Write the text after the first way, or the one chosen, to FILE; it may be the model's",
               "FILE", what},
              o.output);
    table.add({"--survey", "Instead: tell of N solids of the model, evenly spread, whether and how they can be moved",
               "N", what},
              o.survey, 1, 1'000'000'000);
    const char* const model = "The model";
    declare_model(table, o.run, time_limit, model);
    table.add_flag({"-q,--quiet", "Print errors only", "", model}, o.run.quiet);
    o.help = !read_subcommand(table, arguments, "move", [&] {
        if (o.survey > 0) {
            if (!o.call.empty() || !o.output.empty()) {
                throw UsageError("--survey goes without --call and -o");
            }
            by = by.empty() && turn.empty() && scale.empty() && stretch.empty() ? "1.25,-0.75,0" : by;
        } else if (o.call.empty()) {
            throw UsageError("--call is needed, or --survey");
        }
        const auto given = {!by.empty(), !turn.empty(), !scale.empty(), !stretch.empty()};
        if (std::count(given.begin(), given.end(), true) != 1) {
            throw UsageError("one of --by, --turn, --scale and --stretch is needed");
        }
        o.by = read_vector("--by", by, "moves");
        o.turn = read_vector("--turn", turn, "turns");
        o.scale = read_factors(scale);
        if (!stretch.empty()) {
            o.stretch = read_stretch(stretch);
        }
        if (o.survey > 0 && !o.by) {
            throw UsageError("--survey goes with --by");
        }
        if (o.turn && glm::length(*o.turn) >= 180) {
            throw UsageError(fmt::format("--turn {}: less than half a turn is expected", turn));
        }
    });
    o.run.time_limit = time_limit;
    return o;
}

/// The solids below the call, in the order of the text's run.
std::vector<csg::LeafId> leaves_of(const csg::Tree& tree, const csg::Scene& scene, const csg::SourceLocation& call) {
    std::vector<csg::LeafId> leaves;
    for (csg::LeafId leaf = 0; leaf < scene.leaves.size(); ++leaf) {
        for (const csg::OccurrenceId o : path_to(scene, scene.leaves[leaf].occurrence)) {
            if (tree.node(scene.occurrences[o].node).where == call) {
                leaves.push_back(leaf);
                break;
            }
        }
    }
    return leaves;
}

/// What the way is, without its edits.
std::string name_of_way(const MoveWay& way) {
    switch (way.kind) {
        case MoveWay::Kind::Call:
            return fmt::format("change {}()", way.name);
        case MoveWay::Kind::Variable:
            return fmt::format("change the variable {}", way.name);
        case MoveWay::Kind::Wrap:
            break;
    }
    return fmt::format("put a {} before {}()", way.put, way.name);
}

std::string text_of_way(const csg::Tree& tree, const MoveWay& way, const std::string& text) {
    std::string out = name_of_way(way);
    out += fmt::format(" ({}:{}:{}): moves {} thing{}", tree.files()[way.where.file], way.where.line, way.where.column,
                       way.moved, way.moved == 1 ? "" : "s");
    if (way.changed > 0) {
        out += fmt::format(", changes {} in shape", way.changed);
    }
    for (const TextEdit& edit : way.edits) {
        const std::string before = text.substr(edit.bytes.begin, edit.bytes.end - edit.bytes.begin);
        out += before.empty() ? fmt::format("\n      + {}", edit.text)
                              : fmt::format("\n      {} -> {}", before, edit.text);
    }
    return out + '\n';
}

std::string text_of_survey(const csg::Tree& tree, const MovableSurvey& survey) {
    std::string out;
    std::map<MoveWay::Kind, std::size_t> kinds;
    std::size_t movable = 0;
    for (const auto& [leaf, way, why] : survey.solids) {
        out += fmt::format("{:>6}  ", leaf + 1);
        if (way) {
            out += fmt::format("{} ({}:{}:{}): moves {}\n", name_of_way(*way), tree.files()[way->where.file],
                               way->where.line, way->where.column, way->moved);
            ++kinds[way->kind];
            ++movable;
        } else {
            out += fmt::format("not moved: {}\n", why);
        }
    }
    return out + fmt::format(
                     "{} of {} solids ({} in all) can be moved: {} by numbers of a call, {} of a variable, {} by a "
                     "translate()\n",
                     movable, survey.solids.size(), survey.all, kinds[MoveWay::Kind::Call],
                     kinds[MoveWay::Kind::Variable], kinds[MoveWay::Kind::Wrap]);
}

int move_within(const MoveOptions& o, TimeLimit& limit) {
    LanguageRun language(o.run, limit, make_measures());
    language.read();
    if (!language()) {
        return 1;
    }
    const std::shared_ptr<const csg::Tree> tree = language.evaluation().tree;
    const csg::Scene scene = csg::make_scene(*tree);
    const TreeOfText tree_of = [&](const std::string& changed) { return language.evaluate_text(changed); };
    if (o.survey > 0) {
        const MovableSurvey survey =
            survey_movable(*tree, scene, *language.evaluation().program, read_source(o.run.input),
                           static_cast<std::size_t>(o.survey), *o.by, tree_of, limit.token());
        write_output("-", printable(text_of_survey(*tree, survey)));
        return 0;
    }
    const auto call = call_at(*tree, all_calls(*tree), "--call", o.call, "call");
    const std::vector<csg::LeafId> leaves = leaves_of(*tree, scene, call);
    if (static_cast<std::size_t>(o.number) > leaves.size()) {
        throw UsageError(leaves.empty() ? fmt::format("--call {}: no solid comes from there", o.call)
                                        : fmt::format("--number {}: {} solid{} from there", o.number, leaves.size(),
                                                      leaves.size() == 1 ? " comes" : "s come"));
    }
    const std::string text = read_source(o.run.input);
    const csg::LeafId leaf = leaves[static_cast<std::size_t>(o.number) - 1];
    const csg::scad::LoadedProgram& program = *language.evaluation().program;
    std::vector<MoveWay> ways =
        o.by      ? ways_to_move(*tree, scene, program, text, leaf, *o.by, tree_of, limit.token())
        : o.turn  ? ways_to_turn(*tree, scene, program, text, leaf, *o.turn, tree_of, limit.token())
        : o.scale ? ways_to_scale(*tree, scene, program, text, leaf, *o.scale, tree_of, limit.token())
                  : ways_to_stretch(*tree, scene, program, text, leaf, o.stretch->axis, o.stretch->upper, o.stretch->by,
                                    tree_of, limit.token());
    // Of ways that do alike, the one at the call that was named.
    std::stable_sort(ways.begin(), ways.end(), [&](const MoveWay& a, const MoveWay& b) {
        return std::tuple(a.changed, a.moved, a.kind, a.put.size(), a.where != call) <
               std::tuple(b.changed, b.moved, b.kind, b.put.size(), b.where != call);
    });
    if (ways.empty()) {
        throw UsageError(fmt::format(
            "no edit of this file does that: {}",
            o.stretch ? "no number of it moves that side" : why_no_way(*tree, scene, program, text, leaf, tree_of)));
    }
    if (static_cast<std::size_t>(o.choice) > ways.size()) {
        throw UsageError(fmt::format("--choice {}: there are {} ways", o.choice, ways.size()));
    }
    if (!o.output.empty()) {
        write_output(o.output, edited(text, ways[static_cast<std::size_t>(o.choice) - 1].edits));
        return 0;
    }
    std::string told;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        told += fmt::format("{:>3}.  {}", i + 1, text_of_way(*tree, ways[i], text));
    }
    write_output("-", printable(told));
    return 0;
}

}  // namespace

int run_move(const std::vector<std::string>& arguments) {
    return or_error(arguments, [&] {
        const MoveOptions options = read_move_options(arguments);
        if (options.help) {
            return 0;
        }
        return within_time(options.run.time_limit, 1, [&](TimeLimit& limit) { return move_within(options, limit); });
    });
}

}  // namespace ui
