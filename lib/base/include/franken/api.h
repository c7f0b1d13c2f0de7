// SPDX-License-Identifier: MIT
#pragma once

/// Stands before the namespace in each public header, `namespace FRANKEN_API franken {`, and has a shared
/// library export all that the header declares. What private headers and .cpp files declare is hidden. Static
/// libraries take no notice.
#define FRANKEN_API [[gnu::visibility("default")]]
