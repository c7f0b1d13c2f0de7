#!/bin/sh
# SPDX-License-Identifier: MIT
# packages.sh [REVISION]: makes the Debian packages of this machine's release and architecture in build/packages, from the
# presets package-static and package. Times in them are those of the commit (or of SOURCE_DATE_EPOCH), so that they can be
# built again alike. REVISION is what stands behind the dash of their version (1+deb12 on Debian 12).
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
cd "$root"
revision=${1:-1+deb$(. /etc/os-release && echo "$VERSION_ID")}
: "${SOURCE_DATE_EPOCH:=$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGELOG.md)}"
export SOURCE_DATE_EPOCH
static=$root/build/package-static shared=$root/build/package

cmake --preset package-static >/dev/null
cmake --build --preset package-static -- --quiet
cmake --preset package -DFRANKEN_DEBIAN_REVISION="$revision" -DFRANKEN_STATIC_TREE="$static" >/dev/null
cmake --build --preset package -- --quiet
# The site, where there is Doxygen.
ninja -C "$shared" -t query docs >/dev/null 2>&1 && cmake --build --preset package --target docs -- --quiet
rm -rf build/packages
umask 022
cpack --config "$shared/CPackConfig.cmake" -B "$root/build/packages" >"$shared/cpack.log" 2>&1 || { cat "$shared/cpack.log" >&2; exit 1; }
rm -rf build/packages/_CPack_Packages
(cd build/packages && sha256sum -- *.deb >SHA256SUMS && cat SHA256SUMS)
