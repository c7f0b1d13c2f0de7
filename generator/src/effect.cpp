// SPDX-License-Identifier: MIT
#include "franken/generator/effect.h"

#include "effect_rules.h"
#include "franken/crc32.h"
#include "franken/nearest.h"
#include "franken/printable.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <optional>

namespace franken {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{16} << 10;

// Lines of programs name their file when the effect is gone. A list that only grows needs no lock, which a
// system without threads would not have.
struct KeptName {
    std::string file;
    const KeptName* next;
};

std::string_view keptFor(const std::string& file) {
    static std::atomic<const KeptName*> first;
    const KeptName* const seen = first;
    for (const KeptName* kept = seen; kept != nullptr; kept = kept->next)
        if (kept->file == file)
            return kept->file;
    auto* const added = new KeptName{file, seen};
    while (!first.compare_exchange_weak(added->next, added)) {
    }
    return added->file;
}

const EffectHook* findHook(std::string_view name) {
    const auto found = std::find_if(effectHooks().begin(), effectHooks().end(),
                                    [name](const EffectHook& hook) { return hook.name == name; });
    return found == effectHooks().end() ? nullptr : &*found;
}

std::string wordOf(std::string_view name, std::uint32_t hash) {
    char digits[16];
    std::snprintf(digits, sizeof(digits), "@%08x", static_cast<unsigned>(hash));
    return std::string(name) + digits;
}

std::optional<Type> typeOf(std::string_view word) {
    for (const Type type : {Type::Float, Type::Vec2, Type::Vec3, Type::Vec4})
        if (toGlsl(type) == word)
            return type;
    return std::nullopt;
}

class Reader {
public:
    explicit Reader(Effect::Text& effect) : m_effect(effect) {}

    Result<void> read(std::string_view text) {
        int number = 0;
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            std::string_view line = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
            if (Result<void> added = add(line, ++number); !added)
                return added;
        }
        return finish();
    }

private:
    enum class Section { None, Declarations, Hook };

    Error refuse(const char* code, int line, std::string what, std::string remedy) const {
        return badEffect(code, m_effect.file, line, std::move(what), std::move(remedy));
    }

    Result<void> add(std::string_view line, int number) {
        if (line.starts_with("//!"))
            return begin(line.substr(3), number);
        if (const std::string_view code = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
            code.starts_with('#'))
            return refuse("effect.text", number,
                          "'" + printable(code) + "' is a directive, which an effect has none of",
                          "leave it out: the composer writes version, extensions and precision");
        if (m_section == Section::Hook) {
            m_effect.hooks.back().text.append(line).append("\n");
            return {};
        }
        if (line.empty() || line.starts_with("//"))
            return {};
        if (m_section == Section::Declarations)
            return declare(line, number);
        return refuse("effect.syntax", number, "there is GLSL before the first section",
                      "begin a section: //! light");
    }

    Result<void> begin(std::string_view name, int number) {
        name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
        if (name == "declarations")
            return m_section = Section::Declarations, Result<void>();
        const EffectHook* const hook = findHook(name);
        if (hook == nullptr)
            return unknownHook(name, number);
        if ((m_effect.traits & hook->trait) != 0)
            return refuse("effect.syntax", number, "the section '" + std::string(name) + "' is there already",
                          "join the two");
        m_effect.traits |= hook->trait;
        m_effect.hooks.push_back({hook, "", number + 1, ""});
        m_section = Section::Hook;
        return {};
    }

    Error unknownHook(std::string_view name, int number) const {
        std::vector<std::string_view> names = {"declarations"};
        for (const EffectHook& hook : effectHooks())
            names.push_back(hook.name);
        std::string all;
        for (const std::string_view each : names)
            all.append(all.empty() ? "" : ", ").append(each);
        const std::string_view nearest = nearestWord(name, names);
        return refuse("effect.syntax", number, "'" + printable(name) + "' is no hook",
                      nearest.empty() ? "the sections are " + all
                                      : "did you mean '" + std::string(nearest) + "'?");
    }

    Result<void> declare(std::string_view line, int number) {
        const Syntax syntax = parseGlsl(line);
        if (syntax.globals.size() != 1 || syntax.globals.front().array)
            return refuse("effect.uniform", number, "this declares not one uniform or varying",
                          "write one a line, as in 'uniform vec4 uFog; // user: colour'");
        const Variable& variable = syntax.globals.front();
        const bool varying = variable.qualifier == "varying";
        const bool value =
            variable.qualifier == "uniform" && variable.type == "vec4" && line.find("// user: ") != line.npos;
        const std::optional<Type> type = typeOf(variable.type);
        if ((!varying && !value) || !type)
            return refuse("effect.uniform", number,
                          "'" + std::string(variable.name) +
                              "' is neither a vec4 of the effect's own nor a varying",
                          "write 'uniform vec4 " + std::string(variable.name) + "; // user: its meaning'");
        if (auto free = checkFree(m_effect, variable.name, number); !free)
            return free;
        if (isDeclared(variable.name))
            return refuse("effect.uniform", number, "'" + std::string(variable.name) + "' is there already",
                          "leave one of the two out");
        m_effect.declarations.push_back(
            {std::string(line) + "\n", number, std::string(variable.name), *type, varying});
        if (value)
            m_effect.uniforms.emplace_back(variable.name);
        if (m_effect.uniforms.size() > kEffectValues)
            return refuse("effect.uniform", number,
                          "'" + std::string(variable.name) + "' is one uniform too many",
                          "an effect has at most " + std::to_string(kEffectValues) + " vec4");
        return {};
    }

    bool isDeclared(std::string_view name) const {
        return std::any_of(m_effect.declarations.begin(), m_effect.declarations.end(),
                           [name](const Effect::Text::Declaration& each) { return each.name == name; });
    }

    Result<void> finish() {
        if (m_effect.hooks.empty())
            return refuse("effect.syntax", 1, "it fills no hook", "begin a section: //! light");
        for (Effect::Text::Hook& hook : m_effect.hooks) {
            while (hook.text.ends_with("\n\n"))
                hook.text.pop_back();
            if (Result<void> read = readHook(m_effect, hook); !read)
                return read;
        }
        for (const Effect::Text::Declaration& declaration : m_effect.declarations)
            if (Result<void> used = checkUse(declaration); !used)
                return used;
        return {};
    }

    Result<void> checkUse(const Effect::Text::Declaration& declaration) const {
        bool vertex = false, fragment = false;
        for (const Effect::Text::Hook& hook : m_effect.hooks)
            if (parseGlsl(hook.text).mentions(declaration.name))
                (hook.hook->trait == kVertexHook ? vertex : fragment) = true;
        if (declaration.varying && !(vertex && fragment))
            return refuse("effect.uniform", declaration.line,
                          "the varying '" + declaration.name + "' leads from nowhere, or to nowhere",
                          "write it in the vertex hook and read it in another one, or leave it out");
        if (!vertex && !fragment)
            return refuse("effect.uniform", declaration.line, "'" + declaration.name + "' is not used",
                          "use it, or leave it out");
        return {};
    }

    Effect::Text& m_effect;
    Section m_section = Section::None;
};

} // namespace

Result<Effect> Effect::parse(std::string name, std::string_view text, std::string file) {
    if (Result<void> checked = checkEffectName(name); !checked)
        return checked.error();
    if (text.size() > kMaxBytes)
        return badEffect("effect.text", printable(file), 0, "the text is larger than 16 KiB",
                         "an effect is some lines of GLSL");
    text = withoutByteOrderMark(text);
    auto effect = std::make_shared<Text>();
    effect->name = std::move(name);
    effect->file = keptFor(printable(file));
    effect->hash = crc32(text);
    effect->word = wordOf(effect->name, effect->hash);
    if (Result<void> read = Reader(*effect).read(text); !read)
        return read.error();
    return Effect(std::move(effect));
}

const std::string& Effect::name() const { return m_text->name; }
std::uint32_t Effect::hash() const { return m_text->hash; }
const std::string& Effect::word() const { return m_text->word; }
const std::vector<std::string>& Effect::uniforms() const { return m_text->uniforms; }
EffectChoice Effect::choice(std::uint8_t slot) const { return {slot, m_text->traits}; }

} // namespace franken
