// SPDX-License-Identifier: MIT
#include <franken/generator/compose.h>

int main() { return franken::compose({}).fragment.text.empty() ? 1 : 0; }
