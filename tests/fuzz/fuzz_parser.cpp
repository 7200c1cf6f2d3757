// Any bytes are a program: parsing it, printing what was parsed, and listing its parameters end well.
#include <cstdint>
#include <string>

#include "csg/scad/ast_text.h"
#include "csg/scad/customizer.h"
#include "csg/scad/parser.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace csg::scad;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto no_files = [](const std::string& path) -> ReadResult {
        return ReadError{true, "cannot read " + path + ": there are no files here"};
    };
    const Parsed parsed = parse({"fuzz.scad", text, {}, no_files, {}});
    if (!parsed.ok)
        return 0;
    (void)ast_text(parsed.program);
    for (const CustomizerParameter& parameter : customizer_parameters(parsed.program))
        (void)fitted_expression(parameter, std::string_view(text).substr(0, 100));
    return 0;
}
