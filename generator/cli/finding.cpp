// SPDX-License-Identifier: MIT
#include "finding.h"

namespace franken::cli {

std::string toLine(const Finding& finding) {
    return (finding.where.empty() ? finding.program : finding.where) + ": " + finding.check + ": " +
           finding.what + (finding.remedy.empty() ? "" : " (" + finding.remedy + ")") +
           (finding.where.empty() ? "" : " in " + finding.program) + "\n";
}

} // namespace franken::cli
