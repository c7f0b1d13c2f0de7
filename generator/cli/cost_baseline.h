// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"
#include "qpu_compiler.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace franken::cli {

/// What programs cost once: by name and GPU.
using CostBaseline = std::map<std::pair<std::string, std::string>, Cost>;

/// Reads the text of a document that `cost --json` wrote. Takes little more memory than the text, whatever
/// that is. Fails where the text is no JSON, no document of costs, or nests deeper than one; only `what` is
/// set.
Result<CostBaseline> parseCostBaseline(std::string_view text);

/// The same from a file. Fails with "cost.baseline".
Result<CostBaseline> readCostBaseline(const std::string& file);

} // namespace franken::cli
