#!/bin/sh
# SPDX-License-Identifier: MIT
# promtool.sh: prints the path of promtool. Debian's package is unpacked and not installed, because it also starts a
# server that listens on all addresses. Says why, and exits with 1, where the package cannot be had.
set -eu
command -v promtool && exit
folder=${XDG_CACHE_HOME:-$HOME/.cache}/frankenshader/prometheus
program=$folder/usr/bin/promtool
if [ ! -x "$program" ]; then
    mkdir -p "$(dirname -- "$folder")"
    work=$(mktemp -d "$folder.XXXXXX")
    trap 'rm -rf -- "$work"' EXIT
    (cd "$work" && apt-get -qq download prometheus) >/dev/null 2>&1 ||
        { echo "promtool is missing, and Debian's package prometheus cannot be downloaded" >&2; exit 1; }
    dpkg-deb -x "$work"/prometheus_*.deb "$work/tree"
    mv -T "$work/tree" "$folder" 2>/dev/null || [ -x "$program" ]
fi
echo "$program"
