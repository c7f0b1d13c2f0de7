// SPDX-License-Identifier: MIT
#pragma once

#include "option_programs.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace franken::gallery {

/// What a program costs on one GPU: instructions of the fragment shader, its threads, and instructions of the
/// vertex and coordinate shaders together.
struct GpuPrice {
    int fragment = 0, threads = 0, vertex = 0;
};

/// On vc4, v3d 4.2 and v3d 7.1.
using Prices = std::array<GpuPrice, 3>;

/// The columns of option_prices.tsv, by an option's word and its program's name.
using PriceTable = std::map<std::pair<std::string, std::string>, Prices>;

/// Reads the table. Fails with "gallery.prices" where it is not there or not such a table.
Result<PriceTable> readPrices(const std::filesystem::path& file);

/// "gallery-WORD.png"
std::string pictureName(const Option& option);

/// The page's text, as Doxygen reads it: for each choice a heading, and for each of its options picture,
/// word, meaning and price. Fails with "gallery.prices" where the table has not got an option in its program.
Result<std::string> pageOf(const std::vector<ChoiceProgram>& choices, const PriceTable& prices);

} // namespace franken::gallery
