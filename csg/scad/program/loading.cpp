#include "csg/scad/program/loading.h"

namespace csg::scad {

SourceResult Loading::read(const std::string& path) {
    if (store_ != nullptr) {
        SourceStore::Answer answer = store_->read(path, request_.reader);
        log_.steps.push_back({path, false, answer.result, answer.state});
        return std::move(answer.result);
    }
    ReadResult text = request_.reader(path);
    if (auto* const error = std::get_if<ReadError>(&text)) {
        return std::move(*error);
    }
    return std::make_shared<const SourceFile>(path, std::get<std::string>(std::move(text)));
}

void Loading::make(const std::string& path) {
    request_.make_missing(path);
    if (store_ != nullptr) {
        log_.steps.push_back({path, true});
    }
}

SourceResult Loading::main() {
    return request_.text ? std::make_shared<const SourceFile>(request_.path, *request_.text) : read(request_.path);
}

bool Loading::repeats(const ReadLog& before) {
    for (std::size_t i = log_.steps.size(); i < before.steps.size(); ++i) {
        const ReadLog::Step& step = before.steps[i];
        if (step.made) {
            make(step.path);
        } else if (!same_source(read(step.path), step.result)) {
            return false;
        }
    }
    return true;
}

bool Loading::is_next(const std::string& path, bool made) {
    if (next_ < log_.steps.size() && (log_.steps[next_].path != path || log_.steps[next_].made != made)) {
        log_.steps.resize(next_);
    }
    return next_++ < log_.steps.size();
}

SourceResult Loading::next_read(const std::string& path) {
    return is_next(path, false) ? log_.steps[next_ - 1].result : read(path);
}

void Loading::next_make(const std::string& path) {
    if (!is_next(path, true)) {
        make(path);
    }
}

Parsed Loading::parse(const SharedSource& main) {
    next_ = request_.text ? 0 : 1;
    ParseRequest request{request_.path, {}, request_.definitions};
    request.main = main;
    request.find = [this](const std::string& path) { return next_read(path); };
    const bool by_pieces = pieces_ != nullptr && !may_name_files(request_.definitions);
    if (by_pieces) {
        request.piece_of = [&](const SharedSource& file) { return pieces_->get(file, file == main); };
    }
    request.search_path = request_.search_path;
    request.lazy = true;
    if (request_.make_missing) {
        request.make_missing = [this](const std::string& path) { next_make(path); };
    }
    if (by_pieces) {
        try {
            return scad::parse(request);
        } catch (const PieceMisfit&) {
            request.piece_of = {};
            next_ = request_.text ? 0 : 1;
        }
    }
    return scad::parse(request);
}

}  // namespace csg::scad
