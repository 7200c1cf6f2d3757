// What there is to say about the making of objects.
#pragma once

#include <string>
#include <vector>

namespace csg::solid {

struct Remarks {
    std::vector<std::string> warnings;  ///< Of what is made as asked, as far as can be told.
    std::vector<std::string>
        failures;  ///< What is missing of what was asked for, and why. No export may go by the rest.
};

}  // namespace csg::solid
