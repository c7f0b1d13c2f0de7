#!/bin/sh
# SPDX-License-Identifier: MIT
# exports.sh PREFIX: the shared libraries that are installed there export what the public headers beside them
# declare: names of franken, and none that private headers declare. Says how many.
set -eu

fail() { echo "$1" >&2; exit 1; }

names() { nm --dynamic --defined-only --demangle "$(find "$1" -name "libfranken_$2.so")" | cut -d ' ' -f 3-; }

for library in base generator programs assets renderer; do
    exported=$(names "$1" "$library")
    others=$(echo "$exported" | grep -vE '^((vtable|typeinfo|typeinfo name) for )?franken::' || true)
    [ -z "$others" ] || fail "libfranken_$library.so exports what is not ours: $others"
    echo "$library: $(echo "$exported" | wc -l) symbols"
done

unmarked=$(find "$1/include/franken" -name '*.h' -exec grep -L FRANKEN_API {} +)
[ -z "$unmarked" ] || fail "no FRANKEN_API in $unmarked"

for name in 'generator franken::compose(' 'assets franken::loadGltf(' 'renderer franken::Renderer::draw('; do
    names "$1" "${name%% *}" | grep -qF "${name#* }" || fail "$name is not exported"
done
for name in 'generator franken::recipe(' 'assets franken::SrgbTables::' 'renderer franken::Renderer::State::'; do
    ! names "$1" "${name%% *}" | grep -qF "${name#* }" || fail "$name is exported"
done
