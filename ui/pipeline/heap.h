// How the process's heap treats freed memory.
#pragma once

namespace ui {

/// To be called first in main(). Mesa's software renderer allocates and frees megabytes in every frame. Left alone,
/// glibc maps and unmaps them each time and every page is faulted in anew, which costs half of the frame; so they are
/// kept on the heap.
void keep_freed_memory();

}  // namespace ui
