#include <malloc.h>

#include "ui/command_line/run.h"

int main(int argc, char** argv) {
    // Mesa's software renderer allocates and frees megabytes in every frame. Left alone, glibc maps and unmaps them
    // each time and every page is faulted in anew, which costs half of the frame; so they are kept on the heap.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_TOP_PAD, 64 << 20);
    return ui::run({argv + 1, argv + argc});
}
