// SPDX-License-Identifier: MIT
#include "franken/program_cache.h"

#include <algorithm>

namespace franken {
namespace {

std::string placeOf(const Permutation& permutation, Stage stage) {
    return toName(permutation) + (stage == Stage::Vertex ? " (vertex shader)" : " (fragment shader)");
}

constexpr const char* kRemedy = "see the text with: frankenshader dump NAME";

std::string trimmed(std::string log) {
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0'))
        log.pop_back();
    return log.empty() ? "the driver gives no reason" : log;
}

template<typename GetParameter, typename GetLog>
std::string logOf(GLuint name, GetParameter getParameter, GetLog getLog) {
    GLint length = 0;
    getParameter(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    getLog(name, static_cast<GLsizei>(log.size()), nullptr, log.data());
    return trimmed(std::move(log));
}

} // namespace

Result<ShaderProgram*> ProgramCache::get(const Permutation& permutation) {
    const Key key = toKey(permutation);
    auto entry = std::lower_bound(m_programs.begin(), m_programs.end(), key,
                                  [](const ProgramEntry& e, Key k) { return e.key < k; });
    if (entry == m_programs.end() || entry->key != key)
        entry = m_programs.insert(entry, {key, make(permutation)});
    else
        ++m_counters.hits;
    if (!entry->program)
        return entry->program.error();
    return entry->program->get();
}

Result<std::unique_ptr<ShaderProgram>> ProgramCache::make(const Permutation& permutation) {
    Composed composed = compose(permutation);
    const Result<GLuint> vertex = shader(permutation, Stage::Vertex, composed.vertex);
    if (!vertex)
        return vertex.error();
    const Result<GLuint> fragment = shader(permutation, Stage::Fragment, composed.fragment);
    if (!fragment)
        return fragment.error();
    Result<GlProgram> program = link(permutation, composed.interface, *vertex, *fragment);
    if (!program)
        return program.error();
    return std::make_unique<ShaderProgram>(*m_gl, *std::move(program), std::move(composed.interface));
}

Result<GLuint> ProgramCache::shader(const Permutation& permutation, Stage stage, const ComposedStage& text) {
    const Key key = stageKey(permutation, stage);
    auto entry = std::find_if(m_shaders.begin(), m_shaders.end(),
                              [&](const ShaderEntry& e) { return e.stage == stage && e.key == key; });
    if (entry == m_shaders.end())
        entry = m_shaders.insert(m_shaders.end(), {stage, key, compile(permutation, stage, text)});
    if (!entry->shader)
        return entry->shader.error();
    return entry->shader->name();
}

Result<GlShader> ProgramCache::compile(const Permutation& permutation, Stage stage,
                                       const ComposedStage& text) {
    ++m_counters.compiles;
    GlShader shader(*m_gl,
                    m_gl->CreateShader(stage == Stage::Vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER));
    const char* const source = text.text.c_str();
    m_gl->ShaderSource(shader.name(), 1, &source, nullptr);
    m_gl->CompileShader(shader.name());
    GLint compiled = GL_FALSE;
    m_gl->GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE)
        return Error{"program.compile", placeOf(permutation, stage),
                     annotateLog(logOf(shader.name(), m_gl->GetShaderiv, m_gl->GetShaderInfoLog), text),
                     kRemedy};
    return shader;
}

Result<GlProgram> ProgramCache::link(const Permutation& permutation, const Interface& interface,
                                     GLuint vertex, GLuint fragment) {
    ++m_counters.links;
    GlProgram program(*m_gl, m_gl->CreateProgram());
    m_gl->AttachShader(program.name(), vertex);
    m_gl->AttachShader(program.name(), fragment);
    for (const Attribute& attribute : interface.attributes)
        m_gl->BindAttribLocation(program.name(), static_cast<GLuint>(attribute.location),
                                 attribute.name.c_str());
    m_gl->LinkProgram(program.name());
    GLint linked = GL_FALSE;
    m_gl->GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE)
        return Error{"program.link", toName(permutation),
                     logOf(program.name(), m_gl->GetProgramiv, m_gl->GetProgramInfoLog), kRemedy};
    return program;
}

} // namespace franken
