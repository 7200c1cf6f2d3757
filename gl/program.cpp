#include "gl/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "gl/error.h"

namespace gl {
namespace {

/// A stage's text with its includes in place; `files` are the names that #line numbers stand for.
struct Assembled {
    std::string text;
    std::vector<std::string> files;
};

void append(const ShaderLibrary& library, std::string_view name, Assembled& out) {
    if (std::find(out.files.begin(), out.files.end(), name) != out.files.end()) {
        return;
    }
    const std::size_t number = out.files.size();
    out.files.emplace_back(name);
    out.text += fmt::format("#line 1 {}\n", number);
    std::istringstream lines{std::string(library.find(name).text)};
    std::string line;
    for (int n = 1; std::getline(lines, line); ++n) {
        if (line.starts_with("#include")) {
            const auto open = line.find('"'), close = line.rfind('"');
            if (open == close) {
                throw Error(fmt::format("{}:{}: malformed #include", name, n));
            }
            append(library, std::string_view(line).substr(open + 1, close - open - 1), out);
            out.text += fmt::format("#line {} {}\n", n + 1, number);
        } else {
            out.text += line + '\n';
        }
    }
}

/// Reads a number at `at`, and goes on behind it; nothing where there is none.
std::optional<std::size_t> read_number(std::string_view text, std::size_t& at) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
    if (error != std::errc{}) {
        return std::nullopt;
    }
    at = static_cast<std::size_t>(end - text.data());
    return number;
}

/// Replaces the driver's "0:12" or "0(12)", at the beginning of a line or of a message, by the file's name and line.
std::string name_lines(std::string_view log, const std::vector<std::string>& files) {
    std::string result;
    for (std::size_t at = 0; at < log.size();) {
        const std::string_view before = log.substr(0, at);
        const bool begins =
            before.empty() || before.ends_with('\n') || before.ends_with("ERROR: ") || before.ends_with("WARNING: ");
        std::size_t end = at;
        const auto file = begins ? read_number(log, end) : std::nullopt;
        const bool parted = file && end < log.size() && (log[end] == ':' || log[end] == '(');
        const auto line = parted ? read_number(log, ++end) : std::nullopt;
        if (!line) {
            result += log[at++];
            continue;
        }
        result += fmt::format("{}:{}", *file < files.size() ? files[*file] : std::to_string(*file), *line);
        at = end + (end < log.size() && log[end] == ')' ? 1 : 0);
    }
    return result;
}

/// The words that stand where the name of a declared uniform does.
void add_uniforms(std::string_view text, std::unordered_set<std::string>& names) {
    constexpr std::string_view kUniform = "uniform ", kSpace = " \t\n", kEnd = " \t\n;[{";
    for (std::size_t at = text.find(kUniform); at != std::string_view::npos; at = text.find(kUniform, at)) {
        at = text.find_first_not_of(kSpace, at + kUniform.size());                                   // The type …
        at = text.find_first_not_of(kSpace, std::min(text.size(), text.find_first_of(kSpace, at)));  // … and the name.
        at = std::min(at, text.size());
        names.emplace(text.substr(at, text.find_first_of(kEnd, at) - at));
    }
}

GLenum stage_of(std::string_view name) {
    if (name.ends_with(".vert")) {
        return GL_VERTEX_SHADER;
    }
    if (name.ends_with(".frag")) {
        return GL_FRAGMENT_SHADER;
    }
    if (name.ends_with(".comp")) {
        return GL_COMPUTE_SHADER;
    }
    throw Error(fmt::format("{}: not a shader stage", name));
}

}  // namespace

const ShaderFile& ShaderLibrary::find(std::string_view name) const {
    const auto found = std::find_if(files_.begin(), files_.end(), [&](const ShaderFile& f) { return f.name == name; });
    if (found == files_.end()) {
        throw Error(fmt::format("no embedded shader file '{}'", name));
    }
    return *found;
}

Program::Program(const Functions& gl, const ShaderLibrary& library, std::initializer_list<std::string_view> files,
                 const Defines& defines)
    : Name(gl, gl.CreateProgram()) {
    std::string head = "#version 450 core\n";
    for (const auto& [name, value] : defines) {
        head += fmt::format("#define {} {}\n", name, value);
    }
    for (const std::string_view file : files) {
        Assembled assembled;
        append(library, file, assembled);
        add_uniforms(assembled.text, declared_);
        const std::string text = head + assembled.text;
        const GLuint shader = gl.CreateShader(stage_of(file));
        const char* data = text.c_str();
        gl.ShaderSource(shader, 1, &data, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(id_, shader);
        gl.DeleteShader(shader);  // lives on with the program
        GLint ok = 0, length = 0;
        gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
        gl.GetShaderInfoLog(shader, length, nullptr, log.data());
        if (!ok) {
            gl.DeleteProgram(std::exchange(id_, 0));
            throw Error(fmt::format("{} does not compile:\n{}", file, name_lines(log, assembled.files)));
        }
        files_ += fmt::format("{} ", file);
    }
    gl.LinkProgram(id_);
    GLint ok = 0, length = 0;
    gl.GetProgramiv(id_, GL_LINK_STATUS, &ok);
    gl.GetProgramiv(id_, GL_INFO_LOG_LENGTH, &length);
    if (!ok) {
        std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
        gl.GetProgramInfoLog(id_, length, nullptr, log.data());
        gl.DeleteProgram(std::exchange(id_, 0));
        throw Error(fmt::format("{}does not link:\n{}", files_, log));
    }
}

Program::~Program() {
    if (id_) {
        gl_->DeleteProgram(id_);
    }
}

GLint Program::at(const char* name) const {
    if (const auto known = locations_.find(name); known != locations_.end()) {
        return known->second;
    }
    const GLint location = gl_->GetUniformLocation(id_, name);
    if (location < 0 && !declared_.contains(name)) {
        throw std::logic_error(fmt::format("{}declares no uniform '{}'", files_, name));
    }
    return locations_.emplace(name, location).first->second;
}

}  // namespace gl
