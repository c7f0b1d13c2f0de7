#!/bin/sh
# SPDX-License-Identifier: MIT
# cross-test.sh arm64|armhf [bookworm|trixie] [quick]: builds for a Pi with its preset, and runs the tests in an
# emulator. "quick" builds and runs what compares with x86 alone: texts to the byte, pictures to the pixel.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
arch=${1:-} suite=bookworm quick=no
case $arch in arm64 | armhf) shift ;; *) echo "usage: cross-test.sh arm64|armhf [bookworm|trixie] [quick]" >&2; exit 2 ;; esac
for word; do
    case $word in
    quick) quick=yes ;;
    *) suite=$word ;;
    esac
done

"$root/toolchains/install-packages.sh" cross
sysroot=$("$root/toolchains/sysroot.sh" "$arch" "$suite")
build=$root/build/pi-$arch-$suite
cmake --preset "pi-$arch" -S "$root" -B "$build" -DRPI_SYSROOT="$sysroot" -DFRANKEN_EXAMPLES=ON \
    -DFRANKEN_WERROR="${FRANKEN_WERROR:-OFF}" >/dev/null
if [ "$quick" = yes ]; then
    cmake --build "$build" --target golden_test picture_test
    exec ctest --test-dir "$build" -j "$(nproc)" -L cross --output-on-failure -R 'Golden'
fi
cmake --build "$build"
exec ctest --test-dir "$build" -j "$(nproc)" -L cross --output-on-failure
