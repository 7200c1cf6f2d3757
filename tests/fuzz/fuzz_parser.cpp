// Any bytes are a program: parsing it, at once or with lazy bodies, makes the same tree with the same messages;
// printing it and listing its parameters end well.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "csg/scad/customizer/customizer.h"
#include "csg/scad/syntax/parser.h"
#include "csg/scad/text/ast_text.h"
#include "tests/csg/scad/build_bodies.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace csg::scad;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto no_files = [](const std::string& path) -> ReadResult {
        return ReadError{true, "cannot read " + path + ": there are no files here"};
    };
    ParseRequest request;
    request.path = "fuzz.scad";
    request.text = text;
    request.reader = no_files;
    request.search_path = {};
    const Parsed parsed = parse(request);
    request.lazy = true;
    Parsed lazy = parse(request);
    const auto same = [](const Message& a, const Message& b) { return a.where == b.where && a.text == b.text; };
    if (lazy.ok != parsed.ok ||
        !std::equal(lazy.messages.begin(), lazy.messages.end(), parsed.messages.begin(), parsed.messages.end(), same)) {
        std::abort();
    }
    if (!parsed.ok) {
        return 0;
    }
    test::build_bodies(lazy.program);
    if (ast_text(lazy.program) != ast_text(parsed.program)) {
        std::abort();
    }
    for (const CustomizerParameter& parameter : customizer_parameters(parsed.program)) {
        (void)fitted_value(parameter, std::string_view(text).substr(0, 100));
    }
    return 0;
}
