#!/bin/sh
# SPDX-License-Identifier: MIT
# install-packages.sh build|test|web: installs what is missing of debian-packages.txt. "test" includes the others, "web"
# is the playground's alone. Where it has no right to install, it says what is missing and exits with 1.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")" && pwd -P)
case ${1:-} in
build) wanted='build' ;;
test) wanted='build|test|web' ;;
web) wanted='web' ;;
*) echo "usage: install-packages.sh build|test|web" >&2; exit 2 ;;
esac

# A nodejs that is not Debian's brings npm along, and conflicts with Debian's.
is_there() {
    dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed ||
        { [ "$1" = npm ] && command -v npm >/dev/null; }
}

# What is missing of the packages "a,b,c".
missing_of() {
    for package in $(echo "$1" | tr ',' ' '); do
        is_there "$package" || printf ' %s' "$package"
    done
}

# Those of the packages that apt can install. One call for all, because each takes a third of a second.
known_of() {
    LC_ALL=C apt-cache policy "$@" 2>/dev/null |
        awk '/^[^ ].*:$/ { name = substr($0, 1, length($0) - 1) } /^  Candidate: [0-9]/ { print name }'
}

# Whether apt can install all of "a,b,c".
is_known() {
    # shellcheck disable=SC2046
    set -- $(echo "$1" | tr ',' ' ')
    [ "$(known_of "$@" | wc -l)" = $# ]
}

# Of "a,b|c,d", which are of different releases: nothing where all of one are there, else what is missing of those that
# apt knows, or of the first where it knows none.
missing_of_one() {
    case $1 in
    *'|'*) ;;
    *) missing_of "$1"; return ;;
    esac
    first=${1%%|*} known=
    for packages in $(echo "$1" | tr '|' ' '); do
        [ -n "$(missing_of "$packages")" ] || return 0
        [ -n "$known" ] || ! is_known "$packages" || known=$packages
    done
    missing_of "${known:-$first}"
}

list() {
    grep -v '^#' "$here/debian-packages.txt" | awk -v wanted="^($wanted)\$" '$2 ~ wanted {print $1}' |
        while read -r packages; do missing_of_one "$packages"; done
}

missing=$(list)
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
$as_root apt-get -qq update
# Only now does apt know which of several there are. Who needs one that no release here has, goes without or says so.
wanted=$(list) missing=
# shellcheck disable=SC2086
known=" $(known_of $wanted | tr '\n' ' ') "
for package in $wanted; do
    case $known in
    *" $package "*) missing="$missing $package" ;;
    *) echo "Not among this system's packages: $package" >&2 ;;
    esac
done
[ -n "$missing" ] || exit 0
echo "Installing:$missing"
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends $missing >/dev/null
