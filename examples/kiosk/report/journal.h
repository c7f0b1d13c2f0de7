// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"

namespace kiosk {

/// A log to standard error. Where that is the journal ($JOURNAL_STREAM), each line begins with its severity,
/// as sd-daemon(3) has it: "<4>" for warnings.
franken::Log journal();

} // namespace kiosk
