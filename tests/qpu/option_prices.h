// SPDX-License-Identifier: MIT
#pragma once

#include "table.h"

namespace franken::test {

/// What each option of each choice costs on the three GPUs, in the programs of the documentation's gallery
/// (toolchains/docs/gallery): the columns of option_prices.tsv. Needs compilers(). Throws std::runtime_error
/// where a program does not compile for a GPU.
Table optionPrices();

} // namespace franken::test
