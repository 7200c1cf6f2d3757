// What is passed on of the messages of an evaluation, and what is only counted.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <tuple>

#include "csg/scad/scad.h"

namespace csg::scad {

/// Passes messages on and counts them; of a run of equal ones only the first few, of equal deprecations only the first,
/// as OpenSCAD does.
class MessageGate {
  public:
    /// All must outlive it.
    MessageGate(const EvaluationSink& sink, const SourceSet& sources, Evaluation& evaluation)
        : sink_(sink), sources_(sources), evaluation_(evaluation) {}

    void operator()(const Message& message);

  private:
    static constexpr unsigned kMostEqual = 5;
    const EvaluationSink& sink_;
    const SourceSet& sources_;
    Evaluation& evaluation_;
    Message last_;
    unsigned repeated_ = 0;
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::string>> deprecations_;
};

}  // namespace csg::scad
