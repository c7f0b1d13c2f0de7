#!/bin/sh
# SPDX-License-Identifier: MIT
# install-packages.sh build|test: installs what is missing of debian-packages.txt. "test" includes "build". Where it
# has no right to install, it says what is missing and exits with 1.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd -P)
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

as_root=
if [ "$(id -u)" != 0 ]; then
    as_root=sudo
    # It may ask for a password where someone can type one.
    if ! command -v sudo >/dev/null || { ! sudo -n true 2>/dev/null && ! [ -t 0 ]; }; then
        echo "These packages are missing, and only root may install them:" >&2
        echo "    apt-get install --no-install-recommends$missing" >&2
        exit 1
    fi
fi
echo "Installing:$missing"
$as_root apt-get -qq update
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends $missing >/dev/null
