// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace franken::test {

/// Reads any bytes as a font, and asks it for all that it has: characters, kerning, lines, glyphs at several
/// sizes. Returns what does not hold of what font.h and text_layout.h promise; empty where all does.
std::string brokenPromiseOf(std::span<const std::uint8_t> file);

} // namespace franken::test
