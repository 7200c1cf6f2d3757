// What hands do to the text: commands that edit it, and what becomes of the model and the selection.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "ui/pipeline/editing/statement_edits.h"
#include "ui/viewer/session.h"

namespace ui {

namespace {

std::optional<AddedShape> shape_of(Action action) {
    switch (action) {
        case Action::AddCube:
            return AddedShape::Cube;
        case Action::AddSphere:
            return AddedShape::Sphere;
        case Action::AddCylinder:
            return AddedShape::Cylinder;
        case Action::AddCone:
            return AddedShape::Cone;
        case Action::AddText:
            return AddedShape::Text;
        case Action::AddExtrusion:
            return AddedShape::Extrusion;
        default:
            return std::nullopt;
    }
}

/// What the call is of; empty where none is known.
std::string name_at(const Model& model, csg::OccurrenceId occurrence) {
    const csg::Statement* const call = model.tree->statement(model.scene.occurrences[occurrence].node);
    return call != nullptr ? call->name : "";
}

std::string done_by(const MoveAnswer& answer) {
    return gesture_of(answer.held).verb + ' ' + answer.what;
}

/// About a sixth of what is seen.
double size_in(const base::Camera& camera) {
    return round_number(std::max(2 * camera.distance * std::tan(camera.fov / 360 * glm::pi<double>()) / 6, 1e-3));
}

}  // namespace

bool Session::edit_by_hand(const Command& command) {
    if (const auto* hold = std::get_if<HoldPart>(&command)) {
        held_ = hold->held;
    } else if (const auto* put_there = std::get_if<PutPart>(&command)) {
        put(put_there->held);
    } else if (const auto* way = std::get_if<TakeWay>(&command)) {
        take_way(way->way);
    } else if (const auto* number = std::get_if<SetNumber>(&command)) {
        set_number(*number);
    } else if (const auto* typed = std::get_if<TypeText>(&command)) {
        constexpr double kPause = 1;  // Seconds between what are two steps.
        if (now_ - typed_at_ > kPause) {
            editing_.text().pause();
        }
        typed_at_ = now_;
        editing_.text().set_text(typed->text, "typing", true);
        follow_text();
    } else if (const auto* place = std::get_if<SelectByte>(&command)) {
        const auto statement = in_step() ? statement_at(editing_.text().text(), place->byte) : std::nullopt;
        if (statement) {
            select_again({0, 0, 0, {}, statement->bytes});
        }
    } else if (const auto* conflict = std::get_if<ResolveConflict>(&command)) {
        editing_.text().resolve(conflict->conflict, conflict->take_theirs);
        follow_text();
    } else if (const auto* recovered = std::get_if<Recover>(&command)) {
        editing_.recover(recovered->take);
        shown_.recovery_form = false;
        follow_text();
    } else {
        return false;
    }
    return true;
}

bool Session::edit_text(Action action) {
    if (const auto shape = shape_of(action)) {
        add_shape(*shape);
        return true;
    }
    if (arrange(action)) {
        return true;
    }
    switch (action) {
        case Action::Save:
            save();
            break;
        case Action::Undo:
        case Action::Redo:
            if (action == Action::Undo ? editing_.text().undo() : editing_.text().redo()) {
                follow_text();
            }
            break;
        case Action::Duplicate:
        case Action::DeleteSelected:
            edit_statement(action);
            break;
        case Action::ToggleHole:
            shown_.hole = !shown_.hole;
            break;
        case Action::Palette:
            shown_.palette = !shown_.palette;
            break;
        default:
            return false;
    }
    return true;
}

void Session::follow_text() {
    ways_.reset();
    document_.edit(editing_.unsaved_text());
    evaluate();
}

void Session::save() {
    if (const std::string trouble = editing_.save(); !trouble.empty()) {
        document_.add_message(LineKind::Error, "ERROR: " + trouble);
    }
    document_.edit(editing_.unsaved_text());
}

void Session::look_at_disk() {
    const TextDocument::FromDisk news = editing_.look_at_disk();
    if (news != TextDocument::FromDisk::Same) {
        ways_.reset();
    }
    document_.edit(editing_.unsaved_text());
}

void Session::discard_edits() {
    editing_.discard();
    document_.edit(std::nullopt);
}

bool Session::in_step() const {
    const auto& sources = document_.model_sources();
    return editing_.possible() && document_.model() && sources && sources->size() > 0 &&
           !document_.source().explained && (*sources)[0].text() == editing_.text().text();
}

bool Session::can_move() const {
    return !moving_.busy() && in_step();
}

std::optional<std::size_t> Session::byte_of(const csg::SourceLocation& where) const {
    const auto& sources = document_.model_sources();
    const auto& files = document_.model()->tree->files();
    if (!where.known() || where.file >= files.size() || files[where.file] != (*sources)[0].name()) {
        return std::nullopt;
    }
    return (*sources)[0].offset(where.line, where.column);
}

std::optional<StatementText> Session::selected_statement() const {
    if (!in_step()) {
        return std::nullopt;
    }
    const Model& model = *document_.model();
    for (csg::OccurrenceId at = selected_; at < model.scene.occurrences.size();
         at = model.scene.occurrences[at].parent) {
        if (const auto byte = byte_of(model.tree->node(model.scene.occurrences[at].node).where)) {
            return statement_at(editing_.text().text(), *byte);
        }
    }
    return std::nullopt;
}

glm::dmat4 Session::into_statement(const StatementText& statement) const {
    const Model& model = *document_.model();
    glm::dmat4 to_world(1.0);
    for (const csg::OccurrenceId at : path_to(model.scene, selected_)) {
        const csg::NodeId node = model.scene.occurrences[at].node;
        const auto byte = byte_of(model.tree->node(node).where);
        if (byte && *byte >= statement.bytes.begin && *byte < statement.bytes.end) {
            break;
        }
        if (model.tree->node(node).operation == csg::Operation::Transform) {
            to_world = to_world * model.tree->matrix(node);
        }
    }
    return std::abs(glm::determinant(to_world)) > 1e-12 ? glm::inverse(to_world) : glm::dmat4(1.0);
}

void Session::add_shape(AddedShape shape) {
    if (!editing_.possible()) {
        document_.add_message(LineKind::Warning, "WARNING: open a program to add to");
        return;
    }
    const auto statement = shown_.hole ? selected_statement() : std::nullopt;
    if (shown_.hole && !statement) {
        document_.add_message(LineKind::Warning, "WARNING: select the solid that the hole is to be in");
        return;
    }
    const double size = size_in(view_.picture.camera);
    const csg::Box all = document_.model() ? document_.model()->box : csg::Box{};
    glm::dvec3 at(0.0);
    if (!selection_.empty()) {
        at = selection_.current().surface.point;
    } else if (const csg::Box box = document_.model() ? box_below(*document_.model(), selected_) : csg::Box{};
               !box.empty()) {
        at = {box.center().x, box.center().y, box.hi.z};
    } else if (!all.empty()) {
        at = {all.hi.x + size, all.center().y, all.lo.z};  // Beside the model.
    }
    if (statement) {
        at = glm::dvec3(into_statement(*statement) * glm::dvec4(at, 1.0));
    }
    const std::string text = statement_of(shape, size, at, shown_.hole);
    TextDocument& document = editing_.text();
    StatementEdit edit = statement ? subtract_from_statement(document.text(), *statement, text)
                                   : append_statement(document.text(), text);
    document.edit({std::move(edit.edit)}, "add");
    select_next_ = SelectNext{0, 0, 0, {}, edit.added};
    follow_text();
}

void Session::edit_statement(Action action) {
    const auto statement = selected_statement();
    if (!statement) {
        document_.add_message(LineKind::Warning, "WARNING: select something of this file first");
        return;
    }
    TextDocument& document = editing_.text();
    const bool doubles = action == Action::Duplicate;
    StatementEdit edit =
        doubles ? double_statement(document.text(), *statement) : delete_statement(document.text(), *statement);
    document.edit({std::move(edit.edit)}, doubles ? "duplicate" : "delete");
    select_next_ = SelectNext{0, 0, 0, {}, doubles ? std::optional(edit.added) : std::nullopt};
    follow_text();
}

void Session::put(const HeldPart& held) {
    held_ = held;
    const auto& model = document_.model();
    const csg::LeafId leaf = model && can_move() ? first_leaf_below(model->scene, held.occurrence) : 0;
    if (!model || !can_move() || leaf >= model->scene.leaves.size() || held.motion() == glm::dmat4(1.0)) {
        held_ = {};
        return;
    }
    const csg::NodeId node = model->scene.occurrences[held.occurrence].node;
    const csg::Statement* const call = model->tree->statement(node);
    ways_.reset();
    const MoveQuestion question{document_.source(),
                                scad_view(view_.picture.camera),
                                editing_.text().text(),
                                name_of(*model->tree, model->scene, leaf),
                                model->tree->node(node).where,
                                call != nullptr ? call->name : "it",
                                held,
                                leaves_below(model->scene, held.occurrence)};
    moving_.start([find = find_ways_, question](const std::stop_token& stop) { return find(question, stop); });
}

void Session::take_ways(MoveAnswer answer) {
    if (answer.text != editing_.text().text()) {
        held_ = {};  // Somebody else was quicker.
        return;
    }
    if (answer.ways.empty()) {
        held_ = {};
        ways_ = std::move(answer);
        return;
    }
    editing_.text().edit(answer.ways[0].edits, done_by(answer));
    const HeldPart held = held_;
    follow_text();
    held_ = held;  // Until the model follows.
    way_taken_ = 0;
    ways_ = std::move(answer);
}

void Session::take_way(std::optional<std::size_t> way) {
    if (!way || !ways_ || *way >= ways_->ways.size() || *way == way_taken_) {
        if (!way) {
            ways_.reset();
        }
        return;
    }
    MoveAnswer answer = *std::move(ways_);
    ways_.reset();
    (void)editing_.text().undo();
    if (editing_.text().text() != answer.text) {
        (void)editing_.text().redo();
        return;
    }
    editing_.text().edit(answer.ways[*way].edits, done_by(answer));
    follow_text();
    way_taken_ = *way;
    ways_ = std::move(answer);
}

void Session::set_number(const SetNumber& number) {
    TextDocument& document = editing_.text();
    if (!number.begins && number_step_ == document.steps()) {
        (void)document.undo();
    }
    const std::size_t before = document.steps();
    document.edit({{number.bytes, number.text}}, "change " + number.name);
    number_step_ = document.steps() > before ? std::optional(document.steps()) : std::nullopt;
    ways_.reset();
    document_.edit(editing_.unsaved_text());
    follow_soon();
}

Session::SelectNext Session::same_as_now() const {
    SelectNext next;
    const auto& model = document_.model();
    if (!model || selected_ >= model->scene.occurrences.size()) {
        return next;
    }
    const csg::LeafId leaf = first_leaf_below(model->scene, selected_);
    if (leaf >= model->scene.leaves.size()) {
        return next;
    }
    next.leaf = leaf;
    next.leaves = static_cast<csg::LeafId>(model->scene.leaves.size());
    next.name = name_at(*model, selected_);
    for (csg::OccurrenceId at = model->scene.leaves[leaf].occurrence; at != selected_ && at != csg::kNoOccurrence;
         at = model->scene.occurrences[at].parent) {
        ++next.up;
    }
    return next;
}

void Session::select_again(const SelectNext& next) {
    clear_selection();
    const Model& model = *document_.model();
    csg::OccurrenceId found = csg::kNoOccurrence;
    if (next.bytes) {
        for (csg::OccurrenceId at = 0; at < model.scene.occurrences.size() && found == csg::kNoOccurrence; ++at) {
            const auto byte = byte_of(model.tree->node(model.scene.occurrences[at].node).where);
            found = byte && *byte >= next.bytes->begin && *byte < next.bytes->end ? at : found;
        }
    } else if (next.leaves > 0 && next.leaves == model.scene.leaves.size()) {
        found = model.scene.leaves[next.leaf].occurrence;
        for (csg::OccurrenceId i = 0; i < next.up && found != csg::kNoOccurrence; ++i) {
            found = model.scene.occurrences[found].parent;
        }
        // What an edit has put in between lies below it.
        constexpr int kMostPutIn = 2;
        for (int i = 0; i < kMostPutIn && found != csg::kNoOccurrence && name_at(model, found) != next.name; ++i) {
            found = model.scene.occurrences[found].parent;
        }
        if (found != csg::kNoOccurrence && name_at(model, found) != next.name) {
            found = csg::kNoOccurrence;
        }
    }
    if (found == csg::kNoOccurrence) {
        return;
    }
    const csg::SourceLocation& where = model.tree->node(model.scene.occurrences[found].node).where;
    mark(found, where.known()
                    ? fmt::format("{}:{}", std::filesystem::path(model.tree->files()[where.file]).filename().string(),
                                  where.line)
                    : "");
}

}  // namespace ui
