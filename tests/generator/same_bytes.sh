#!/bin/sh
# SPDX-License-Identifier: MIT
# same_bytes.sh SOURCE_DIR EMBEDDED_SNIPPETS OUT_DIR OUR_PROGRAM COMPILER_ID
# Builds text_hash with the other of g++ and clang++, and compares what both print. 77: skipped.
set -eu
source=$1 embedded=$2 out=$3 ours=$4
case $5 in
    GNU) compiler=clang++ ;;
    *) compiler=g++ ;;
esac
if ! command -v $compiler >/dev/null; then
    echo "skipped: $compiler is not installed"
    exit 77
fi
mkdir -p "$out"
$compiler -std=c++20 -O0 -I"$source/generator/include" -I"$source/generator/src" -I"$source/lib/base/include" \
    "$source"/generator/src/*.cpp "$source/lib/base/src/nearest.cpp" "$source/lib/base/src/printable.cpp" \
    "$source/lib/base/src/utf8.cpp" "$embedded" "$source/tests/generator/text_hash.cpp" -o "$out/text_hash"
expected=$("$ours")
actual=$("$out/text_hash")
echo "ours:  $expected"
echo "other: $actual ($compiler)"
[ "$expected" = "$actual" ]
