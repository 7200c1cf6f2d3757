// The whole program; `csgscope` hands over to it what takes more than the language.
#include "ui/command_line/run.h"
#include "ui/pipeline/heap.h"

int main(int argc, char** argv) {
    ui::keep_freed_memory();
    return ui::run({argv + 1, argv + argc});
}
