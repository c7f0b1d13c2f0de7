#!/bin/sh
# SPDX-License-Identifier: MIT
# build.sh PRESET [CMAKE_OPTION...]: configures and builds a preset. Says how far it is: on a terminal as ninja does,
# elsewhere in ten lines; what the compiler has to say is shown in full.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
preset=$1
shift
cd "$root"
echo "Configuring $preset"
cmake --preset "$preset" "$@" >/dev/null
echo "Building $preset"
if [ -t 1 ]; then
    exec cmake --build --preset "$preset"
fi
status=$(mktemp)
trap 'rm -f "$status"' EXIT
{ NINJA_STATUS='[%f/%t] ' cmake --build --preset "$preset" && echo 0 >"$status" || echo 1 >"$status"; } 2>&1 |
    awk '/^\[[0-9]+\/[0-9]+\] / {
             split(substr($1, 2), step, "/")
             tenth = int(10 * step[1] / step[2])
             if (tenth != last) { printf "  %d of %d\n", step[1], step[2]; fflush() }
             last = tenth
             next
         }
         !/^ninja: no work to do/ { print; fflush() }'
exit "$(cat "$status")"
