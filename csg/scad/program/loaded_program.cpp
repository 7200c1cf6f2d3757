#include "csg/scad/program/loaded_program.h"

#include <algorithm>
#include <new>

#include "base/stop.h"
#include "csg/scad/machine/evaluator.h"
#include "csg/scad/program/message_gate.h"

namespace csg::scad {

namespace {

/// What definitions may leave behind before the program is rather parsed again.
constexpr std::size_t kMostLeftBehind = std::size_t{1} << 20;

/// Adds the files that an evaluation asked for to those of its result, however it ends.
class DataFiles {
  public:
    DataFiles(const Evaluator& evaluator, Evaluation& evaluation) : evaluator_(evaluator), evaluation_(evaluation) {}
    ~DataFiles() {
        for (const auto& file : evaluator_.data_files()) {
            evaluation_.files.push_back(file.first);
            evaluation_.looked_for.push_back(file);
        }
    }
    DataFiles(const DataFiles&) = delete;
    DataFiles& operator=(const DataFiles&) = delete;

  private:
    const Evaluator& evaluator_;
    Evaluation& evaluation_;
};

}  // namespace

LoadedProgram::LoadedProgram(Parsed parsed, std::vector<std::string> definitions)
    : parsed_(std::move(parsed)),
      defined_(std::move(definitions)),
      definitions_ok_(parsed_.ok),
      parsed_nodes_(parsed_.program.expressions.size() + parsed_.program.lazy.most.expressions) {
    const auto first = parsed_.messages.begin() + static_cast<std::ptrdiff_t>(parsed_.main_messages);
    const auto last = first + static_cast<std::ptrdiff_t>(parsed_.definition_messages);
    definition_messages_.assign(std::make_move_iterator(first), std::make_move_iterator(last));
    parsed_.messages.erase(first, last);
}

LoadedProgram::~LoadedProgram() = default;

bool LoadedProgram::can_define(const std::vector<std::string>& definitions) const {
    const std::scoped_lock lock(mutex_);
    return definitions == defined_ ||
           (parsed_.ok && !may_name_files(definitions) && !(defined_ && may_name_files(*defined_)));
}

void LoadedProgram::define(const std::vector<std::string>& definitions) {
    const std::scoped_lock lock(mutex_);
    set_definitions(definitions);
}

void LoadedProgram::forget_code() {
    const std::scoped_lock lock(mutex_);
    compiled_.reset();
}

std::vector<Message> LoadedProgram::messages() const {
    const std::scoped_lock lock(mutex_);
    const auto behind_main = parsed_.messages.begin() + static_cast<std::ptrdiff_t>(parsed_.main_messages);
    std::vector<Message> all(parsed_.messages.begin(), behind_main);
    all.insert(all.end(), definition_messages_.begin(), definition_messages_.end());
    if (definitions_ok_) {
        all.insert(all.end(), behind_main, parsed_.messages.end());
    }
    return all;
}

/// Only what the definitions change is worked out anew.
void LoadedProgram::set_definitions(const std::vector<std::string>& definitions) {
    if (!parsed_.ok || definitions == defined_) {
        return;
    }
    defined_.reset();
    definition_messages_.clear();
    definitions_ok_ = parsed_.definitions.set(parsed_.program, definitions,
                                              [this](const Message& m) { definition_messages_.push_back(m); });
    make_room(parsed_.program, true);
    if (compiled_ != nullptr && compiled_names_ == parsed_.definitions.other_names()) {
        compiled_->redefine(parsed_.program);
    } else {
        compiled_.reset();
    }
    defined_ = definitions;
    spent_ = parsed_.program.expressions.size() > parsed_nodes_ + kMostLeftBehind;
}

void LoadedProgram::build_all() {
    Program& program = parsed_.program;
    for (std::uint32_t f = 0; f < program.functions.size(); ++f) {  // A body may define more.
        build_function_body(program, f);
    }
    for (std::uint32_t m = 0; m < program.modules.size(); ++m) {
        build_module_body(program, m);
    }
}

/// Those that were read before it was known that the definitions are wrong, where they are.
void LoadedProgram::tell_files(Evaluation& result) const {
    const SourceSet& sources = parsed_.program.sources;
    const auto read = static_cast<std::uint32_t>(definitions_ok_ ? sources.size() : parsed_.main_sources);
    for (std::uint32_t file = 0; file < read; ++file) {
        const std::string& name = sources[file].name();
        if (name != kCommandLine && std::find(result.files.begin(), result.files.end(), name) == result.files.end()) {
            result.files.push_back(name);
        }
    }
}

void LoadedProgram::run(const Request& request, const EvaluationSink& sink, const char* stack_limit,
                        Evaluation& result) {
    const std::scoped_lock lock(mutex_);
    set_definitions(request.definitions);
    const auto sources = std::make_shared<const SourceSet>(parsed_.program.sources);
    result.sources = sources;
    tell_files(result);
    MessageGate gate(sink, *sources, result);
    const auto tell = [&gate](const std::vector<Message>& messages, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            gate(messages[i]);
        }
    };
    tell(parsed_.messages, 0, parsed_.main_messages);
    tell(definition_messages_, 0, definition_messages_.size());
    if (!definitions_ok_) {
        return;
    }
    tell(parsed_.messages, parsed_.main_messages, parsed_.messages.size());
    result.parsed = true;
    evaluate(
        request, stack_limit, [&gate](const Message& m) { gate(m); }, result);
    if (result.out_of_memory) {
        compiled_.reset();  // Whatever was under way.
    }
}

void LoadedProgram::evaluate(const Request& request, const char* stack_limit, const MessageSink& gate,
                             Evaluation& result) {
    try {
        if (compiled_ == nullptr) {
            make_room(parsed_.program, true);
            compiled_ = std::make_unique<Compiled>(parsed_.program);
            compiled_names_ = parsed_.definitions.other_names();
        }
        Evaluator evaluator(parsed_.program, *compiled_, request, gate, stack_limit);
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

}  // namespace csg::scad
