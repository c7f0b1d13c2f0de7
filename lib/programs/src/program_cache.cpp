// SPDX-License-Identifier: MIT
#include "franken/program_cache.h"

#include "franken/context_check.h"
#include "franken/gl_object.h"
#include "franken/guard.h"
#include "franken/key_table.h"
#include "franken/own_thread.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

namespace franken {
namespace {

constexpr GLenum kCompletionStatus = 0x91B1; // GL_COMPLETION_STATUS_KHR
constexpr GLint kMaxLog = 1 << 20;           // Of a driver, bytes.

std::string_view nameOf(Stage stage) {
    return stage == Stage::Vertex ? " (vertex shader)" : " (fragment shader)";
}

Error failedAt(const char* code, const std::string& name, std::string_view stage, std::string log) {
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
    std::string log(static_cast<std::size_t>(std::clamp(length, 1, kMaxLog)), '\0');
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

struct [[gnu::visibility("hidden")]] ProgramCache::State {
    struct Shader {
        Stage stage;
        Key key; ///< The stage key.
        GlShader name;
        std::optional<std::string> log; ///< Once it is known not to compile.
    };
    /// One of three: pending (a linked name), ready (a program) or failed (an error).
    struct Entry {
        ProgramHandle program;     // With lastUse, all that a look-up touches: one cache line.
        std::uint64_t lastUse = 0; ///< ProgramCounters::hits then; of equals, the first is the oldest.
        Permutation permutation;
        Key key;
        std::shared_ptr<Shader> vertex, fragment;
        GlProgram linked;
        Interface interface;
        std::optional<Error> error;
    };

    State(const Gl& functions, ProgramCacheOptions chosen) : gl(&functions), options(std::move(chosen)) {
        options.log = guardedLog(std::move(options.log));
    }

    Entry* entryOf(const Key& key) {
        thread.check();
        const std::uint32_t place = table.find(key);
        return place == KeyTable::kAbsent ? nullptr : &entries[place];
    }
    Entry& add(const Permutation& permutation);
    std::shared_ptr<Shader> shader(const Permutation& permutation, Stage stage, const ComposedStage& text);
    GlProgram link(const Entry& entry) const;
    void finish(Entry & entry);
    void fail(Entry & entry, Error error);
    Error reasonOf(const Entry& entry) const;
    /// GL's errors do not say that the context was lost.
    bool hasContext() const {
        const Result<void> checked = checkErrors(*gl);
        return checked || checked.error().code != contextLost().code;
    }
    void clear();
    void makeRoom();
    void erase(std::size_t place);

    const Gl* gl;
    ProgramCacheOptions options;
    SnippetSet snippets = SnippetSet::builtIn();
    OwnThread thread;
    KeyTable table; ///< Into entries.
    std::vector<Entry> entries;
    std::vector<std::shared_ptr<Shader>> shaders;
    std::size_t live = 0;
    bool warnedOfGrowth = false;
    ProgramCounters counters;
};

ProgramCache::ProgramCache(const Gl& gl, ProgramCacheOptions options)
    : m_state(std::make_unique<State>(gl, std::move(options))) {}

ProgramCache::ProgramCache(ProgramCache&&) noexcept = default;
ProgramCache& ProgramCache::operator=(ProgramCache&&) noexcept = default;
ProgramCache::~ProgramCache() = default;

void ProgramCache::compileInBackground(const Permutation& permutation) {
    if (const Result<Key> key = checkedKey(permutation); key && m_state->entryOf(*key) == nullptr)
        m_state->add(permutation);
}

bool ProgramCache::pending(const Permutation& permutation) const {
    const State::Entry* entry = m_state->entryOf(toKey(permutation));
    if (entry == nullptr || !entry->linked || !m_state->options.parallelCompile)
        return false;
    GLint complete = GL_TRUE;
    m_state->gl->GetProgramiv(entry->linked.name(), kCompletionStatus, &complete);
    return complete == GL_FALSE;
}

ProgramHandle ProgramCache::find(const Key& key) {
    State::Entry* const entry = m_state->entryOf(key);
    if (entry == nullptr || !entry->program)
        return nullptr;
    entry->lastUse = ++m_state->counters.hits;
    return entry->program;
}

Result<ProgramHandle> ProgramCache::get(const Permutation& permutation) {
    const Result<Key> key = checkedKey(permutation);
    if (!key)
        return key.error();
    if (ProgramHandle program = find(*key))
        return program;
    State::Entry* entry = m_state->entryOf(*key);
    const bool known = entry != nullptr;
    if (!known)
        entry = &m_state->add(permutation);
    if (entry->linked)
        m_state->finish(*entry);
    else if (known && entry->error)
        return *entry->error;
    if (!answers(*m_state->gl) || (entry->error && !m_state->hasContext())) {
        m_state->erase(static_cast<std::size_t>(entry - m_state->entries.data()));
        return contextLost();
    }
    if (entry->error)
        return *entry->error;
    ProgramHandle program = entry->program;
    m_state->makeRoom(); // Moves entries.
    return program;
}

const Error* ProgramCache::failure(const Permutation& permutation) const {
    const State::Entry* entry = m_state->entryOf(toKey(permutation));
    return entry != nullptr && entry->error ? &*entry->error : nullptr;
}

void ProgramCache::reject(const Permutation& permutation, Error error) {
    State::Entry* entry = m_state->entryOf(toKey(permutation));
    if (entry == nullptr)
        entry = &m_state->add(permutation);
    if (!entry->error)
        m_state->fail(*entry, std::move(error));
}

void ProgramCache::lost() {
    m_state->thread.check();
    for (State::Entry& entry : m_state->entries) {
        entry.linked.release();
        if (entry.program)
            entry.program->lost();
    }
    for (const std::shared_ptr<State::Shader>& shader : m_state->shaders)
        shader->name.release();
    m_state->clear();
}

void ProgramCache::setSnippets(const SnippetSet& snippets) {
    m_state->thread.check();
    m_state->snippets = snippets;
    m_state->clear();
}

const SnippetSet& ProgramCache::snippets() const { return m_state->snippets; }

void ProgramCache::setParallelCompile(bool on) { m_state->options.parallelCompile = on; }

std::size_t ProgramCache::size() const { return m_state->live; }

const ProgramCounters& ProgramCache::counters() const { return m_state->counters; }

void ProgramCache::State::clear() {
    entries.clear();
    shaders.clear();
    table.clear();
    live = 0;
}

ProgramCache::State::Entry& ProgramCache::State::add(const Permutation& permutation) {
    const Stopwatch stopwatch(counters.milliseconds);
    Composed composed = compose(permutation, snippets);
    Entry entry{.program = {},
                .lastUse = counters.hits,
                .permutation = permutation,
                .key = toKey(permutation),
                .vertex = shader(permutation, Stage::Vertex, composed.vertex),
                .fragment = shader(permutation, Stage::Fragment, composed.fragment),
                .linked = {},
                .interface = std::move(composed.interface),
                .error = {}};
    ++live;
    const bool broken = !snippets.check(permutation.effect) || entry.vertex->log || entry.fragment->log ||
                        !entry.vertex->name || !entry.fragment->name;
    if (!broken) {
        ++counters.links;
        entry.linked = link(entry);
    }
    if (!entry.linked)
        fail(entry, reasonOf(entry));
    table.insert(entry.key, static_cast<std::uint32_t>(entries.size()));
    entries.push_back(std::move(entry));
    return entries.back();
}

std::shared_ptr<ProgramCache::State::Shader>
ProgramCache::State::shader(const Permutation& permutation, Stage stage, const ComposedStage& text) {
    const Key key = stageKey(permutation, stage);
    for (const std::shared_ptr<Shader>& known : shaders)
        if (known->stage == stage && known->key == key)
            return known;
    ++counters.compiles;
    const GLenum type = stage == Stage::Vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
    GlShader name(*gl, gl->CreateShader(type));
    const char* const source = text.text.c_str();
    gl->ShaderSource(name.name(), 1, &source, nullptr);
    gl->CompileShader(name.name());
    shaders.push_back(std::make_shared<Shader>(Shader{stage, key, std::move(name), {}}));
    return shaders.back();
}

GlProgram ProgramCache::State::link(const Entry& entry) const {
    GlProgram program(*gl, gl->CreateProgram());
    gl->AttachShader(program.name(), entry.vertex->name.name());
    gl->AttachShader(program.name(), entry.fragment->name.name());
    for (const Attribute& attribute : entry.interface.attributes)
        gl->BindAttribLocation(program.name(), static_cast<GLuint>(attribute.location),
                               attribute.name.c_str());
    gl->LinkProgram(program.name());
    return program;
}

void ProgramCache::State::finish(Entry& entry) {
    const Stopwatch stopwatch(counters.milliseconds);
    GLint done = GL_FALSE;
    gl->GetProgramiv(entry.linked.name(), GL_LINK_STATUS, &done);
    if (done == GL_FALSE)
        return fail(entry, reasonOf(entry));
    entry.program = std::make_shared<ShaderProgram>(*gl, entry.linked.release(), std::move(entry.interface));
}

// A shader is asked only when something went wrong, so that the driver may take its time.
Error ProgramCache::State::reasonOf(const Entry& entry) const {
    if (Result<void> known = snippets.check(entry.permutation.effect); !known)
        return known.error();
    const std::string name = toName(entry.permutation, snippets);
    for (Shader* shader : {entry.vertex.get(), entry.fragment.get()}) {
        if (!shader->name && !shader->log)
            shader->log = "the driver makes no shader";
        GLint compiled = GL_TRUE;
        gl->GetShaderiv(shader->name.name(), GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_FALSE && !shader->log) {
            const Composed composed = compose(entry.permutation, snippets);
            const bool vertex = shader->stage == Stage::Vertex;
            shader->log =
                trimmed(annotateLog(logOf(shader->name.name(), gl->GetShaderiv, gl->GetShaderInfoLog),
                                    vertex ? composed.vertex : composed.fragment));
        }
        if (shader->log)
            return failedAt("program.compile", name, nameOf(shader->stage), *shader->log);
    }
    if (!entry.linked)
        return failedAt("program.link", name, "", "the driver makes no program");
    return failedAt("program.link", name, "",
                    logOf(entry.linked.name(), gl->GetProgramiv, gl->GetProgramInfoLog));
}

void ProgramCache::State::fail(Entry& entry, Error error) {
    entry.error = std::move(error);
    entry.program = nullptr;
    entry.linked = {};
    --live;
    ++counters.failures;
}

void ProgramCache::State::makeRoom() {
    while (live > options.capacity) {
        std::size_t oldest = entries.size();
        for (std::size_t i = 0; i < entries.size(); ++i)
            if (entries[i].program.use_count() == 1 &&
                (oldest == entries.size() || entries[i].lastUse < entries[oldest].lastUse))
                oldest = i;
        if (oldest == entries.size()) {
            if (options.log && !std::exchange(warnedOfGrowth, true))
                options.log(LogLevel::Warning, "all " + std::to_string(live) +
                                                   " programs are in use: more than the cache's capacity");
            return;
        }
        erase(oldest);
        ++counters.evictions;
    }
}

void ProgramCache::State::erase(std::size_t place) {
    if (!entries[place].error)
        --live;
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(place));
    table.clear();
    for (std::size_t i = 0; i < entries.size(); ++i)
        table.insert(entries[i].key, static_cast<std::uint32_t>(i));
    std::erase_if(shaders, [](const std::shared_ptr<Shader>& shader) { return shader.use_count() == 1; });
}

} // namespace franken
