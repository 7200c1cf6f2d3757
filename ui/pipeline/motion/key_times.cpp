#include "ui/pipeline/motion/key_times.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/course.h"
#include "ui/pipeline/motion/rigid_motion.h"

namespace ui {

namespace {

/// Of two poses of a body, how far they are apart; what is there in one only is as far as it is large.
double apart(const MovingBody& body, const std::optional<glm::dmat4>& a, const std::optional<glm::dmat4>& b) {
    if (a && b) {
        return farthest_apart(body.box, *a, *b);
    }
    return a || b ? body.box.diagonal() : 0;
}

class KeySearch {
  public:
    explicit KeySearch(const Motion& motion) : motion_(motion) {
        for (const MovingBody& body : motion.bodies) {
            size_ = std::max(size_, body.box.empty() ? 0 : body.box.diagonal());
        }
    }

    std::vector<double> run(int count) {
        // Those found, and the end of the time.
        std::vector<double> keys{motion_.times.front(), motion_.times.back()};
        const bool closed = difference(keys[0], keys[1]) <= kSame * size_;
        const std::size_t wanted = static_cast<std::size_t>(count) + (closed || count == 1 ? 1 : 0);
        while (keys.size() < wanted) {
            const auto [time, change] = greatest_change(keys);
            keys.push_back(change > kSame * size_ ? time : middle_of_longest(keys));
            std::sort(keys.begin(), keys.end());
        }
        keys.resize(static_cast<std::size_t>(count));
        return keys;
    }

  private:
    static constexpr double kSame = 1e-6;

    [[nodiscard]] double difference(double a, double b) const {
        double most = 0;
        for (const MovingBody& body : motion_.bodies) {
            const Course course(motion_, body);
            most = std::max(most, apart(body, course.at(a), course.at(b)));
        }
        return most;
    }

    [[nodiscard]] std::pair<double, double> greatest_change(const std::vector<double>& keys) const {
        std::pair<double, double> best{motion_.times.front(), 0};
        for (const MovingBody& body : motion_.bodies) {
            const Course course(motion_, body);
            for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
                const auto a = course.at(keys[i]), b = course.at(keys[i + 1]);
                for (const double t : motion_.times) {
                    if (t > keys[i] && t < keys[i + 1]) {
                        const double share = (t - keys[i]) / (keys[i + 1] - keys[i]);
                        const auto led = a && b ? std::optional(between(*a, *b, share)) : a;
                        if (const double change = apart(body, course.at(t), led); change > best.second) {
                            best = {t, change};
                        }
                    }
                }
            }
        }
        return best;
    }

    [[nodiscard]] static double middle_of_longest(const std::vector<double>& keys) {
        std::size_t longest = 0;
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
            // Of equals, to rounding, the first.
            if (keys[i + 1] - keys[i] > (1 + 1e-9) * (keys[longest + 1] - keys[longest])) {
                longest = i;
            }
        }
        return 0.5 * (keys[longest] + keys[longest + 1]);
    }

    const Motion& motion_;
    double size_ = 1e-300;
};

const char* verb(const std::optional<glm::dmat4>& a, const std::optional<glm::dmat4>& b) {
    if (!a || !b) {
        return a ? "vanishes" : "appears";
    }
    const auto screw = screw_of(*b * glm::inverse(*a));
    if (!screw) {
        return "is scaled";
    }
    constexpr double kTurn = 1e-4;  // Radians.
    return screw->angle > kTurn ? "turns" : "slides";
}

/// "door" of "door 2".
std::string without_number(const std::string& name) {
    const std::size_t blank = name.rfind(' ');
    const bool numbered = blank != std::string::npos && blank + 1 < name.size() &&
                          name.find_first_not_of("0123456789", blank + 1) == std::string::npos;
    return numbered ? name.substr(0, blank) : name;
}

}  // namespace

std::vector<double> key_times(const Motion& motion, int count) {
    return KeySearch(motion).run(count);
}

std::string what_moves(const Motion& motion, double from, double to, std::size_t most) {
    struct Movers {
        std::string name, verb;
        double far = 0;
        int count = 0;
    };
    std::vector<Movers> all;
    for (const MovingBody& body : motion.bodies) {
        const Course course(motion, body);
        // There and back is a motion as well.
        std::pair<double, double> farthest{from, 0};
        std::vector<double> times{0.5 * (from + to), to};
        times.insert(times.end(), motion.times.begin(), motion.times.end());
        for (const double t : times) {
            if (t > from && t <= to) {
                const double far = apart(body, course.at(from), course.at(t));
                farthest = far > farthest.second ? std::pair(t, far) : farthest;
            }
        }
        if (farthest.second <= 10 * motion.error + 1e-9 * std::max(1e-300, body.box.diagonal())) {
            continue;
        }
        const std::string name = without_number(body.name);
        const char* const does = verb(course.at(from), course.at(farthest.first));
        const auto known = std::find_if(
            all.begin(), all.end(), [&](const Movers& movers) { return movers.name == name && movers.verb == does; });
        Movers& movers = known == all.end() ? all.emplace_back(Movers{name, does}) : *known;
        movers.far = std::max(movers.far, farthest.second);
        ++movers.count;
    }
    std::stable_sort(all.begin(), all.end(), [](const Movers& a, const Movers& b) { return a.far > b.far; });
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i) {
        texts.push_back(all[i].count == 1 ? fmt::format("{} {}", all[i].name, all[i].verb)
                                          : fmt::format("{} ×{} {}", all[i].name, all[i].count, all[i].verb));
    }
    if (all.size() > most) {
        texts.push_back(fmt::format("{} more", all.size() - most));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace ui
