// SPDX-License-Identifier: MIT
#include "support/gl_recorder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

namespace franken::test {
namespace {

Gl realTable;
std::vector<GlCall> calls;

template<typename Value>
std::uint64_t toWord(Value value) {
    if constexpr (std::is_pointer_v<Value>)
        return reinterpret_cast<std::uintptr_t>(value);
    else if constexpr (std::is_floating_point_v<Value>)
        return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    else
        return static_cast<std::uint64_t>(value);
}

template<auto Member>
struct Recorded;

template<typename Return, typename... Arguments, Return (GL_APIENTRY* Gl::*Member)(Arguments...)>
struct Recorded<Member> {
    static inline const char* name = nullptr;
    static Return GL_APIENTRY call(Arguments... arguments) {
        calls.push_back({name, {toWord(arguments)...}});
        return (realTable.*Member)(arguments...);
    }
};

bool startsWithAny(std::string_view text, std::initializer_list<std::string_view> starts) {
    return std::any_of(starts.begin(), starts.end(),
                       [&](std::string_view start) { return text.starts_with(start); });
}

} // namespace

Gl recordingGl(const Gl& real) {
    realTable = real;
    calls.clear();
    Gl table;
#define FRANKEN_RECORD(function)                                                                             \
    Recorded<& Gl::function>::name = #function;                                                              \
    table.function = Recorded<&Gl::function>::call;
    FRANKEN_GL_FUNCTIONS(FRANKEN_RECORD)
#undef FRANKEN_RECORD
    return table;
}

std::vector<GlCall>& recordedCalls() { return calls; }

std::size_t countCalls(std::string_view name) {
    return static_cast<std::size_t>(
        std::count_if(calls.begin(), calls.end(), [&](const GlCall& call) { return call.name == name; }));
}

std::vector<std::string> callsThatAsk() {
    std::vector<std::string> asking;
    for (const GlCall& call : calls)
        if (startsWithAny(call.name, {"Get", "Is", "Check", "Read", "Finish", "Flush", "Compile", "Link"}))
            asking.emplace_back(call.name);
    return asking;
}

StateFollower::Entry StateFollower::entryOf(const GlCall& call) {
    const std::string name(call.name);
    const Words& arguments = call.arguments;
    const auto numbered = [&](std::string_view what, std::uint64_t number) {
        return std::string(what) + " " + std::to_string(number);
    };
    if (name == "Enable" || name == "Disable")
        return {numbered("capability", arguments[0]), {name == "Enable"}};
    if (name == "EnableVertexAttribArray" || name == "DisableVertexAttribArray")
        return {numbered("array", arguments[0]), {name[0] == 'E'}};
    if (name == "BindTexture")
        return {numbered("unit", m_unit) + numbered(" texture", arguments[0]), {arguments[1]}};
    if (name == "BindBuffer")
        return {numbered("buffer", arguments[0]), {arguments[1]}};
    if (name == "VertexAttribPointer") {
        Words value(arguments.begin() + 1, arguments.end());
        value.push_back(m_arrayBuffer);
        return {numbered("pointer", arguments[0]), std::move(value)};
    }
    constexpr std::array kSimple = {"UseProgram",  "ActiveTexture", "DepthFunc",     "DepthMask",
                                    "DepthRangef", "ColorMask",     "CullFace",      "FrontFace",
                                    "ClearColor",  "ClearDepthf",   "BlendEquation", "BlendFuncSeparate"};
    if (std::find(kSimple.begin(), kSimple.end(), name) != kSimple.end())
        return {name, arguments};
    return {};
}

std::vector<std::string> StateFollower::redundant(const std::vector<GlCall>& list) {
    std::vector<std::string> result;
    for (const GlCall& call : list) {
        Entry entry = entryOf(call);
        if (call.name == "ActiveTexture")
            m_unit = call.arguments[0];
        if (call.name == "BindBuffer" && call.arguments[0] == GL_ARRAY_BUFFER)
            m_arrayBuffer = call.arguments[1];
        if (entry.key.empty())
            continue;
        const auto known = std::find_if(m_known.begin(), m_known.end(),
                                        [&](const Entry& each) { return each.key == entry.key; });
        if (known == m_known.end())
            m_known.push_back(std::move(entry));
        else if (known->value == entry.value)
            result.push_back(std::string(call.name) + " (" + entry.key + ")");
        else
            known->value = std::move(entry.value);
    }
    return result;
}

} // namespace franken::test
