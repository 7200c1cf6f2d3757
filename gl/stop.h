// base/stop.h under the name that the engines and styles use.
#pragma once

#include "base/stop.h"

namespace gl {

using base::end_if_asked;
using base::Stopped;

}  // namespace gl
