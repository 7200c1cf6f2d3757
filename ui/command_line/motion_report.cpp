#include "ui/command_line/motion_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ui/pipeline/motion/character.h"
#include "ui/pipeline/plain_text.h"
#include "ui/pipeline/statistics.h"

namespace ui {

namespace {

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

std::string point(const glm::dvec3& p, double scale) {
    return fmt::format("[{}, {}, {}]", number_text(p.x, scale), number_text(p.y, scale), number_text(p.z, scale));
}

std::string place(const Motion& motion, const MovingBody& body) {
    const auto& files = motion.tree->files();
    return body.where.known() && body.where.file < files.size()
               ? fmt::format(" ({}:{}:{})", files[body.where.file], body.where.line, body.where.column)
               : "";
}

std::string axis(const Character& c) {
    return fmt::format("about {} through {}", point(c.axis, 1), point(c.point, 1));
}

std::string net(double value, double whole, const char* unit) {
    return std::abs(value) < whole * (1 - 1e-9) ? fmt::format(", {}{} of it one way", number_text(value, whole), unit)
                                                : "";
}

std::string course(const Character& c) {
    const double turned = degrees(c.turned), turned_net = degrees(c.turned_net);
    switch (c.kind) {
        case Character::Kind::Stays:
            return "stays where it is";
        case Character::Kind::Turns:
            return fmt::format("turns by {}° {}{}", number_text(turned, 1), axis(c), net(turned_net, turned, "°"));
        case Character::Kind::Slides:
            return fmt::format("slides {} along {}{}", number_text(c.way, 1), point(c.axis, 1),
                               net(c.way_net, c.way, ""));
        case Character::Kind::Screws:
            return fmt::format("turns by {}° {} and slides {} along it", number_text(turned, 1), axis(c),
                               number_text(c.way_net, c.way));
        case Character::Kind::Travels:
            return fmt::format("travels {} on a curve, without turning; its ends are {} apart", number_text(c.way, 1),
                               number_text(c.way_net, c.way));
        case Character::Kind::Moves:
            return fmt::format("turns by {}° in all, while its middle goes {}; its ends are {} apart",
                               number_text(turned, 1), number_text(c.way, 1), number_text(c.way_net, c.way));
        case Character::Kind::Deforms:
            return "is scaled or sheared";
    }
    return "";
}

std::string event_text(const MotionEvent& event) {
    const std::string when = fmt::format("at $t = {:.6g}", 0.5 * (event.after + event.before));
    switch (event.kind) {
        case MotionEvent::Kind::Jumps:
            return fmt::format("jumps by {:.6g} {}", event.distance, when);
        case MotionEvent::Kind::Appears:
            return "appears " + when;
        case MotionEvent::Kind::Vanishes:
            return "vanishes " + when;
    }
    return "";
}

const char* name(MotionEvent::Kind kind) {
    return kind == MotionEvent::Kind::Jumps ? "jumps" : kind == MotionEvent::Kind::Appears ? "appears" : "vanishes";
}

Json vector_json(const std::optional<glm::dvec3>& v) {
    return v ? to_json(*v) : Json(nullptr);
}

Json pose_json(double time, const std::optional<Pose>& pose) {
    if (!pose) {
        return {{"t", time}, {"matrix", nullptr}};
    }
    Json rows = Json::array();
    for (int r = 0; r < 4; ++r) {
        rows.push_back({pose->motion[0][r], pose->motion[1][r], pose->motion[2][r], pose->motion[3][r]});
    }
    return {{"t", time},
            {"matrix", rows},
            {"center", to_json(pose->center)},
            {"velocity", vector_json(pose->velocity)},
            {"acceleration", vector_json(pose->acceleration)},
            {"turning", vector_json(pose->turning)}};
}

Json character_json(const Character& c) {
    Json out = {{"kind", name(c.kind)}};
    if (c.axis != glm::dvec3(0.0)) {
        out["axis"] = to_json(c.axis);
    }
    if (c.kind == Character::Kind::Turns || c.kind == Character::Kind::Screws) {
        out["point"] = to_json(c.point);
        out["turned_net"] = degrees(c.turned_net);
    }
    out["turned"] = degrees(c.turned);
    out["way"] = c.way;
    out["way_net"] = c.way_net;
    out["fastest"] = c.fastest;
    out["fastest_at"] = c.fastest_at;
    return out;
}

}  // namespace

std::string motion_text(const MotionReport& report) {
    const Motion& m = report.motion;
    std::string out = fmt::format("{}: $t from {:.6g} to {:.6g}, {} samples, between them known to within {:.2g}\n",
                                  report.file, report.request.from, report.request.to, m.times.size(), m.error);
    if (!m.complete) {
        out += fmt::format("The motion needs more than {} samples: what is between them may be farther off.\n",
                           report.request.most_samples);
    }
    if (m.bodies.empty()) {
        return out + "Nothing moves.\n";
    }
    out += fmt::format("{} of {} leaves move, as {} {}\n", m.leaves - m.still, m.leaves, m.bodies.size(),
                       m.bodies.size() == 1 ? "body" : "bodies");
    for (const MovingBody& body : m.bodies) {
        const Character c = character_of(m, body);
        out += fmt::format("\n{}{}\n   {}\n", body.name, place(m, body), course(c));
        if (c.fastest > 0) {
            out += fmt::format("   fastest at $t = {:.4g}: {:.6g} per unit of $t\n", c.fastest_at, c.fastest);
        }
        for (const MotionEvent& event : body.events) {
            out += fmt::format("   {}\n", event_text(event));
        }
        if (body.changes_shape) {
            out += "   changes its shape\n";
        }
    }
    return out;
}

Json motion_json(const MotionReport& report) {
    const Motion& m = report.motion;
    Json bodies = Json::array();
    for (const MovingBody& body : m.bodies) {
        Json events = Json::array();
        for (const MotionEvent& event : body.events) {
            Json e = {{"kind", name(event.kind)}, {"after", event.after}, {"before", event.before}};
            if (event.kind == MotionEvent::Kind::Jumps) {
                e["distance"] = event.distance;
            }
            events.push_back(std::move(e));
        }
        Json poses = Json::array();
        for (std::size_t i = 0; i < m.times.size(); ++i) {
            poses.push_back(pose_json(m.times[i], body.poses[i]));
        }
        const auto& files = m.tree->files();
        bodies.push_back({{"name", body.name},
                          {"file", body.where.file < files.size() ? Json(files[body.where.file]) : Json(nullptr)},
                          {"line", body.where.line},
                          {"column", body.where.column},
                          {"box", {to_json(body.box.lo), to_json(body.box.hi)}},
                          {"motion", character_json(character_of(m, body))},
                          {"changes_shape", body.changes_shape},
                          {"events", events},
                          {"poses", poses}});
    }
    return {
        {"file", report.file}, {"from", report.request.from}, {"to", report.request.to}, {"samples", m.times.size()},
        {"error", m.error},    {"complete", m.complete},      {"leaves", m.leaves},      {"still", m.still},
        {"bodies", bodies}};
}

}  // namespace ui
