// From a request to a tree: reading, parsing and evaluating on a thread with a deep stack.
#include "csg/scad/scad.h"

#include <exception>
#include <new>
#include <string>

#include "csg/scad/program/deep_thread.h"
#include "csg/scad/program/loaded_program.h"
#include "csg/scad/program/loading.h"
#include "csg/scad/program/message_gate.h"

namespace csg::scad {

Evaluation evaluate_with(const Request& request, const EvaluationSink& sink, bool once, const Load& load) {
    Evaluation result;
    const auto fail = [&](std::string text) {
        if (result.sources == nullptr) {
            result.sources = std::make_shared<const SourceSet>();
        }
        MessageGate(sink, *result.sources, result)({Severity::Error, {}, std::move(text)});
    };
    const bool started = run_deep(request.limits.stack_bytes, [&](const char* stack_limit) {
        try {
            std::vector<Message> messages;
            const std::shared_ptr<LoadedProgram> program = load(result, messages);
            result.program = program;
            if (program != nullptr) {
                program->run(request, sink, stack_limit, result);
                if (once) {
                    program->forget_code();
                }
            }
            for (Message& message : messages) {
                fail(std::move(message.text));
            }
        } catch (const std::bad_alloc&) {
            result.out_of_memory = true;
            fail("Out of memory");
        } catch (const std::exception& error) {
            fail(error.what());
        }
    });
    if (!started) {
        result.out_of_memory = true;  // Its stack is the most that a thread needs.
        fail("Cannot start a thread for the evaluation");
    }
    return result;
}

Evaluation evaluate(const Request& request, const EvaluationSink& sink) {
    return evaluate_with(request, sink, true, [&](Evaluation&, std::vector<Message>& messages) {
        Loading loading(request, nullptr, nullptr);
        SourceResult main = loading.main();
        if (auto* const error = std::get_if<ReadError>(&main)) {
            messages.push_back({Severity::Error, {}, std::move(error->text)});
            return std::shared_ptr<LoadedProgram>();
        }
        return std::make_shared<LoadedProgram>(loading.parse(std::get<SharedSource>(main)), request.definitions);
    });
}

}  // namespace csg::scad
