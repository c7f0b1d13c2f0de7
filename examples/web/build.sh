#!/bin/sh
# SPDX-License-Identifier: MIT
# build.sh OUT BIN: puts the playground into the folder OUT, files that any web server serves. BIN is where make_model is.
# What it compiles stays in OUT.build.
set -eu
[ $# = 2 ] || { echo "usage: examples/web/build.sh OUT BIN" >&2; exit 2; }
here=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd -P)
root=$here/../..
mkdir -p "$1"
out=$(realpath "$1") bin=$(realpath "$2")

[ -f "$out.build/build.ninja" ] || cmake -S "$here/module" -B "$out.build" -G Ninja -DCMAKE_BUILD_TYPE= \
    -DCMAKE_TOOLCHAIN_FILE="$root/toolchains/cmake/wasi.cmake" >/dev/null
cmake --build "$out.build" >"$out.build/log" 2>&1 || { cat "$out.build/log"; exit 1; }
gzip -9nc "$out.build/playground.wasm" >"$out/playground.wasm.gz"
cp "$here"/page/* "$root/tests/qpu/costs.tsv" "$root/tests/qpu/prices.md" "$out"
rm -rf "$out/glsl"
cp -r "$root/generator/glsl" "$out/glsl"
[ -f "$out/model.glb" ] || "$bin/make_model" "$out/model.glb"
[ -f "$out/evening.hdr" ] || "$bin/make_model" "$out/evening.hdr" 256
