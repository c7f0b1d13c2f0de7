// SPDX-License-Identifier: MIT
#pragma once

#include "frame_bill.h"

namespace price {

/// One thing that could be changed, and what the frame takes then.
struct Change {
    std::string words; ///< An option of the viewer's, or what to do.
    FrameBill bill;
};

struct FramePrice {
    int width = 0, height = 0;
    std::vector<FrameBill> bills; ///< Of machines(), in their order.
    std::size_t asked = 0;        ///< Index into the bills.
    std::vector<Change> changes; ///< On the machine that was asked for: the best first, kMostChanges at most.
    std::string whyNotCompiled;  ///< Empty where the compilers counted.
};

inline constexpr std::size_t kMostChanges = 3;

/// "pi0", "pi2" and so on.
std::vector<std::string> machineWords();

/// Counts the frame once and prices it on all machines. `machine` is one of machineWords(). Fails as
/// countFrame() and ProgramCosts::of() do.
franken::Result<FramePrice> priceFrame(const FrameContents& frame, std::string_view machine,
                                       const ProgramCosts& costs, const franken::SnippetSet& snippets);

/// A table that a person reads.
std::string toText(const FramePrice& price, const franken::SnippetSet& snippets);

/// The same and more as one JSON document, ended by a newline: "schema" is 1.
std::string toJson(const FramePrice& price, const franken::SnippetSet& snippets);

} // namespace price
