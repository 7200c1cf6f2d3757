#include "csg/scad/builtin/data_file.h"

#include <chrono>
#include <filesystem>

namespace csg::scad {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

/// Seconds since 1970; 0 for a file that there is not.
std::int64_t modified(const fs::path& path) {
    std::error_code error;
    const auto time = fs::last_write_time(path, error);
    if (error) {
        return 0;
    }
    const auto system = std::chrono::file_clock::to_sys(time);
    return std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count();
}

}  // namespace

FileStamp find_data_file(Evaluator& evaluator, const SourceRange& where, const std::string& name) {
    FileStamp file;
    if (name.empty()) {
        return file;
    }
    std::error_code error;
    const fs::path main = folder_of(evaluator.program().sources[0].name());
    const fs::path beside = folder_of(evaluator.program().sources[where.file].name());
    fs::path path = fs::path(name).is_absolute() ? fs::path(name) : beside / name;
    if (!fs::exists(path, error) && !fs::exists(main / name, error) && evaluator.request().make_missing) {
        evaluator.request().make_missing(path.lexically_normal().string());
    }
    if (!fs::exists(path, error) && fs::exists(main / name, error)) {
        evaluator.emit(Severity::Deprecated, {},
                       fmt::format("Imported file ({}) found in document root instead of relative to the importing "
                                   "module. This behavior is deprecated",
                                   name));
        path = main / name;
    }
    file.path = path.lexically_normal().string();
    evaluator.note_data_file(file.path);
    file.shown = fs::exists(path, error) ? fs::proximate(path, main, error).generic_string() : name;
    file.modified = modified(path);
    const auto bytes = fs::file_size(path, error);
    file.bytes = error ? 0 : bytes;
    return file;
}

}  // namespace csg::scad
