// SPDX-License-Identifier: MIT
#include "support/fake_driver.h"

#include "franken/generator/compose.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace franken::test {
namespace {

struct Driver {
    Gl gl;
    Refusal refusal = Refusal::Compile;
    bool all = false;
    std::set<std::string> texts;
    std::set<GLuint> shaders, programs; ///< The refused ones.
    GLuint used = 0;

    bool isWrong() const { return refusal == Refusal::Black || refusal == Refusal::Nan; }
    bool ignoresDraws() const { return refusal == Refusal::Draw && programs.count(used) != 0; }
};

constexpr std::string_view kLog = "0:40(5): error: refused"; // In Mesa's form.

Driver driver; // GL's functions carry no context of ours.

void GL_APIENTRY shaderSource(GLuint shader, GLsizei count, const GLchar* const* texts,
                              const GLint* lengths) {
    std::string text = *texts;
    const bool fragment = text.find("FRAGMENT SHADER") != std::string::npos;
    if (fragment && (driver.all || driver.texts.count(text) != 0))
        driver.shaders.insert(shader);
    else
        driver.shaders.erase(shader); // Names are used again.
    if (driver.shaders.count(shader) == 0 || !driver.isWrong())
        return driver.gl.ShaderSource(shader, count, texts, lengths);
    constexpr std::string_view kBlack = "color = vec3(0.0);\n  ",
                               kNan = "color = (color - color) / (color - color);\n  ";
    text.insert(text.rfind("gl_FragColor"), driver.refusal == Refusal::Black ? kBlack : kNan);
    const char* const source = text.c_str();
    driver.gl.ShaderSource(shader, 1, &source, nullptr);
}

void GL_APIENTRY getShaderiv(GLuint shader, GLenum name, GLint* value) {
    driver.gl.GetShaderiv(shader, name, value);
    if (driver.refusal != Refusal::Compile || driver.shaders.count(shader) == 0)
        return;
    if (name == GL_COMPILE_STATUS)
        *value = GL_FALSE;
    if (name == GL_INFO_LOG_LENGTH)
        *value = static_cast<GLint>(kLog.size()) + 1;
}

void GL_APIENTRY getShaderInfoLog(GLuint, GLsizei size, GLsizei*, GLchar* log) {
    log[kLog.copy(log, static_cast<std::size_t>(size) - 1)] = '\0';
}

void GL_APIENTRY attachShader(GLuint program, GLuint shader) {
    if (driver.shaders.count(shader) != 0)
        driver.programs.insert(program);
    driver.gl.AttachShader(program, shader);
}

GLuint GL_APIENTRY createProgram() {
    const GLuint program = driver.gl.CreateProgram();
    driver.programs.erase(program);
    return program;
}

void GL_APIENTRY getProgramiv(GLuint program, GLenum name, GLint* value) {
    driver.gl.GetProgramiv(program, name, value);
    if (name == GL_LINK_STATUS && !driver.isWrong() && driver.refusal != Refusal::Draw &&
        driver.programs.count(program) != 0)
        *value = GL_FALSE;
}

} // namespace

Gl refusingDriver(const Gl& gl, Refusal refusal, const std::vector<Permutation>& refused) {
    driver = {};
    driver.gl = gl;
    driver.refusal = refusal;
    for (const Permutation& permutation : refused)
        driver.texts.insert(compose(permutation).fragment.text);
    Gl table = gl;
    table.ShaderSource = shaderSource;
    table.GetShaderiv = getShaderiv;
    if (refusal == Refusal::Compile)
        table.GetShaderInfoLog = getShaderInfoLog;
    table.AttachShader = attachShader;
    table.CreateProgram = createProgram;
    table.GetProgramiv = getProgramiv;
    table.UseProgram = [](GLuint program) { driver.gl.UseProgram(driver.used = program); };
    table.DrawElements = [](GLenum mode, GLsizei count, GLenum type, const void* indices) {
        if (!driver.ignoresDraws())
            driver.gl.DrawElements(mode, count, type, indices);
    };
    table.DrawArrays = [](GLenum mode, GLint first, GLsizei count) {
        if (!driver.ignoresDraws())
            driver.gl.DrawArrays(mode, first, count);
    };
    return table;
}

Gl refusingDriver(const Gl& gl, Refusal refusal) {
    const Gl table = refusingDriver(gl, refusal, {});
    driver.all = true;
    return table;
}

} // namespace franken::test
