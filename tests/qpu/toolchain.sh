#!/bin/bash
# SPDX-License-Identifier: MIT
# toolchain.sh: provides the compilers of the Raspberry Pi's GPUs and prints the folder they are in. bin/qpu-stats in it
# is qpu_stats.cpp beside this script; lib holds Mesa's vc4 and v3d drivers over the no-op DRM shims.
#
# They are kept below ${XDG_CACHE_HOME:-~/.cache}/frankenshader in folders named by the content of what makes them, so that
# the second call takes no time; "qpu" there always is the one made last. A ready-built Mesa is taken from beside the
# checkout (../shared/qpu) where there is one; otherwise mesa/build.sh builds it, which takes 4 to 8 minutes.
# Exits with 77 where the compilers cannot be had, and says why.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "$0")")
version=25.0.7
tarball=$here/../../../shared/qpu/qpu-mesa-$version.tar.xz
cache=${XDG_CACHE_HOME:-$HOME/.cache}/frankenshader

say() { echo "toolchain.sh: $*" >&2; }
key() { cat "$@" | sha256sum | cut -c1-16; }

if ! [[ $(uname -s -m) == "Linux x86_64" || $(uname -s -m) == "Linux aarch64" ]]; then
  say "skipped: Mesa's DRM shims need 64-bit Linux"
  exit 77
fi
mkdir -p "$cache"
mesa=$cache/mesa-$version-$(key "$here/mesa/build.sh" "$here/mesa/shims.patch")
prefix=$cache/qpu-$(key "$here/mesa/build.sh" "$here/mesa/shims.patch" "$here/qpu_stats.cpp")

exec 9>"$cache/lock"
flock 9
work=$(mktemp -d "$cache/work.XXXXXX")
trap 'rm -rf "$work"' EXIT

# Unpacked or built elsewhere and then renamed: a folder that exists is complete.
if [[ ! -d $mesa ]]; then
  if [[ $(uname -m) == x86_64 && -f $tarball ]]; then
    say "unpacking $(basename "$tarball")"
    mkdir "$work/mesa"
    tar xJf "$tarball" -C "$work/mesa"
  else
    say "building Mesa $version for its compilers: 4 to 8 minutes, once"
    "$here/mesa/build.sh" "$version" "$work" "$work/mesa" >&2
  fi
  mv "$work/mesa" "$mesa"
fi
if [[ ! -d $prefix ]]; then
  mkdir -p "$work/prefix/bin"
  ln -s "../${mesa##*/}/lib" "$work/prefix/lib"
  "${CXX:-g++}" -std=c++20 -O1 -o "$work/prefix/bin/qpu-stats" "$here/qpu_stats.cpp" -L"$mesa/lib" \
    -Wl,-rpath-link,"$mesa/lib" -lEGL -lGLESv2 -lgbm
  mv "$work/prefix" "$prefix"
fi
ln -sfn "${prefix##*/}" "$cache/qpu"
echo "$prefix"
