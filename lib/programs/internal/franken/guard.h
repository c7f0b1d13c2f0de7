// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "franken/result.h"

#include <exception>
#include <string>
#include <type_traits>
#include <utility>

/// No exception crosses the library's interface: neither one of its own (memory that ends) nor one that a
/// function of the application threw. In a build without exceptions, these only call.
namespace franken {

/// Calls `function`, which returns a Result; an exception becomes "renderer.exception".
template<typename Function>
std::invoke_result_t<Function> guarded(const char* where, Function&& function) {
#ifdef __cpp_exceptions
    const auto thrown = [&](const char* text) {
        return Error{"renderer.exception", where, std::string("an exception was thrown: ") + text,
                     "return an Error instead, or free memory"};
    };
    try {
        return std::forward<Function>(function)();
    } catch (const std::exception& exception) {
        return thrown(exception.what());
    } catch (...) {
        return thrown("of an unknown type");
    }
#else
    static_cast<void>(where);
    return std::forward<Function>(function)();
#endif
}

/// Calls `function`, whose failure nobody can be told of.
template<typename Function>
void quietly(Function&& function) noexcept {
#ifdef __cpp_exceptions
    try {
        std::forward<Function>(function)();
    } catch (...) {
        return;
    }
#else
    std::forward<Function>(function)();
#endif
}

/// The same log; exceptions that it throws are dropped, and the message with them.
inline Log guardedLog(Log log) {
    if (!log)
        return log;
    return [log = std::move(log)](LogLevel level, std::string_view message) {
        quietly([&] { log(level, message); });
    };
}

} // namespace franken
