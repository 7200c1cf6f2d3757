#include "csg/scad/program/message_gate.h"

namespace csg::scad {

void MessageGate::operator()(const Message& message) {
    const bool counts = message.severity != Severity::Echo && message.severity != Severity::Info;
    evaluation_.errors += message.severity == Severity::Error;
    evaluation_.warnings += message.severity == Severity::Warning || message.severity == Severity::Deprecated;
    if (message.severity == Severity::Deprecated &&
        !deprecations_.emplace(message.where.file, message.where.line, message.text).second) {
        return;
    }
    if (counts) {
        const bool same = message.text == last_.text && message.severity == last_.severity &&
                          message.where.file == last_.where.file && message.where.line == last_.where.line;
        repeated_ = same ? repeated_ + 1 : 1;
        if (repeated_ > kMostEqual) {
            return;
        }
        last_ = message;
    }
    if (sink_) {
        sink_(message, sources_);
    }
}

}  // namespace csg::scad
