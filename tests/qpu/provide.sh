#!/bin/bash
# SPDX-License-Identifier: MIT
# provide.sh RESULT: runs toolchain.sh once for all tests of a run, and writes what came of it to the file RESULT:
# "folder PATH", or "skipped: REASON". Exits with 77 where the compilers cannot be had, as toolchain.sh does.
set -uo pipefail
here=$(dirname -- "$(readlink -f -- "$0")")
result=$1
mkdir -p "$(dirname -- "$result")"
folder=$("$here/toolchain.sh" 2>"$result.log")
code=$?
cat "$result.log" >&2
if [[ $code == 0 ]]; then
  echo "folder $folder" >"$result"
elif [[ $code == 77 ]]; then
  echo "skipped: $(sed -n 's/.*skipped: //p' "$result.log" | tail -n 1)" >"$result"
else
  rm -f "$result"
fi
exit $code
