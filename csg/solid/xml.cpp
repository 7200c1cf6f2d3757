#include "csg/solid/xml.h"

#include <expat.h>
#include <fmt/format.h>

#include <memory>

namespace csg::solid {
namespace {

constexpr int kDeepestElement = 256;
constexpr std::size_t kChunk = std::size_t{1} << 24;

struct Reader {
    const XmlEvents& events;
    XML_Parser parser;
    std::string text;
    int depth = 0;
};

std::string without_prefix(const char* name) {
    const std::string full(name);
    const std::size_t colon = full.find(':');
    return colon == std::string::npos ? full : full.substr(colon + 1);
}

void XMLCALL on_open(void* self, const char* name, const char** attributes) {
    Reader& reader = *static_cast<Reader*>(self);
    if (++reader.depth > kDeepestElement) {
        XML_StopParser(reader.parser, XML_FALSE);
        return;
    }
    Attributes map;
    for (; *attributes != nullptr; attributes += 2) {
        map.emplace(without_prefix(attributes[0]), attributes[1]);
    }
    reader.text.clear();
    if (reader.events.open) {
        reader.events.open(without_prefix(name), map);
    }
}

void XMLCALL on_close(void* self, const char* name) {
    Reader& reader = *static_cast<Reader*>(self);
    --reader.depth;
    if (reader.events.close) {
        reader.events.close(without_prefix(name), reader.text);
    }
    reader.text.clear();
}

void XMLCALL on_text(void* self, const char* text, int length) {
    static_cast<Reader*>(self)->text.append(text, static_cast<std::size_t>(length));
}

/// A file that declares entities is refused: they can grow without bound.
void XMLCALL on_entity(void* self, const char*, int, const char*, int, const char*, const char*, const char*,
                       const char*) {
    XML_StopParser(static_cast<Reader*>(self)->parser, XML_FALSE);
}

}  // namespace

std::string_view attribute(const Attributes& attributes, std::string_view name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? std::string_view() : std::string_view(found->second);
}

bool read_xml(std::string_view text, const XmlEvents& events, std::vector<std::string>& warnings) {
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
    Reader reader{events, parser.get(), {}, 0};
    XML_SetUserData(parser.get(), &reader);
    XML_SetElementHandler(parser.get(), on_open, on_close);
    XML_SetCharacterDataHandler(parser.get(), on_text);
    XML_SetEntityDeclHandler(parser.get(), on_entity);
    for (std::size_t at = 0; at <= text.size(); at += kChunk) {
        const std::string_view part = text.substr(at, kChunk);
        const bool last = at + part.size() >= text.size();
        if (XML_Parse(parser.get(), part.data(), static_cast<int>(part.size()), last) != XML_STATUS_OK) {
            warnings.push_back(fmt::format("XML error: {} in line {}", XML_ErrorString(XML_GetErrorCode(parser.get())),
                                           XML_GetCurrentLineNumber(parser.get())));
            return false;
        }
        if (last) {
            break;
        }
    }
    return true;
}

}  // namespace csg::solid
