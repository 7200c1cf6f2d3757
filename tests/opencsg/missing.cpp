// In place of opencsg.cpp where the library is missing.
#include "tests/opencsg/opencsg.h"

namespace opencsg {

bool built() {
    return false;
}

MaybeOpenCsg create(glm::ivec2 /*largest_size*/) {
    return {nullptr, "the library was missing when this was built"};
}

}  // namespace opencsg
