#!/bin/sh
# SPDX-License-Identifier: MIT
# tests/web/run.sh build|module|playground|seeds|population: what CTest runs with the label "web". In the environment: SITE,
# where the playground is built, BIN, where this build's programs are, WORK, a folder of its own, and SEEDS, where the
# pages are that the presets are of. By hand: population, for example with
#     SITE=build/dev/web BIN=build/dev/bin WORK=build/dev/web.tests tests/web/run.sh population
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd -P)

skip() {
    echo "skipped: $1"
    exit 77
}

browser() {
    for name in chromium chromium-browser google-chrome; do
        command -v "$name" && return
    done
    return 1
}

# Another run of the tests in this build tree may be at it.
prepare() {
    command -v npm >/dev/null || skip "npm is not installed"
    CHROMIUM=$(browser) || skip "Chromium is not installed"
    export CHROMIUM
    mkdir -p "$WORK"
    exec 9>"$WORK/lock"
    flock 9
    cp "$here"/*.mjs "$here"/package*.json "$WORK"
    cmp -s "$here/package-lock.json" "$WORK/node_modules/.made-of" || {
        (cd "$WORK" && npm ci --loglevel=error --no-audit --no-fund --no-progress >&2)
        cp "$here/package-lock.json" "$WORK/node_modules/.made-of"
    }
    flock -u 9
}

SITE=$(realpath -m "${SITE:?}") BIN=$(realpath -m "${BIN:?}") WORK=$(realpath -m "${WORK:?}")
SERVE=$here/../../examples/web/serve.py
export SITE BIN WORK SERVE

case ${1:-} in
build)
    exec "$here/../../examples/web/build.sh" "$SITE" "$BIN"
    ;;
module)
    [ -f "$SITE/playground.wasm.gz" ] || skip "the playground is not built"
    command -v node >/dev/null || skip "node is not installed"
    exec node --test "$here/module_test.mjs"
    ;;
playground | seeds | population)
    [ "$1" != seeds ] || [ -d "$SEEDS" ] || skip "the pages that the presets are of are not there"
    [ -f "$SITE/playground.wasm.gz" ] || skip "the playground is not built"
    prepare
    cd "$WORK"
    exec node --test "$1_test.mjs"
    ;;
*)
    echo "usage: tests/web/run.sh build|module|playground|seeds|population" >&2
    exit 2
    ;;
esac
