#!/bin/sh
# SPDX-License-Identifier: MIT
# abi.sh DIR [OLD]: writes what the shared libraries promise to programs that were linked with them into DIR, a file for
# each library (libabigail's XML), and compares it with the files of an earlier release in the folder OLD. Exits with 1
# where a program linked with that release would break: then the version's second number has to go up while the first
# is 0. Needs abigail-tools; exits with 77 where it is missing.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
[ $# -ge 1 ] || { echo "usage: abi.sh DIR [OLD]" >&2; exit 2; }
mkdir -p "$1"
dir=$(CDPATH='' cd -- "$1" && pwd -P)
old=${2:-}
[ -z "$old" ] || [ -d "$old" ] || { echo "abi.sh: $old is not a folder" >&2; exit 2; }
command -v abidw >/dev/null || { echo "skipped: abidw is missing: apt-get install abigail-tools"; exit 77; }

# The libraries of the packages, with the types that only debugging information has.
build=$root/build/abi
cmake -S "$root" --preset package -B "$build" -DCMAKE_CXX_FLAGS=-g -DFRANKEN_CLI=OFF -DFRANKEN_EXAMPLES=OFF >/dev/null
cmake --build "$build" -- --quiet

# What no public header declares is nobody's promise.
headers=
for folder in "$root"/generator/include "$root"/lib/*/include "$root"/platform/include; do
    headers="$headers --headers-dir $folder"
done
broken=0
for library in $(find "$build" -type f -name 'libfranken_*.so.*' | sort); do
    name=$(basename "$library" | sed 's/\.so\..*//')
    # shellcheck disable=SC2086
    abidw $headers --drop-private-types --no-corpus-path --no-comp-dir-path --out-file "$dir/$name.abi" "$library"
    echo "$dir/$name.abi"
    [ -n "$old" ] || continue
    [ -f "$old/$name.abi" ] || { echo "$name is new"; continue; }
    # Of abidiff's codes, bit 3 is an interface that breaks programs; bits 0 and 1 are errors of its own.
    code=0
    abidiff --no-added-syms "$old/$name.abi" "$dir/$name.abi" || code=$?
    [ $((code & 3)) = 0 ] || exit 2
    [ $((code & 8)) = 0 ] || { echo "$name breaks programs that were linked with the earlier release"; broken=1; }
done
exit $broken
