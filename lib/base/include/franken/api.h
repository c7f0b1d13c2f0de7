// SPDX-License-Identifier: MIT
#pragma once

/// Stands before the namespace in each public header, `namespace FRANKEN_API franken {`: a shared library
/// then exports all declarations of the header, and hides those of private headers and .cpp files. No effect
/// on static libraries.
#define FRANKEN_API [[gnu::visibility("default")]]
