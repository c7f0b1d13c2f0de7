#!/bin/sh
# SPDX-License-Identifier: MIT
# tests/run.sh [PRESET...]: installs what is missing, builds the presets (dev, asan and fuzz) and runs all tests.
# Ends with the reasons of what was skipped, and a line that counts what passed, failed and was skipped. Warnings are
# errors in a build tree that has them so, and where FRANKEN_WERROR=ON is set, as CI does: not for who tries a newer
# compiler.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
[ $# -gt 0 ] || set -- dev asan fuzz
"$root/toolchains/install-packages.sh" test

count() { sed -n "s/.*<testsuite.* $1=\"\([0-9]*\)\".*/\1/p" "$2" | head -n 1; }

# junit's attributes are on lines of their own in some versions of CTest.
flatten() { tr '\n\t' '  ' <"$1" >"$1.flat" && mv "$1.flat" "$1"; }

# GoogleTest's reason stands below "file:line: Skipped", a script's behind "skipped: ".
reasons() {
    awk '/: Skipped$/ { getline; print }
         /skipped: / { sub(/.*skipped: /, ""); print }' "$1" | sed 's/&quot;/"/g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g'
}

werror() { sed -n 's/^FRANKEN_WERROR:[A-Z]*=//p' "build/$1/CMakeCache.txt" 2>/dev/null || true; }

tests=0 failed=0 skipped=0
cd "$root"
why=$(mktemp)
trap 'rm -f "$why"' EXIT
for preset; do
    kept=$(werror "$preset")
    "$root/toolchains/build.sh" "$preset" "-DFRANKEN_WERROR=${FRANKEN_WERROR:-${kept:-OFF}}"
    report=$root/build/$preset/tests.xml
    ctest --test-dir "build/$preset" -j "$(nproc)" --output-on-failure --progress --output-junit "$report" || true
    [ -s "$report" ] || { echo "no test ran for $preset" >&2; exit 1; }
    reasons "$report" >>"$why"
    flatten "$report"
    tests=$((tests + $(count tests "$report")))
    failed=$((failed + $(count failures "$report")))
    skipped=$((skipped + $(count skipped "$report") + $(count disabled "$report")))
done

if [ -s "$why" ]; then
    echo "Skipped, and why:"
    sort "$why" | uniq -c
fi
echo "$((tests - failed - skipped)) passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
