#include "ui/command_line/motion.h"

#include "ui/command_line/files.h"
#include "ui/command_line/language_run.h"
#include "ui/command_line/messages.h"
#include "ui/command_line/motion_options.h"
#include "ui/command_line/motion_report.h"
#include "ui/command_line/subcommand.h"
#include "ui/pipeline/measures.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

int motion_within(const MotionOptions& o, TimeLimit& limit) {
    LanguageRun language(o.run, limit, make_measures());
    language.read();
    language.messages().each_once();
    const auto tree_at = [&](double time) -> std::shared_ptr<const csg::Tree> {
        language.set_time(time);
        return language() ? language.evaluation().tree : nullptr;
    };
    const Motion motion = find_motion(tree_at, o.request, limit.token());
    const MotionReport report{motion, o.request, o.run.input};
    write_output(o.output, o.json ? text_of(motion_json(report)) : printable(motion_text(report)));
    return 0;
}

}  // namespace

int run_motion(const std::vector<std::string>& arguments) {
    return or_error(arguments, [&] {
        const MotionOptions options = read_motion_options(arguments);
        if (options.help) {
            return 0;
        }
        return within_time(options.run.time_limit, 1, [&](TimeLimit& limit) { return motion_within(options, limit); });
    });
}

}  // namespace ui
