#!/bin/sh
# SPDX-License-Identifier: MIT
# sysroot.sh [--where] arm64|armhf [SUITE]: a folder with Debian's packages for a Pi, to compile against and to run
# programs in with qemu-user -L. Made where it is not there yet, by apt and dpkg, without root and without touching the
# packages of this machine. Prints the folder, which is named after what is in it; --where makes nothing.
# SUITE: bookworm (the default) or trixie. FRANKEN_SYSROOTS: where sysroots are kept.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd -P)
usage() { echo "usage: sysroot.sh [--where] arm64|armhf [bookworm|trixie]" >&2; exit 2; }

make=yes
if [ "${1:-}" = --where ]; then make=no; shift; fi
[ $# -ge 1 ] || usage
arch=$1 suite=${2:-bookworm}
case $arch in arm64 | armhf) ;; *) usage ;; esac
case $suite in bookworm) gcc=12 ;; trixie) gcc=14 ;; *) usage ;; esac

# The libraries of debian-packages.txt; libclang-rt-dev is the compiler's, and belongs to the machine that compiles.
packages="libc6-dev linux-libc-dev libstdc++-$gcc-dev assimp-testmodels
    $(awk '!/^#/ && $2 != "cross" && ($1 ~ /^lib/ || $1 ~ /^nlohmann/) && $1 !~ /^libclang/ {print $1}' "$here/debian-packages.txt")"
key=$(echo "$packages" | cat - "$here/sysroot.sh" | sha256sum | cut -c1-12)
root=${FRANKEN_SYSROOTS:-${XDG_CACHE_HOME:-$HOME/.cache}/frankenshader}/sysroot-$arch-$suite-$key
if [ "$make" = no ] || [ -d "$root" ]; then
    echo "$root"
    exit 0
fi

mkdir -p "$(dirname -- "$root")"
work=$(mktemp -d "$root.XXXXXX")
trap 'rm -rf -- "$work"' EXIT

# A state of apt's own, for the other architecture alone.
mkdir -p "$work/apt/lists/partial" "$work/apt/archives/partial"
: >"$work/apt/status"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $("$here/mirror.sh") $suite main" \
    >"$work/apt/sources.list"
cat >"$work/apt/apt.conf" <<EOF
APT::Architecture "$arch";
APT::Architectures { "$arch"; };
APT::Install-Recommends "false";
APT::Sandbox::User "";
Acquire::Languages "none";
Acquire::Retries "3";
Debug::NoLocking "true";
Dir::State "$work/apt";
Dir::State::status "$work/apt/status";
Dir::Cache "$work/apt";
Dir::Etc::sourcelist "$work/apt/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::Etc::parts "/dev/null";
Dir::Etc::main "/dev/null";
Dir::Etc::preferencesparts "/dev/null";
EOF
export APT_CONFIG="$work/apt/apt.conf"
apt-get -qq update >&2
# shellcheck disable=SC2086
apt-get -qq -y --download-only install $packages >&2

# /lib is a link into /usr, so that both names of a folder lead to one.
tree=$work/tree
mkdir -p "$tree/usr/bin" "$tree/usr/sbin" "$tree/usr/lib"
for folder in bin sbin lib; do ln -s "usr/$folder" "$tree/$folder"; done
for package in "$work"/apt/archives/*.deb; do
    dpkg-deb --fsys-tarfile "$package" | tar -x -C "$tree" --keep-directory-symlink --no-same-owner \
        --exclude='./usr/share/man*' --exclude='./usr/share/locale*' --exclude='./usr/share/lintian*'
done
# Links to absolute places would lead out of the sysroot.
find "$tree" -type l -lname '/*' | while read -r link; do ln -sfnr "$tree$(readlink "$link")" "$link"; done
# qemu before 8.2 shows programs this machine's /proc/cpuinfo, in which LLVM finds no NEON; llvmpipe draws wrong
# pictures then. qemu -L prefers this file.
if [ "$arch" = armhf ]; then
    mkdir -p "$tree/proc"
    {
        printf 'processor\t: 0\nmodel name\t: ARMv7 Processor rev 5 (v7l)\n'
        printf 'Features\t: half thumb fastmult vfp edsp neon vfpv3 tls vfpv4 idiva idivt vfpd32 lpae evtstrm\n'
        printf 'CPU implementer\t: 0x41\nCPU architecture: 7\nCPU variant\t: 0x0\nCPU part\t: 0xc07\nCPU revision\t: 5\n'
    } >"$tree/proc/cpuinfo"
fi
for package in "$work"/apt/archives/*.deb; do basename "$package"; done >"$tree/PACKAGES"
mv -T "$tree" "$root" 2>/dev/null || [ -d "$root" ]
echo "$root"
