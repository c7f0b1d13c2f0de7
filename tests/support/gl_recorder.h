// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace franken::test {

/// One call of a GL function, without "gl".
struct GlCall {
    std::string_view name;
    std::vector<std::uint64_t>
        arguments; ///< Integers as they are, floats as their bits, pointers' addresses.
};

/// A table that notes each call in recordedCalls() and hands it on. One at a time: a second call redirects
/// the table of the first.
Gl recordingGl(const Gl& real);

/// The calls since the list was cleared.
std::vector<GlCall>& recordedCalls();

/// How many of the recorded calls have that name.
std::size_t countCalls(std::string_view name);

/// The recorded calls that ask the driver for something, or make it wait.
std::vector<std::string> callsThatAsk();

/// Follows GL's state through calls; nothing is known at first.
class StateFollower {
public:
    /// The calls that set state to what it is already. Framebuffers, the viewport and uniforms are left out.
    std::vector<std::string> redundant(const std::vector<GlCall>& calls);

private:
    using Words = std::vector<std::uint64_t>;
    struct Entry {
        std::string key;
        Words value;
    };
    Entry entryOf(const GlCall& call);

    std::vector<Entry> m_known;
    std::uint64_t m_unit = 0, m_arrayBuffer = 0;
};

} // namespace franken::test
