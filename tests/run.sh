#!/bin/sh
# SPDX-License-Identifier: MIT
# tests/run.sh [PRESET...]: installs what is missing, builds the presets (dev, asan and fuzz) and runs all tests.
# Ends with a line that counts what passed, failed and was skipped.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
[ $# -gt 0 ] || set -- dev asan fuzz
"$root/toolchains/install-packages.sh" test

count() { sed -n "s/.*<testsuite.* $1=\"\([0-9]*\)\".*/\1/p" "$2" | head -n 1; }

# junit's attributes are on lines of their own in some versions of CTest.
flatten() { tr '\n\t' '  ' <"$1" >"$1.flat" && mv "$1.flat" "$1"; }

tests=0 failed=0 skipped=0
cd "$root"
for preset; do
    cmake --preset "$preset" >/dev/null
    cmake --build --preset "$preset" -- --quiet
    report=$root/build/$preset/tests.xml
    ctest --test-dir "build/$preset" -j "$(nproc)" --output-on-failure --progress --output-junit "$report" || true
    [ -s "$report" ] || { echo "no test ran for $preset" >&2; exit 1; }
    flatten "$report"
    tests=$((tests + $(count tests "$report")))
    failed=$((failed + $(count failures "$report")))
    skipped=$((skipped + $(count skipped "$report") + $(count disabled "$report")))
done

echo "$((tests - failed - skipped)) passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
