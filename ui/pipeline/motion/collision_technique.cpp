#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "ui/pipeline/motion/contact.h"
#include "ui/pipeline/motion/star.h"
#include "ui/pipeline/motion/techniques.h"

namespace ui {

void draw_collisions(DepictionStage& stage, const DepictionTask& task, const MovingBody& body,
                     const std::stop_token& stop) {
    constexpr csg::Rgba kStar{1.0F, 0.72F, 0.1F, 1};
    constexpr double kOfRadius = 10;
    const Depiction& d = task.what;
    const auto meant = [&](const std::string& name) {
        return d.with == "*" || (!name.empty() && names_body(d.with, name));
    };
    const std::vector<Contact> contacts = contacts_of(stage.source.motion, body, meant, task.from, task.to, stop);
    if (contacts.empty()) {
        throw std::runtime_error(fmt::format("{} begins to touch nothing{} between $t = {:g} and {:g}", body.name,
                                             d.with == "*" ? "" : fmt::format(" that is called {}", d.with), task.from,
                                             task.to));
    }
    for (const Contact& contact : contacts) {
        stage.add(star(contact.point, kOfRadius * task.radius), d.color.value_or(kStar));
        if (!d.say.empty()) {
            stage.bubbles.push_back({contact.point, d.say, d.color});
        }
    }
}

}  // namespace ui
