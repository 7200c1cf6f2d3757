// What commands with options of their own, as csgscope check, have in common.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/stop.h"
#include "ui/command_line/files.h"
#include "ui/command_line/option_table.h"
#include "ui/command_line/option_values.h"
#include "ui/command_line/options.h"
#include "ui/command_line/time_limit.h"

namespace ui {

/// The options that such a command has of the program that it runs. `time_limit`: seconds; stays as it is where none is
/// given.
inline void declare_model(OptionTable& table, Options& run, double& time_limit, const char* group = "The model") {
    constexpr double kLongest = 1e9;
    table.add_each({"-D,--D", "Put a statement behind the file: -D 'size=[1,2]'", "STATEMENT", group}, run.definitions);
    table.add({"-p,--p", "A file of parameter sets", "FILE", group}, run.parameter_file);
    table.add({"-P,--P", "The parameter set of that file to take", "NAME", group}, run.parameter_set);
    table.add_positive({"--time-limit", "End with an error after so many seconds", "SECONDS", group}, time_limit,
                       kLongest);
    table.add_flag({"--preview", "Evaluate with $preview true (false)", "", group}, run.preview);
}

/// Reads the arguments behind the command's name, then `interpret`s them. False where the help was asked for, and
/// printed. Throws UsageError, with the command's name.
template <typename Interpret>
[[nodiscard]] bool read_subcommand(OptionTable& table, const std::vector<std::string>& arguments, const char* name,
                                   const Interpret& interpret) {
    try {
        if (!table.read(arguments)) {
            write_output("-", table.help());
            return false;
        }
        table.refuse_empty_values();
        interpret();
        return true;
    } catch (const UnknownOption& unknown) {
        const std::string help = fmt::format(" See csgscope {} --help.", name);
        throw UsageError(fmt::format("{}: unknown option {}.{}", name, unknown.name(),
                                     suggestion(unknown.name(), table.long_names(), help)));
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{}: {}", name, error.what()));
    }
}

/// What `action(limit)` gives; `late`, and a message, where the time (seconds; 0: any) was over first.
template <typename Action>
[[nodiscard]] int within_time(double seconds, int late, const Action& action) {
    TimeLimit limit(seconds);
    try {
        const int status = action(limit);
        limit.end();
        return status;
    } catch (const base::Stopped&) {
        limit.tell();
        return late;
    }
}

}  // namespace ui
