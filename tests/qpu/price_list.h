// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace franken::test {

/// The page that has a copy of the list, from the root of the sources.
inline constexpr const char* kPageOfCosts = "toolchains/docs/handbook/costs.md";

/// A Markdown table: what each feature adds on each GPU. Needs compilers().
std::string priceList();

/// The text with that list between the lines "<!-- prices -->" and "<!-- /prices -->"; the text itself where
/// there are none.
std::string withPriceList(const std::string& text, const std::string& list);

} // namespace franken::test
