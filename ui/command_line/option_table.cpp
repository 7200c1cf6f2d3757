#include "ui/command_line/option_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

namespace ui {

struct OptionTable::Table {
    Table(const std::string& text, const std::string& command) : app(text, command) {}

    CLI::App app;

    template <typename Value>
    CLI::Option* add(const OptionHelp& help, Value& value) {
        return dress(help, app.add_option(help.names, value, help.text));
    }
    static CLI::Option* dress(const OptionHelp& help, CLI::Option* option) {
        if (!help.type.empty()) {
            option->type_name(help.type);
        }
        if (!help.group.empty()) {
            option->group(help.group);
        }
        return option;
    }
};

OptionTable::OptionTable(const std::string& text, const std::string& command)
    : table_(std::make_unique<Table>(text, command)) {}
OptionTable::~OptionTable() = default;

void OptionTable::add(const OptionHelp& help, std::string& value, bool required) {
    table_->add(help, value)->required(required);
}

void OptionTable::add(const OptionHelp& help, std::string& value, const std::vector<std::string>& choice) {
    table_->add(help, value)->check(CLI::IsMember(choice));
}

void OptionTable::add(const OptionHelp& help, int& value, int least, int most) {
    table_->add(help, value)->check(CLI::Range(least, most));
}

void OptionTable::add(const OptionHelp& help, double& value, double least, double most) {
    table_->add(help, value)->check(CLI::Range(least, most));
}

void OptionTable::add_positive(const OptionHelp& help, double& value, double most) {
    table_->add(help, value)->check(CLI::PositiveNumber & CLI::Range(0.0, most));
}

void OptionTable::add_last(const OptionHelp& help, std::string& value, bool required) {
    table_->add(help, value)->required(required)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void OptionTable::add_each(const OptionHelp& help, std::vector<std::string>& values) {
    table_->add(help, values)
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void OptionTable::add_rest(const OptionHelp& help, std::vector<std::string>& values) {
    table_->add(help, values)->type_name("");
}

void OptionTable::add_flag(const OptionHelp& help, bool& value) {
    Table::dress(help, table_->app.add_flag(help.names, value, help.text));
}

void OptionTable::add_flag(const OptionHelp& help, std::string& value) {
    Table::dress(help, table_->app.add_flag(help.names, value, help.text));
}

void OptionTable::remove(const std::string& name) {
    table_->app.remove_option(table_->app.get_option(name));
}

void OptionTable::lay_out_help(const std::string& group, std::size_t width) {
    table_->app.set_help_flag("-h,--help", "Print this help")->group(group);
    table_->app.get_formatter()->column_width(width);
}

std::string OptionTable::help() const {
    return table_->app.help();
}

std::vector<std::string> OptionTable::long_names() const {
    std::vector<std::string> names;
    for (const CLI::Option* option : table_->app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

bool OptionTable::read(const std::vector<std::string>& arguments) {
    CLI::App& app = table_->app;
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        return false;
    } catch (const CLI::ExtrasError& error) {
        const std::string extra = app.remaining().empty() ? "" : app.remaining().front();
        throw UnknownOption(error.what(), extra.substr(0, extra.find('=')));
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    return true;
}

void OptionTable::refuse_empty_values() const {
    for (const CLI::Option* option : std::as_const(table_->app).get_options()) {
        const bool takes_value = !option->get_positional() && option->get_items_expected_max() > 0;
        const std::vector<std::string>& values = option->results();
        if (takes_value && option->count() > 0 && std::find(values.begin(), values.end(), "") != values.end()) {
            const std::vector<std::string>& letters = option->get_snames();
            throw UsageError((letters.empty() ? option->get_name() : "-" + letters[0]) + ": the value is empty");
        }
    }
}

}  // namespace ui
