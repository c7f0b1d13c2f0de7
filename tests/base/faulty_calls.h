// SPDX-License-Identifier: MIT
#pragma once

/// Begins to count system calls, from which on one may fail; returns how many there were so far.
int countCalls();
