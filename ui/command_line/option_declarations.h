// The options of csgscope: names, help and groups.
#pragma once

#include <string>
#include <vector>

#include "ui/command_line/option_table.h"
#include "ui/command_line/options.h"

namespace ui {

/// The options as texts, as they are given.
struct RawOptions {
    std::vector<std::string> inputs, outputs, settings, media, export_options, sections, uncut;
    std::string export_format, camera, size, layers, samples, view, csg_limit, backend, render, preview, scheme;
    std::string check_parameters, check_ranges, trace_parameters, trace_depth, time_limit, memory_limit, memory_budget,
        minimal_fraction, precision, thickness, parts, at, format, hatching, transparency, blend, medium_light, dpi,
        margin, plan;
    std::string projection = "p", context = "auto", engine = "auto", statistics, summary_file, dependencies;
    std::string animate, sharding, turntable, time, frame_rate, storyboard;
    std::vector<std::string> depictions;
    std::string debug;  ///< Taken and left alone.
    std::vector<std::string> summary, features;
    std::vector<std::string> of, between, other;
    std::string value;
    bool version = false, help_export = false, trust_python = false;
};

/// Declares all options. What needs no interpretation goes to `options`; both must outlive `table`. `styles`: as the
/// help lists them.
void declare(OptionTable& table, Options& options, RawOptions& raw, const std::string& styles);

/// Those of `csgscope pick`: of all the others those that have a meaning there.
void declare_pick(OptionTable& table, Options& options, RawOptions& raw, const std::string& styles);

/// Those of `csgscope measure`, as above.
void declare_measure(OptionTable& table, Options& options, RawOptions& raw, const std::string& styles);

}  // namespace ui
