#!/bin/sh
# SPDX-License-Identifier: MIT
# root.sh PACKAGE.deb...: makes a bare system of this machine's Debian release, as a tarball that it prints: a compiler,
# and nothing of FrankenShader. What the packages depend on is downloaded into it, and not installed, so that installing
# them needs no network. Kept in ~/.cache/frankenshader by what it is made of. Exits with 77 where it cannot be had.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd -P)
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
tools=cmake,g++,libegl-dev,ninja-build,pkg-config
# Mesa, which they recommend, draws; the examples write PNG files with stb.
drivers='libgl1-mesa-dri libegl-mesa0 libosmesa6 libstb-dev'

skip() { echo "skipped: $1"; exit 77; }

key=$({ cat "$here/root.sh"; for package; do dpkg-deb -f "$package" Depends; done; } | sha256sum | cut -c1-12)
tarball=${XDG_CACHE_HOME:-$HOME/.cache}/frankenshader/root-$suite-$key.tar
if [ -f "$tarball" ]; then
    echo "$tarball"
    exit 0
fi
[ "$(id -u)" = 0 ] || skip "only root may make a bare system"
command -v debootstrap >/dev/null || skip "debootstrap is missing: toolchains/install-packages.sh test"
mkdir -p "$(dirname -- "$tarball")"
work=$(mktemp -d "$tarball.XXXXXX")
trap 'rm -rf -- "$work"' EXIT
eatmydata=
command -v eatmydata >/dev/null && eatmydata=eatmydata
$eatmydata debootstrap --variant=minbase --include="$tools" "$suite" "$work/root" "$("$here/../../toolchains/mirror.sh")" \
    >"$work/log" 2>&1 || { tail -n 3 "$work/log"; skip "debootstrap cannot make a system of Debian $suite here"; }
# No daemon is started in it, and a file is not waited for to be on the disk.
printf '#!/bin/sh\nexit 101\n' >"$work/root/usr/sbin/policy-rc.d"
chmod +x "$work/root/usr/sbin/policy-rc.d"
echo force-unsafe-io >"$work/root/etc/dpkg/dpkg.cfg.d/unsafe-io"
rm -f "$work"/root/var/cache/apt/archives/*.deb
mkdir "$work/root/debs"
cp -- "$@" "$work/root/debs"
# shellcheck disable=SC2086
chroot "$work/root" sh -c "apt-get -qq update && apt-get -qq -y --no-install-recommends --download-only install /debs/*.deb $drivers" \
    >"$work/log" 2>&1 || { tail -n 3 "$work/log"; skip "what the packages depend on cannot be downloaded"; }
rm -rf "$work/root/debs"
tar -C "$work/root" -cf "$work/root.tar" .
mv -- "$work/root.tar" "$tarball"
echo "$tarball"
