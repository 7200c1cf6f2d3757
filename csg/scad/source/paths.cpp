#include "csg/scad/source/paths.h"

#include <algorithm>
#include <filesystem>

namespace csg::scad {
namespace {

/// What normal_path() makes shorter takes a slash before a slash or a dot, or a dot at the beginning.
bool is_normal(std::string_view path) {
    if (path.empty() || path[0] == '.') {
        return false;
    }
    for (std::size_t slash = path.find('/'); slash != std::string_view::npos; slash = path.find('/', slash + 1)) {
        if (slash + 1 < path.size() && (path[slash + 1] == '/' || path[slash + 1] == '.')) {
            return false;
        }
    }
    return true;
}

/// Takes the last name off, for "..". False where there is none that can go.
bool take_off_last(std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
    if (path.size() == begin || std::string_view(path).substr(begin) == "..") {
        return false;
    }
    path.erase(slash == std::string::npos ? 0 : std::max<std::size_t>(slash, 1));
    return true;
}

}  // namespace

std::string normal_path(std::string_view path) {
    if (is_normal(path)) {
        return std::string(path);
    }
    const std::string_view last = path.substr(path.rfind('/') + 1);
    if (last.empty() || last == "." || last == ".." || path.starts_with("//")) {  // Rules for folders: seldom.
        return std::filesystem::path(path).lexically_normal().string();
    }
    std::string normal = path[0] == '/' ? "/" : "";
    while (!path.empty()) {
        const std::size_t end = std::min(path.find('/'), path.size());
        const std::string_view name = path.substr(0, end);
        path.remove_prefix(std::min(end + 1, path.size()));
        if (name.empty() || name == ".") {
            continue;
        }
        if (name == ".." && (take_off_last(normal) || normal == "/")) {
            continue;
        }
        normal += normal.empty() || normal.back() == '/' ? "" : "/";
        normal += name;
    }
    return normal;
}

std::string path_in(std::string_view folder, std::string_view name) {
    std::string path;
    if (!name.starts_with('/') && !folder.empty()) {
        path += folder;
        path += folder.back() == '/' ? "" : "/";
    }
    return path += name;
}

std::string_view folder_of_path(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string_view() : path.substr(0, std::max<std::size_t>(slash, 1));
}

}  // namespace csg::scad
