#!/bin/sh
# SPDX-License-Identifier: MIT
# reproducible.sh: makes the Debian packages of the last commit twice, and says whether they are equal to the byte. The
# second time everything is compiled anew, in a folder of another name, in another time zone, locale and umask. Takes
# twice as long as packages.sh. Exits with 1 where a package differs.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
work=$(mktemp -d "${TMPDIR:-/var/tmp}/frankenshader-packages.XXXXXX")
trap 'rm -rf -- "$work"' EXIT

# make_in FOLDER: moves the packages that are made there to FOLDER.packages.
make_in() {
    git clone -q "$root" "$1"
    "$1/toolchains/packages.sh" >/dev/null
    mv "$1/build/packages" "$1.packages"
    rm -rf -- "$1"
}
make_in "$work/first"
(
    export CCACHE_DIR="$work/cache" TZ=Pacific/Kiritimati LC_ALL=C
    umask 077
    make_in "$work/second-with-a-longer-name"
)
diff "$work/first.packages/SHA256SUMS" "$work/second-with-a-longer-name.packages/SHA256SUMS" ||
    { echo "these packages differ" >&2; exit 1; }
echo "equal to the byte:"
cat "$work/first.packages/SHA256SUMS"
