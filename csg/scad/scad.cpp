// From a request to a tree: reading, parsing and evaluating on a thread with a deep stack.
#include "csg/scad/scad.h"

#include <pthread.h>

#include <algorithm>
#include <exception>
#include <new>
#include <set>
#include <string>
#include <tuple>

#include "base/stop.h"
#include "csg/scad/machine/evaluator.h"
#include "csg/scad/syntax/parser.h"

namespace csg::scad {

namespace {

constexpr std::size_t kSmallestStack = std::size_t{16} << 20;
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t kLargestStack = std::size_t{60} << 20;  // The sanitizer loses track when more is unwound at once.
#else
constexpr std::size_t kLargestStack = std::size_t{64} << 30;
#endif
constexpr std::size_t kStackReserve = std::size_t{4} << 20;  // For what runs without asking: built-ins, messages.

/// Passes messages on and counts them; of a run of equal ones only the first few, of equal deprecations only the first,
/// as OpenSCAD does.
class MessageGate {
  public:
    MessageGate(const EvaluationSink& sink, const SourceSet& sources, Evaluation& evaluation)
        : sink_(sink), sources_(sources), evaluation_(evaluation) {}

    void operator()(const Message& message) {
        const bool counts = message.severity != Severity::Echo && message.severity != Severity::Info;
        evaluation_.errors += message.severity == Severity::Error;
        evaluation_.warnings += message.severity == Severity::Warning || message.severity == Severity::Deprecated;
        if (message.severity == Severity::Deprecated &&
            !deprecations_.emplace(message.where.file, message.where.line, message.text).second) {
            return;
        }
        if (counts) {
            const bool same = message.text == last_.text && message.severity == last_.severity &&
                              message.where.file == last_.where.file && message.where.line == last_.where.line;
            repeated_ = same ? repeated_ + 1 : 1;
            if (repeated_ > kMostEqual) {
                return;
            }
            last_ = message;
        }
        if (sink_) {
            sink_(message, sources_);
        }
    }

  private:
    static constexpr unsigned kMostEqual = 5;
    const EvaluationSink& sink_;
    const SourceSet& sources_;
    Evaluation& evaluation_;
    Message last_;
    unsigned repeated_ = 0;
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::string>> deprecations_;
};

/// Adds the files that an evaluation asked for to those of its result, however it ends.
class DataFiles {
  public:
    DataFiles(const Evaluator& evaluator, Evaluation& evaluation) : evaluator_(evaluator), evaluation_(evaluation) {}
    ~DataFiles() {
        const auto& files = evaluator_.data_files();
        evaluation_.files.insert(evaluation_.files.end(), files.begin(), files.end());
    }
    DataFiles(const DataFiles&) = delete;
    DataFiles& operator=(const DataFiles&) = delete;

  private:
    const Evaluator& evaluator_;
    Evaluation& evaluation_;
};

/// The work of `evaluate`; may throw.
class Job {
  public:
    Job(const Request& request, const EvaluationSink& sink) : request_(request), sink_(sink) {}

    void run(const char* stack_limit) {
        Parsed parsed = read_and_parse();
        const auto program = std::make_shared<Program>(std::move(parsed.program));
        result.sources = std::shared_ptr<const SourceSet>(program, &program->sources);
        for (std::uint32_t file = 0; file < program->sources.size(); ++file) {
            const std::string& name = program->sources[file].name();
            if (name != kCommandLine &&
                std::find(result.files.begin(), result.files.end(), name) == result.files.end()) {
                result.files.push_back(name);
            }
        }
        MessageGate gate(sink_, program->sources, result);
        for (const Message& message : parsed.messages) {
            gate(message);
        }
        if (!parsed.ok) {
            return;
        }
        result.parsed = true;
        try {
            Evaluator evaluator(
                *program, request_, [&gate](const Message& m) { gate(m); }, stack_limit);
            const DataFiles files(evaluator, result);
            ViewSettings view;
            result.tree = std::make_shared<const Tree>(evaluator.run(view));
            result.view = view;
            result.ok = true;
        } catch (const EvaluationError& error) {
            result.stopped = error.stopped;
            result.out_of_memory = error.out_of_memory;
            gate(error.message);
            for (const Message& message : error.trace) {
                gate(message);
            }
        } catch (const ValueLimit& limit) {
            gate({Severity::Error, {}, limit.what()});
        } catch (const base::Stopped&) {
            result.stopped = true;
            gate({Severity::Error, {}, "Stopped"});
        } catch (const std::bad_alloc&) {
            result.out_of_memory = true;
            gate({Severity::Error, {}, "Out of memory"});
        }
    }

    /// A failure outside the program.
    void fail(std::string text) {
        ++result.errors;
        if (result.sources == nullptr) {
            result.sources = std::make_shared<const SourceSet>();
        }
        if (sink_) {
            sink_({Severity::Error, {}, std::move(text)}, *result.sources);
        }
    }

    Evaluation result;

  private:
    Parsed read_and_parse() {
        ParseRequest parse_request{request_.path,        {},   request_.definitions, request_.reader,
                                   request_.search_path, true, request_.make_missing};
        if (request_.text) {
            parse_request.text = *request_.text;
            return parse(parse_request);
        }
        ReadResult text = request_.reader(request_.path);
        if (const auto* error = std::get_if<ReadError>(&text)) {
            Parsed parsed;
            parsed.messages.push_back({Severity::Error, {}, error->text});
            return parsed;
        }
        parse_request.text = std::get<std::string>(std::move(text));
        return parse(parse_request);
    }

    const Request& request_;
    const EvaluationSink& sink_;
};

struct ThreadStart {
    Job& job;
    std::size_t stack_bytes;
};

void* run_on_thread(void* argument) {
    const auto& start = *static_cast<ThreadStart*>(argument);
    const char top = 0;
    try {
        start.job.run(&top - (start.stack_bytes - kStackReserve));
    } catch (const std::bad_alloc&) {
        start.job.result.out_of_memory = true;
        start.job.fail("Out of memory");
    } catch (const std::exception& error) {
        start.job.fail(error.what());
    }
    return nullptr;
}

}  // namespace

Evaluation evaluate(const Request& request, const EvaluationSink& sink) {
    Job job(request, sink);
    ThreadStart start{job, std::clamp(request.limits.stack_bytes, kSmallestStack, kLargestStack)};
    pthread_attr_t attributes;
    pthread_t thread{};
    pthread_attr_init(&attributes);
    const bool started = pthread_attr_setstacksize(&attributes, start.stack_bytes) == 0 &&
                         pthread_create(&thread, &attributes, run_on_thread, &start) == 0;
    pthread_attr_destroy(&attributes);
    if (started) {
        pthread_join(thread, nullptr);
    } else {
        job.result.out_of_memory = true;  // Its stack is the most that a thread needs.
        job.fail("Cannot start a thread for the evaluation");
    }
    return std::move(job.result);
}

}  // namespace csg::scad
