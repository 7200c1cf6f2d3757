// The options of a command: names, help and groups, and where each one's value goes. Only option_table.cpp includes
// CLI11, which takes seconds to compile.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/command_line/usage_error.h"

namespace ui {

/// Argument of an option that there is not.
class UnknownOption : public UsageError {
  public:
    /// `text`: for people; `name`: as it was given, without a value.
    UnknownOption(const std::string& text, std::string name) : UsageError(text), name_(std::move(name)) {}
    [[nodiscard]] const std::string& name() const { return name_; }

  private:
    std::string name_;
};

/// How an option is told to people.
struct OptionHelp {
    std::string names;  ///< "-o,--o"; without dashes: an argument that is known by its position.
    std::string text;
    std::string type{};   ///< Of the value, as "FILE"; where empty, that of the C++ type.
    std::string group{};  ///< The heading that it stands under; where empty, the common one.
};

/// Declared first, read then. Keeps references to what the values go to; they stay as they are where an option is not
/// given.
class OptionTable {
  public:
    /// `text`: what the command does.
    OptionTable(const std::string& text, const std::string& command);
    ~OptionTable();
    OptionTable(const OptionTable&) = delete;
    OptionTable& operator=(const OptionTable&) = delete;

    /// At most once; a number between the bounds, a text that is one of the choice. A `required` one must be given.
    void add(const OptionHelp& help, std::string& value, bool required = false);
    void add(const OptionHelp& help, std::string& value, const std::vector<std::string>& choice);
    void add(const OptionHelp& help, int& value, int least, int most);
    void add(const OptionHelp& help, double& value, double least, double most);
    /// At most once, above 0.
    void add_positive(const OptionHelp& help, double& value, double most);
    /// The last of several counts.
    void add_last(const OptionHelp& help, std::string& value, bool required = false);
    /// As often as it is given, each time exactly the argument after it, whatever that holds or begins with.
    void add_each(const OptionHelp& help, std::vector<std::string>& values);
    /// The arguments that belong to no option.
    void add_rest(const OptionHelp& help, std::vector<std::string>& values);
    /// Without a value.
    void add_flag(const OptionHelp& help, bool& value);
    /// The same; or with one, after '='.
    void add_flag(const OptionHelp& help, std::string& value);
    /// Takes an option out, by one of its names.
    void remove(const std::string& name);

    /// The help: the heading that -h stands under, and the width of the column of names.
    void lay_out_help(const std::string& group, std::size_t width);
    [[nodiscard]] std::string help() const;
    /// "--output" of all options that have a long name.
    [[nodiscard]] std::vector<std::string> long_names() const;

    /// Reads the arguments (without the program's name), once. False where the help is asked for instead. Throws
    /// UsageError.
    [[nodiscard]] bool read(const std::vector<std::string>& arguments);
    /// A value that is there and empty would leave the option as it is, which nobody means who names it. Throws
    /// UsageError.
    void refuse_empty_values() const;

  private:
    struct Table;
    std::unique_ptr<Table> table_;
};

}  // namespace ui
