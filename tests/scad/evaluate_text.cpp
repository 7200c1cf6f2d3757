#include "tests/scad/evaluate_text.h"

#include "csg/scad/text/csg_text.h"

namespace test {

Run run(const std::string& text, const std::map<std::string, std::string>& files, csg::scad::Request request) {
    using namespace csg::scad;
    Run result;
    request.path = kMainFile;
    request.text = text;
    request.search_path.clear();
    request.reader = [&files](const std::string& path) -> ReadResult {
        const auto found = files.find(path);
        return found == files.end() ? ReadResult(ReadError{true, "no file " + path}) : ReadResult(found->second);
    };
    result.evaluation = evaluate(request, [&](const Message& message, const SourceSet& sources) {
        result.console += render_openscad(message, sources) + '\n';
    });
    if (result.evaluation.ok) {
        result.csg = csg_text(*result.evaluation.tree);
    }
    return result;
}

}  // namespace test
