#!/bin/sh
# SPDX-License-Identifier: MIT
# Asks clang-tidy for includes that are not used. (That a file names what another header of ours includes for it is
# this project's habit, and not asked for.) The check came with clang-tidy 17, which Debian 12 does not have: `pip install clang-tidy==18.1.8`, or CLANG_TIDY=/path/to/it.
# It takes minutes, and so is no part of CI. Usage: tests/tidy.sh [FOLDER…]
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- generator/src lib/base/src lib/programs/src

tool=${CLANG_TIDY:-}
for name in clang-tidy clang-tidy-20 clang-tidy-19 clang-tidy-18 clang-tidy-17; do
    [ -n "$tool" ] || ! command -v "$name" > /dev/null ||
        [ "$("$name" --version | sed -n 's/.*version \([0-9]*\).*/\1/p')" -lt 17 ] || tool=$name
done
if [ -z "$tool" ]; then
    echo "SKIPPED: there is no clang-tidy of version 17 or later"
    exit 0
fi

# A sanitizer's or a package's settings do not matter here; the embedded snippets are built because they are a source.
cmake --preset dev -DCMAKE_EXPORT_COMPILE_COMMANDS=ON > /dev/null
unused=$(find "$@" -name '*.cpp' -print0 |
    xargs -0 -P "$(nproc)" -n 4 "$tool" -p build/dev --quiet --checks='-*,misc-include-cleaner' \
        --config='{HeaderFilterRegex: "^$"}' --extra-arg=-Wno-unknown-warning-option 2>/dev/null |
    grep 'is not used directly' | sort -u || true)
[ -z "$unused" ] || { echo "$unused"; exit 1; }
