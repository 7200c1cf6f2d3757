// Random models as RapidCheck generators: a failing model is shrunk by leaving things out.
#pragma once

#include <rapidcheck.h>

#include "tests/random/random_tree.h"

namespace random_tree {

[[nodiscard]] inline rc::Gen<Model> arbitrary_model(const Options& options = {}) {
    return [options](const rc::Random& random, int) {
        rc::Random seeds = random;
        std::mt19937_64 engine(seeds.next());
        return rc::shrinkable::shrinkRecur(make_model(engine, options),
                                           [](const Model& model) { return rc::seq::fromContainer(simpler(model)); });
    };
}

/// How RapidCheck shows a model.
inline void showValue(const Model& model, std::ostream& os) {
    os << '\n' << scad_text(model);
}

}  // namespace random_tree
