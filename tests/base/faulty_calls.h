// SPDX-License-Identifier: MIT
#pragma once

/// Begins to count system calls, from which on one may fail; returns how many there were so far.
int countCalls();

/// Their names since then, with a space behind each; a folder that is brought to the disk is "fsync/".
const char* namesOfCalls();
