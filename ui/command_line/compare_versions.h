// csgscope compare OLD NEW: what has changed from one version of a model to the next.
#pragma once

#include "ui/command_line/compare_options.h"

namespace ui {

/// Prints the volumes of what is new and of what is gone, from exact meshes; a picture is csgscope --changes-from's.
/// 0: they are the same solid; 1: they differ. Throws ModelError, UsageError, base::Stopped.
int compare_versions(const CompareOptions& options);

}  // namespace ui
