// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl.h"

#include <cstddef>

namespace franken::test {

/// What happens from a call on.
enum class Fault {
    None,
    OneCall,    ///< The call does nothing, returns and writes nothing, and GL reports that memory is used up.
    Dies,       ///< All calls do nothing and return 0; GL reports no error.
    DiesLoudly, ///< Likewise, and GL reports that the context was lost, without end.
    EndlessErrors, ///< Calls do nothing, and GL reports invalid operations without end.
    NoNames,       ///< glCreate* and glGen* return no names; all else works.
};

/// A table that hands calls on to `real` until the call of that number (from 0). One at a time: a second call
/// redirects the table of the first.
Gl faultyDriver(const Gl& real, Fault fault, std::size_t at);

/// How many calls there were.
std::size_t callsOfFaultyDriver();

} // namespace franken::test
