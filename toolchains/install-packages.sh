#!/bin/sh
# SPDX-License-Identifier: MIT
# install-packages.sh build|test: installs what is missing of debian-packages.txt. "test" includes "build".
set -eu
here=$(cd "$(dirname "$0")" && pwd)
case ${1:-} in
build) wanted='build' ;;
test) wanted='build|test' ;;
*) echo "usage: install-packages.sh build|test" >&2; exit 2 ;;
esac

missing=
for package in $(grep -v '^#' "$here/debian-packages.txt" | awk -v wanted="^($wanted)\$" '$2 ~ wanted {print $1}'); do
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

echo "Installing:$missing"
if [ "$(id -u)" = 0 ]; then as_root=; else as_root=sudo; fi
$as_root apt-get -qq update
# shellcheck disable=SC2086
DEBIAN_FRONTEND=noninteractive $as_root apt-get -qq install -y --no-install-recommends $missing >/dev/null
