#!/bin/bash
# SPDX-License-Identifier: MIT
# kernel.sh: prints the path of the guest's kernel. The first of these that is there:
# - $FRANKEN_GUEST_KERNEL,
# - the one that kernel/build.sh made before, kept below ${XDG_CACHE_HOME:-~/.cache}/frankenshader by the content of what makes it,
# - a ready-built one beside the checkout (../shared/vm), which has no virtual consoles: the tests that need one are skipped,
# - one that is built now.
# Exits with 77 where none can be had, and says why.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
ready=$here/../../../shared/vm/linux-uml-6.1.xz
cache=${XDG_CACHE_HOME:-$HOME/.cache}/frankenshader

say() { echo "kernel.sh: $*" >&2; }

if [[ -n ${FRANKEN_GUEST_KERNEL:-} ]]; then
  echo "$FRANKEN_GUEST_KERNEL"
  exit 0
fi
if [[ $(uname -s -m) != "Linux x86_64" ]]; then
  say "skipped: a user-mode kernel needs 64-bit Linux on x86"
  exit 77
fi
mkdir -p "$cache"
exec 9>"$cache/kernel.lock"
flock 9
ours=$cache/linux-$(cat "$here"/kernel/* | sha256sum | cut -c1-16)
if [[ ! -x $ours && -f $ready ]]; then
  theirs=$cache/linux-$(sha256sum <"$ready" | cut -c1-16)
  if [[ ! -x $theirs ]]; then
    xz -dc "$ready" >"$theirs.part"
    chmod +x "$theirs.part"
    mv "$theirs.part" "$theirs"
  fi
  echo "$theirs"
  exit 0
fi
if [[ ! -x $ours ]]; then
  for tool in gcc make flex bison bc xz patch apt-get; do
    command -v "$tool" >/dev/null || { say "skipped: building the guest's kernel needs $tool"; exit 77; }
  done
  say "building the guest's kernel: 4 to 8 minutes, once"
  "$here/kernel/build.sh" "$ours.part" >&2 || { say "skipped: the guest's kernel cannot be built here"; exit 77; }
  mv "$ours.part" "$ours"
fi
echo "$ours"
