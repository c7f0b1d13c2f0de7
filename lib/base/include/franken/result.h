// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <cassert>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace FRANKEN_API franken {

/// What failed, where, and what to do about it. Made for whatever a user, a file or a device can cause;
/// what only a bug can cause is asserted instead.
struct Error {
    std::string code;   ///< Stable, for programs: "permutation.unknown-word", "gltf.index-range", ...
    std::string where;  ///< File and line, JSON path, device, or the offending word; may be empty.
    std::string what;   ///< One sentence, for people.
    std::string remedy; ///< What to do; may be empty.
};

/// "where: what (remedy) [code]", on one line.
inline std::string toString(const Error& error) {
    std::string text = error.where.empty() ? error.what : error.where + ": " + error.what;
    if (!error.remedy.empty())
        text += " (" + error.remedy + ")";
    return text + " [" + error.code + "]";
}

/// A value or the reason why there is none. The names are those of C++23's std::expected, which the
/// compilers of Debian 12 do not have yet, so that a later switch is a type alias.
template<typename T>
class [[nodiscard]] Result {
public:
    /// What std::expected calls T.
    using value_type = T;

    /// Success.
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    /// Failure.
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    /// Whether there is a value, and no error.
    bool has_value() const { return m_state.index() == 0; }
    explicit operator bool() const { return has_value(); }

    /// The value; calling it where has_value() is false is a bug. That of a temporary is returned by value,
    /// so that `for (const auto& entry : *list())` runs over something that lives.
    T& value() & { return *present(std::get_if<0>(&m_state)); }
    const T& value() const& { return *present(std::get_if<0>(&m_state)); }
    T value() && { return std::move(*present(std::get_if<0>(&m_state))); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    /// The error; calling it where has_value() is true is a bug.
    const Error& error() const& { return *present(std::get_if<1>(&m_state)); }
    Error&& error() && { return std::move(*present(std::get_if<1>(&m_state))); }

    /// What `next` makes of the value, a Result of its own; or this error. For a function whose last step may
    /// fail: `return parsed.and_then(canonicalise);`
    template<typename Next>
    auto and_then(Next&& next) && -> std::invoke_result_t<Next, T&&> {
        if (!has_value())
            return std::move(*this).error();
        return std::forward<Next>(next)(std::move(*std::get_if<0>(&m_state)));
    }

    /// What `function` makes of the value, which cannot fail (or Result<void>, where it returns nothing); or
    /// this error.
    template<typename Function>
    auto transform(Function&& function) && -> Result<std::invoke_result_t<Function, T&&>> {
        using Made = std::invoke_result_t<Function, T&&>;
        if (!has_value())
            return std::move(*this).error();
        if constexpr (std::is_void_v<Made>) {
            std::forward<Function>(function)(std::move(*std::get_if<0>(&m_state)));
            return Result<Made>();
        } else {
            return std::forward<Function>(function)(std::move(*std::get_if<0>(&m_state)));
        }
    }

private:
    template<typename Pointer>
    static Pointer present(Pointer pointer) {
        return assert(pointer), pointer;
    }

    std::variant<T, Error> m_state;
};

/// Success without a value.
template<>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    /// Failure.
    Result(Error error) : m_error(std::move(error)), m_failed(true) {}
    /// Whether it succeeded.
    bool has_value() const { return !m_failed; }
    explicit operator bool() const { return has_value(); }
    /// The error; calling it where has_value() is true is a bug.
    const Error& error() const { return assert(m_failed), m_error; }

    /// What `next` returns, a Result; or this error.
    template<typename Next>
    auto and_then(Next&& next) const -> std::invoke_result_t<Next> {
        if (m_failed)
            return m_error;
        return std::forward<Next>(next)();
    }

private:
    Error m_error;
    bool m_failed = false;
};

} // namespace franken
