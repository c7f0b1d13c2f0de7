// SPDX-License-Identifier: MIT
#pragma once

#include "session.h"

/// Draws, and draws again whenever the model, what lies beside it, the height map, the sky or a snippet has
/// changed, until SIGINT or SIGTERM. An error is reported, and the last good picture stays. Looks at the
/// files' times ten times a second.
void watch(Session& session, const Options& options);
