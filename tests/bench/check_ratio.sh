#!/bin/sh
# SPDX-License-Identifier: MIT
# check_ratio.sh BIN_DIR: the time that `frankenshader check` takes a program, of 240 at once and of 24 alone, and
# their ratio. Starting glslang takes most of it, so that one process for many programs pays.
set -eu
[ $# = 1 ] || { echo "usage: check_ratio.sh BIN_DIR" >&2; exit 2; }
program=$(realpath -- "$1")/frankenshader
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
"$program" list --where lit --limit 240 >"$folder/names" 2>/dev/null

now() { date +%s%N; }
# A program over a budget is a finding (exit code 1), and is checked all the same.
check() { "$program" check "$@" >/dev/null 2>&1 || [ $? = 1 ]; }

begin=$(now)
check --manifest "$folder/names"
batch=$((($(now) - begin) / 240))
begin=$(now)
head -n 24 "$folder/names" | while read -r name; do check "$name"; done
alone=$((($(now) - begin) / 24))
echo "at once $((batch / 1000)) us a program, alone $((alone / 1000)) us: $((100 * batch / alone)) %"
