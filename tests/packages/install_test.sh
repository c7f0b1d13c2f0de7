#!/bin/sh
# SPDX-License-Identifier: MIT
# install_test.sh PACKAGES_DIR BIN_DIR: installs the packages of PACKAGES_DIR into a bare system, uses them there as an
# ordinary user (inside.sh), upgrades them, and removes them; nothing may be left. BIN_DIR: the programs of the build
# tree, which draw what the installed ones must draw. Exits with 77, and says why, where there is no such system.
set -eu
# What is mounted here, is mounted for this script alone.
if [ -z "${FRANKEN_OWN_MOUNTS:-}" ] && unshare --mount true 2>/dev/null; then
    FRANKEN_OWN_MOUNTS=yes exec unshare --mount "$0" "$@"
fi
here=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd -P)
packages=$1 bin=$2
fail() { echo "FAILED: $1"; exit 1; }
step() { echo "== $1"; }

tarball=$("$here/root.sh" "$packages"/*.deb) || { code=$?; echo "$tarball"; exit $code; }
work=$(mktemp -d)
trap 'umount "$work/root/proc" 2>/dev/null || true; rm -rf --one-file-system -- "$work"' EXIT
root=$work/root
mkdir "$root"
tar -C "$root" -xf "$tarball"
mount -t proc proc "$root/proc" 2>/dev/null || true
inside() { DEBIAN_FRONTEND=noninteractive chroot "$root" "$@"; }
apt() { inside apt-get -qq -y "$@" >"$work/log" 2>&1 || { cat "$work/log"; fail "apt-get $*"; }; }

# All files but the package manager's own records, with their kinds, sizes and times of data.
snapshot() {
    (cd "$root" && find . -path ./proc -prune -o -path ./var/lib/dpkg -prune -o -path ./var/lib/apt -prune -o \
        -path ./var/cache -prune -o -path ./var/log -prune -o -path ./debs -prune -o -path ./etc/ld.so.cache -prune -o \
        \( -type d -printf '%p %y %m\n' \) -o -printf '%p %y %m %s %T@\n' | sort)
}

step "install"
mkdir "$root/debs"
cp -- "$packages"/*.deb "$root/debs"
snapshot >"$work/before"
installed() { inside dpkg-query -W -f '${Package}\n' | sort; }
installed >"$work/packages"
apt install --no-install-recommends $(cd "$root" && ls -d debs/*.deb | sed 's/^/\//') libgl1-mesa-dri libegl-mesa0 libosmesa6 libstb-dev
"$here/../embed/links.sh" "$root/usr/share/doc/frankenshader-doc" || fail "a page leads nowhere"

step "use, as an ordinary user"
user=$root/home/visitor
mkdir -p "$user"
"$bin/make_model" "$user/urn.glb"
"$bin/make_model" "$user/lake.hdr"
GALLIUM_DRIVER=softpipe MESA_SHADER_CACHE_DISABLE=true "$bin/viewer" "$user/urn.glb" -o "$user/urn.png" --size 160x120
cp -r "$here/shaders" "$here/inside.sh" "$user"
chown -R 1000:1000 "$user"
inside env -i PATH=/usr/bin:/bin setpriv --reuid 1000 --regid 1000 --clear-groups /home/visitor/inside.sh /home/visitor || fail "as an ordinary user"

step "upgrade"
for package in "$root"/debs/*.deb; do
    dpkg-deb -R "$package" "$work/next"
    sed -i -E 's/^(Version: .*)$/\1.1/; s/(\(= [^)]*)\)/\1.1)/g' "$work/next/DEBIAN/control"
    sed -i -E 's/(\(= [^)]*)\)/\1.1)/' "$work/next/DEBIAN/shlibs" 2>/dev/null || true
    dpkg-deb -b -Zgzip -z1 --root-owner-group "$work/next" "$package" >/dev/null
    rm -r "$work/next"
done
names=$(for package in "$packages"/*.deb; do dpkg-deb -f "$package" Package; done)
apt install --no-install-recommends $(cd "$root" && ls -d debs/*.deb | sed 's/^/\//')
for name in $names; do
    inside dpkg-query -W -f '${Package} ${Version}\n' "$name" | grep '\.1$' || fail "$name is not upgraded"
done
inside frankenshader --version

step "remove"
rm -r "$user"
# Them, and what came with them.
# shellcheck disable=SC2046
apt purge $(installed | comm -13 "$work/packages" -)
snapshot >"$work/after"
diff "$work/before" "$work/after" >"$work/left" || { cat "$work/left"; fail "something is left, or gone"; }
echo "nothing is left of $(echo $names)"
