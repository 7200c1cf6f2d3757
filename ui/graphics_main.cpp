// The whole program; `csgscope` hands over to it what takes more than the language.
#include "base/temporary_names.h"
#include "ui/command_line/run.h"
#include "ui/command_line/standard_streams.h"
#include "ui/pipeline/heap.h"

int main(int argc, char** argv) {
    ui::hold_standard_streams();
    base::remove_temporary_names_at_signals();
    ui::keep_freed_memory();
    return ui::run({argv + 1, argv + argc});
}
