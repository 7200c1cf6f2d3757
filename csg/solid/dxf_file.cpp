// DXF: pairs of a group code and a value, a line each.
#include "csg/solid/dxf_file.h"

#include <algorithm>

#include "csg/solid/file_text.h"

namespace csg::solid {
namespace {

std::string_view trimmed_line(std::string_view line) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) {
        line.remove_suffix(1);
    }
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) {
        line.remove_prefix(1);
    }
    return line;
}

}  // namespace

DxfFile read_dxf_file(std::string_view text) {
    DxfFile file;
    Words words(text);
    std::string section, block;
    bool in_block = false;
    DxfEntity entity;
    const auto finish_entity = [&] {
        if (entity.kind == "BLOCK") {
            block = entity.block;
        } else if (!entity.kind.empty() && section == "ENTITIES") {
            file.entities.push_back(std::move(entity));
        } else if (!entity.kind.empty() && section == "BLOCKS" && in_block) {
            file.blocks[block].push_back(std::move(entity));
        }
        entity = {};
    };
    while (!words.at_end()) {
        const auto code_word = to_number(trimmed_line(words.line()));
        const std::string_view value = trimmed_line(words.line());
        if (!code_word) {
            continue;
        }
        const int code = static_cast<int>(std::clamp(*code_word, -1.0, 2000.0));
        if (code == 0) {
            finish_entity();
            if (value == "BLOCK") {
                in_block = true;
            } else if (value == "ENDBLK") {
                in_block = false;
            }
            if (value == "ENDSEC") {
                section.clear();
            } else {
                entity.kind = value;
            }
        } else if (code == 2 && entity.kind == "SECTION") {
            section = value;
            entity.kind.clear();
        } else if (code == 2) {
            entity.block = value;
        } else if (code == 1) {
            entity.text = value;
        } else if (code == 8) {
            entity.layer = value;
        } else if (const auto number = to_number(value)) {
            entity.numbers[code] = *number;
            if (code == 10 || code == 20 || code == 11 || code == 21 || (code >= 40 && code <= 42)) {
                entity.series.emplace_back(code, *number);
            }
        }
    }
    finish_entity();
    return file;
}

}  // namespace csg::solid
