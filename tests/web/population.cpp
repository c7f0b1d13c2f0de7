// SPDX-License-Identifier: MIT
// web_population: prints the names of the permutations that the large tests run over, one a line.
#include "population.h"

#include <iostream>

int main() {
    for (const franken::Permutation& permutation : franken::test::population())
        std::cout << franken::toName(permutation) << "\n";
}
