#!/bin/sh
# SPDX-License-Identifier: MIT
# build.sh OUT BIN: puts the playground into the folder OUT, files that any web server serves. BIN is where make_model is.
# What it compiles is the same for every OUT and stays in build/web.module of the sources, or in PLAYGROUND_OBJECTS; of two that
# compile there at a time, one waits. What is up to date is left alone, because tests may be reading it. Exits with 77
# where the compiler is missing.
set -eu
[ $# = 2 ] || { echo "usage: examples/web/build.sh OUT BIN" >&2; exit 2; }
here=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd -P)
root=$(realpath "$here/../..")
# Later ones are in toolchains/cmake/wasi.cmake, and untried: their library has what examples/web/module/system has.
[ -f /usr/lib/llvm-14/lib/wasm32-wasi/libc++.a ] || {
    echo "skipped: there is no clang 14 with WASI's libraries: toolchains/install-packages.sh web installs them on Debian 12" >&2
    exit 77
}
objects=${PLAYGROUND_OBJECTS:-$root/build/web.module}
mkdir -p "$1" "$objects"
out=$(realpath "$1") bin=$(realpath "$2")

exec 9>"$objects/lock"
flock 9
[ -f "$objects/build.ninja" ] || cmake -S "$here/module" -B "$objects" -G Ninja -DCMAKE_BUILD_TYPE= \
    -DCMAKE_TOOLCHAIN_FILE="$root/toolchains/cmake/wasi.cmake" >/dev/null
cmake --build "$objects" >"$objects/log" 2>&1 || { cat "$objects/log" >&2; exit 1; }
# Moved there once they are whole: what a run that was stopped left would be taken for up to date.
[ "$out/playground.wasm.gz" -nt "$objects/playground.wasm" ] || {
    gzip -9nc "$objects/playground.wasm" >"$objects/made.gz"
    mv "$objects/made.gz" "$out/playground.wasm.gz"
}
cp -u "$here"/page/* "$root/tests/qpu/costs.tsv" "$root/tests/qpu/prices.md" "$out"
diff -rq "$root/generator/glsl" "$out/glsl" >/dev/null 2>&1 || {
    rm -rf "$out/glsl"
    cp -r "$root/generator/glsl" "$out/glsl"
}
[ -f "$out/model.glb" ] || {
    "$bin/make_model" "$objects/made.glb"
    mv "$objects/made.glb" "$out/model.glb"
}
[ -f "$out/evening.hdr" ] || {
    "$bin/make_model" "$objects/made.hdr" 256
    mv "$objects/made.hdr" "$out/evening.hdr"
}
