// SPDX-License-Identifier: MIT
// Precompiled headers belong to a program: this is the one of all tests, and does nothing else.
int main() {}
