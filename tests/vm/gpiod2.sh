#!/bin/bash
# SPDX-License-Identifier: MIT
# gpiod2.sh: builds the platform with the libgpiod of Debian 13 (2.x), on a machine that has another one, and runs the guest's
# test of GPIO with it. The packages are unpacked into ${XDG_CACHE_HOME:-~/.cache}/frankenshader/gpiod2, and nothing is
# installed. Remove that folder to fetch them anew. Exits with 77 where they cannot be had, and says why.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/frankenshader/gpiod2
build=$root/build/gpiod2

skip() { echo "gpiod2.sh: skipped: $*" >&2; exit 77; }

# Through a source list of its own: the machine's is left as it is. The address is the one it has for Debian.
download() {
  command -v apt-get >/dev/null || skip "this is no Debian"
  local uri
  uri=$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' | head -n 1)
  [[ -n $uri ]] || skip "apt knows no Debian to fetch packages from (run apt-get update)"
  mkdir -p lists/partial archives/partial
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $uri trixie main" >sources.list
  local options=(-qq -o "Dir::Etc::SourceList=$PWD/sources.list" -o Dir::Etc::SourceParts=- -o "Dir::State::Lists=$PWD/lists"
    -o "Dir::Cache=$PWD" -o Debug::NoLocking=1 -o APT::Sandbox::User=root)
  apt-get "${options[@]}" update || skip "Debian cannot be reached"
  apt-get "${options[@]}" download libgpiod3/trixie libgpiod-dev/trixie || skip "libgpiod cannot be fetched"
}

if [[ ! -d $cache ]]; then
  work=$(mktemp -d "${TMPDIR:-/var/tmp}/frankenshader-gpiod2.XXXXXX")
  trap 'rm -rf "$work"' EXIT
  cd "$work"
  download
  for package in libgpiod*.deb; do dpkg-deb -x "$package" root; done
  mkdir -p "$(dirname "$cache")"
  sed -i "s|^prefix=.*|prefix=$cache/usr|" root/usr/lib/*/pkgconfig/libgpiod.pc
  mv root "$cache"
fi
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(ls "$cache"/usr/lib/*/pkgconfig/libgpiod.pc)")
pkg-config --modversion libgpiod | sed 's/^/libgpiod /'
cd "$root"
cmake --preset dev -B "$build" --log-level=WARNING >/dev/null
cmake --build "$build" --target vm_gpio_test
ldd "$build/bin/vm_gpio_test" | grep libgpiod
GALLIUM_DRIVER=softpipe "$here/guest.sh" "$build/bin/vm_gpio_test"
