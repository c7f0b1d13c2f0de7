// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"
#include "json.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

// How the page and the module hand things over: the page writes bytes into the input and calls an exported
// function; what that answers is a text, which stays until the next call, or an address in the module's
// memory.

/// Calls of the page. A test calls them natively.
#ifdef __wasm__
#define FRANKEN_EXPORT(name) extern "C" __attribute__((export_name(#name), used))
#else
#define FRANKEN_EXPORT(name) extern "C"
#endif

namespace franken::web {

/// The page's bytes.
std::span<const std::uint8_t> input();
/// The first of them as a text.
std::string_view inputText(std::size_t size);
/// The input as numbers, from its beginning; where it is too short, the rest is 0.
std::span<const double> inputNumbers(std::size_t count);

/// What the page reads next.
void answer(const Json& json);
void answer(std::string text);
void answer(const Error& error);

/// {"code", "where", "what", "remedy", "text"} as a member "error" of an object.
void writeError(Json& json, const Error& error);

} // namespace franken::web
