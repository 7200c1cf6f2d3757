#include "ui/command_line/check.h"

#include <filesystem>
#include <stdexcept>

#include "base/file.h"
#include "ui/command_line/check_options.h"
#include "ui/command_line/check_page.h"
#include "ui/command_line/check_report.h"
#include "ui/command_line/files.h"
#include "ui/command_line/language_run.h"
#include "ui/command_line/messages.h"
#include "ui/command_line/subcommand.h"
#include "ui/pipeline/inspection/check.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

constexpr int kClean = 0, kFound = 1, kBadInput = 2;

void write(const CheckOptions& o, const CheckReport& report) {
    switch (o.format) {
        case CheckFormat::Text:
            write_output(o.output, printable(check_text(report)));
            break;
        case CheckFormat::Json:
            write_output(o.output, text_of(check_json(report)));
            break;
        case CheckFormat::Sarif:
            write_output(o.output, text_of(check_sarif(report)));
            break;
        case CheckFormat::Junit:
            write_output(o.output, check_junit(report));
            break;
    }
}

int check_within(const CheckOptions& o, TimeLimit& limit) {
    LanguageRun language(o.run, limit, make_measures());
    language.read();
    if (!language()) {
        return kBadInput;
    }
    ModelBuilder builder;
    builder.show(csg::Showing::Result);
    builder.divide(o.run.parts);
    const auto model = builder.build(language.evaluation().tree, limit.token(), language.evaluation().program);
    for (const std::string& warning : model->warnings) {
        language.messages().warn(warning);
    }
    need_whole(*model);
    if (model->empty()) {
        throw ModelError("the model is empty: there is nothing to check");
    }
    if (model->flat) {
        throw ModelError("the model is an outline in the plane, which has no walls; extrude it first");
    }
    const CheckResult result = check(*model, o.request, limit.token());
    const CheckReport report{*model, *language.evaluation().sources, o.run.input, o.request, result};
    write(o, report);
    if (!o.report.empty()) {
        base::make_folder(o.report);
        const std::filesystem::path folder = o.report;
        write_output((folder / "report.json").string(), text_of(check_json(report)));
        write_output((folder / "report.html").string(), check_page(report, model, limit.token()));
    }
    return result.findings.empty() ? kClean : kFound;
}

}  // namespace

int run_check(const std::vector<std::string>& arguments) {
    int status = kBadInput;
    (void)or_error(arguments, [&] {
        const CheckOptions options = read_check_options(arguments);
        if (options.help) {
            status = kClean;
            return 0;
        }
        status = within_time(options.run.time_limit, kBadInput,
                             [&](TimeLimit& limit) { return check_within(options, limit); });
        return 0;
    });
    return status;
}

}  // namespace ui
