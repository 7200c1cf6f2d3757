// What is chosen in the customizer: values of the main file's parameters, and the parameter sets beside it. The text
// stays as it is.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "csg/scad/customizer/customizer.h"
#include "csg/scad/source/disk_state.h"
#include "ui/pipeline/parameter_sets.h"

namespace ui {

class Customizer {
  public:
    using Parameter = csg::scad::CustomizerParameter;

    /// `file`: of the parameter sets; empty where there can be none. It need not be there.
    explicit Customizer(std::filesystem::path file);

    /// The parameters of the newest text. Values of parameters that are gone, or that do not fit any more, go. Reads
    /// the sets.
    void receive(std::vector<Parameter> parameters);

    void set(const std::string& parameter, Parameter::Value value);
    /// As the text says again; all of them where the name is empty.
    void reset(const std::string& parameter);

    /// The set's values, and for what it does not hold, or what does not fit, the text's.
    void use(const std::string& set);
    /// The values of now under that name. Where they cannot be written error() says why.
    void save(const std::string& set);
    void remove(const std::string& set);

    [[nodiscard]] std::span<const Parameter> parameters() const { return parameters_; }
    [[nodiscard]] const Parameter::Value& value(const Parameter& parameter) const;
    /// It is not what the text says.
    [[nodiscard]] bool changed(const Parameter& parameter) const;
    [[nodiscard]] bool any_changed() const { return !chosen_.empty(); }
    /// name=expression of those.
    [[nodiscard]] std::vector<std::string> definitions() const;

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] std::span<const ParameterSet> sets() const { return sets_; }
    /// The set that was used or saved last; empty where there is none.
    [[nodiscard]] const std::string& used() const { return used_; }
    /// What went wrong with the file last; empty where nothing did.
    [[nodiscard]] const std::string& error() const { return error_; }

  private:
    /// Where the file is another than was read last.
    void read_sets();
    template <typename Change>
    void write_sets(const Change& change);

    std::filesystem::path file_;
    std::vector<Parameter> parameters_;
    std::map<std::string, Parameter::Value> chosen_;  ///< By name, those that are not what the text says.
    std::vector<ParameterSet> sets_;
    std::optional<csg::scad::DiskState> read_;  ///< The file, before sets_ were read from it; nothing before that.
    std::string problem_;                       ///< Of the file as it was read.
    std::string used_, error_;
};

}  // namespace ui
