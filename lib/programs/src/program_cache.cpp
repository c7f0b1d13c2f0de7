// SPDX-License-Identifier: MIT
#include "franken/program_cache.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

namespace franken {
namespace {

constexpr GLenum kCompletionStatus = 0x91B1; // GL_COMPLETION_STATUS_KHR

std::string_view nameOf(Stage stage) {
    return stage == Stage::Vertex ? " (vertex shader)" : " (fragment shader)";
}

Error failedAt(const char* code, const Permutation& permutation, std::string_view stage, std::string log) {
    const std::string name = toName(permutation);
    return {code, name + std::string(stage), std::move(log), "see its text with: frankenshader dump " + name};
}

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

/// Adds the time of a scope.
class Stopwatch {
public:
    explicit Stopwatch(double& milliseconds) : m_milliseconds(milliseconds) {}
    ~Stopwatch() {
        m_milliseconds += std::chrono::duration<double, std::milli>(Clock::now() - m_begin).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double& m_milliseconds;
    Clock::time_point m_begin = Clock::now();
};

} // namespace

ProgramCache::ProgramCache(const Gl& gl, ProgramCacheOptions options)
    : m_gl(&gl), m_options(std::move(options)) {}

void ProgramCache::begin(const Permutation& permutation) {
    if (entryOf(toKey(permutation)) == nullptr)
        add(permutation);
}

bool ProgramCache::pending(const Permutation& permutation) const {
    const Entry* entry = entryOf(toKey(permutation));
    if (entry == nullptr || !entry->linked || !m_options.parallelCompile)
        return false;
    GLint complete = GL_TRUE;
    m_gl->GetProgramiv(entry->linked.name(), kCompletionStatus, &complete);
    return complete == GL_FALSE;
}

Result<ProgramHandle> ProgramCache::get(const Permutation& permutation) {
    const Key key = toKey(permutation);
    if (ProgramHandle program = find(key))
        return program;
    Entry* entry = entryOf(key);
    if (entry == nullptr)
        entry = &add(permutation);
    if (entry->linked)
        finish(*entry);
    if (entry->error)
        return *entry->error;
    ProgramHandle program = entry->program;
    makeRoom(); // Moves entries.
    return program;
}

const Error* ProgramCache::failure(const Permutation& permutation) const {
    const Entry* entry = entryOf(toKey(permutation));
    return entry != nullptr && entry->error ? &*entry->error : nullptr;
}

void ProgramCache::reject(const Permutation& permutation, Error error) {
    Entry* entry = entryOf(toKey(permutation));
    if (entry == nullptr)
        entry = &add(permutation);
    if (!entry->error)
        fail(*entry, std::move(error));
}

void ProgramCache::abandon() {
    m_thread.check();
    for (Entry& entry : m_entries) {
        entry.linked.release();
        if (entry.program)
            entry.program->abandon();
    }
    for (const std::shared_ptr<Shader>& shader : m_shaders)
        shader->name.release();
    clear();
}

void ProgramCache::setSnippets(const SnippetSet& snippets) {
    m_thread.check();
    m_snippets = snippets;
    clear();
}

void ProgramCache::clear() {
    m_entries.clear();
    m_shaders.clear();
    m_table.clear();
    m_live = 0;
}

ProgramCache::Entry& ProgramCache::add(const Permutation& permutation) {
    const Stopwatch stopwatch(m_counters.milliseconds);
    Composed composed = compose(permutation, m_snippets);
    Entry entry{.program = {},
                .lastUse = m_counters.hits,
                .permutation = permutation,
                .key = toKey(permutation),
                .vertex = shader(permutation, Stage::Vertex, composed.vertex),
                .fragment = shader(permutation, Stage::Fragment, composed.fragment),
                .linked = {},
                .interface = std::move(composed.interface),
                .error = {}};
    ++m_live;
    const bool broken = entry.vertex->log || entry.fragment->log;
    if (broken) {
        fail(entry, reasonOf(entry));
    } else {
        ++m_counters.links;
        entry.linked = link(entry);
    }
    m_table.insert(entry.key, static_cast<std::uint32_t>(m_entries.size()));
    m_entries.push_back(std::move(entry));
    return m_entries.back();
}

std::shared_ptr<ProgramCache::Shader> ProgramCache::shader(const Permutation& permutation, Stage stage,
                                                           const ComposedStage& text) {
    const Key key = stageKey(permutation, stage);
    for (const std::shared_ptr<Shader>& known : m_shaders)
        if (known->stage == stage && known->key == key)
            return known;
    ++m_counters.compiles;
    const GLenum type = stage == Stage::Vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
    GlShader name(*m_gl, m_gl->CreateShader(type));
    const char* const source = text.text.c_str();
    m_gl->ShaderSource(name.name(), 1, &source, nullptr);
    m_gl->CompileShader(name.name());
    m_shaders.push_back(std::make_shared<Shader>(Shader{stage, key, std::move(name), {}}));
    return m_shaders.back();
}

GlProgram ProgramCache::link(const Entry& entry) const {
    GlProgram program(*m_gl, m_gl->CreateProgram());
    m_gl->AttachShader(program.name(), entry.vertex->name.name());
    m_gl->AttachShader(program.name(), entry.fragment->name.name());
    for (const Attribute& attribute : entry.interface.attributes)
        m_gl->BindAttribLocation(program.name(), static_cast<GLuint>(attribute.location),
                                 attribute.name.c_str());
    m_gl->LinkProgram(program.name());
    return program;
}

void ProgramCache::finish(Entry& entry) {
    const Stopwatch stopwatch(m_counters.milliseconds);
    GLint done = GL_FALSE;
    m_gl->GetProgramiv(entry.linked.name(), GL_LINK_STATUS, &done);
    if (done == GL_FALSE)
        return fail(entry, reasonOf(entry));
    entry.program =
        std::make_shared<ShaderProgram>(*m_gl, std::move(entry.linked), std::move(entry.interface));
}

// A shader is asked only when something went wrong, so that the driver may take its time.
Error ProgramCache::reasonOf(const Entry& entry) const {
    for (Shader* shader : {entry.vertex.get(), entry.fragment.get()}) {
        GLint compiled = GL_TRUE;
        m_gl->GetShaderiv(shader->name.name(), GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_FALSE && !shader->log) {
            const Composed composed = compose(entry.permutation, m_snippets);
            const bool vertex = shader->stage == Stage::Vertex;
            shader->log =
                trimmed(annotateLog(logOf(shader->name.name(), m_gl->GetShaderiv, m_gl->GetShaderInfoLog),
                                    vertex ? composed.vertex : composed.fragment));
        }
        if (shader->log)
            return failedAt("program.compile", entry.permutation, nameOf(shader->stage), *shader->log);
    }
    return failedAt("program.link", entry.permutation, "",
                    logOf(entry.linked.name(), m_gl->GetProgramiv, m_gl->GetProgramInfoLog));
}

void ProgramCache::fail(Entry& entry, Error error) {
    entry.error = std::move(error);
    entry.program = nullptr;
    entry.linked = {};
    --m_live;
    ++m_counters.failures;
}

void ProgramCache::makeRoom() {
    while (m_live > m_options.capacity) {
        std::size_t oldest = m_entries.size();
        for (std::size_t i = 0; i < m_entries.size(); ++i)
            if (m_entries[i].program.use_count() == 1 &&
                (oldest == m_entries.size() || m_entries[i].lastUse < m_entries[oldest].lastUse))
                oldest = i;
        if (oldest == m_entries.size()) {
            if (m_options.log && !std::exchange(m_warnedOfGrowth, true))
                m_options.log(LogLevel::Warning, "all " + std::to_string(m_live) +
                                                     " programs are in use: more than the cache's capacity");
            return;
        }
        evict(oldest);
    }
}

void ProgramCache::evict(std::size_t place) {
    m_entries.erase(m_entries.begin() + static_cast<std::ptrdiff_t>(place));
    m_table.clear();
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        m_table.insert(m_entries[i].key, static_cast<std::uint32_t>(i));
    --m_live;
    ++m_counters.evictions;
    dropUnusedShaders();
}

void ProgramCache::dropUnusedShaders() {
    std::erase_if(m_shaders, [](const std::shared_ptr<Shader>& shader) { return shader.use_count() == 1; });
}

} // namespace franken
