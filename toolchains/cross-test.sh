#!/bin/sh
# SPDX-License-Identifier: MIT
# cross-test.sh arm64|armhf [bookworm|trixie] [quick]: builds for a Pi with its preset, and runs the tests in an
# emulator. "quick" builds and runs some of what compares with x86 alone: all texts to the byte, two pictures to the
# pixel. Installs nothing. Exits with 77, and says why, where a program or the sysroot cannot be had.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
arch=${1:-} suite=bookworm quick=no
case $arch in
arm64) emulator=qemu-aarch64 ;;
armhf) emulator=qemu-arm ;;
*) echo "usage: cross-test.sh arm64|armhf [bookworm|trixie] [quick]" >&2; exit 2 ;;
esac
shift
for word; do
    case $word in
    quick) quick=yes ;;
    *) suite=$word ;;
    esac
done

skip() { echo "skipped: $1"; exit 77; }

for program in clang++ ld.lld "$emulator"; do
    command -v "$program" >/dev/null || skip "$program is missing: toolchains/install-packages.sh test"
done
sysroot=$("$root/toolchains/sysroot.sh" "$arch" "$suite") || skip "no sysroot of Debian $suite for $arch: its packages cannot be had"

# -O1: half of the time is the compiler's, and what is compared does not depend on it.
build=$root/build/pi-$arch-$suite
cd "$root"
cmake --preset "pi-$arch" -B "$build" -DRPI_SYSROOT="$sysroot" -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
    -DFRANKEN_WERROR="${FRANKEN_WERROR:-OFF}" >/dev/null
targets=all tests=.
if [ "$quick" = yes ]; then
    targets='golden_test picture_test' tests='^Golden\.|PictureGolden\.(TheUrnOfMakeModel|AModelByOthers)/osmesa$'
fi
# shellcheck disable=SC2086
cmake --build "$build" --target $targets
exec ctest --test-dir "$build" -j "$(nproc)" -L cross -R "$tests" --no-tests=error --output-on-failure
