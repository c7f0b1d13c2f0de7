// SPDX-License-Identifier: MIT
// OSMesa forgets a few hundred bytes with each context.

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming)
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
