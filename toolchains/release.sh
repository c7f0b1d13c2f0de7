#!/bin/sh
# SPDX-License-Identifier: MIT
# release.sh VERSION [OLD_ABI]: makes a release of what is committed: writes the version into CMakeLists.txt, heads
# CHANGELOG's unreleased section with it, commits, tags vVERSION, and makes the Debian packages, the sources, the dumps of
# the interface (abi.sh; compared with those of OLD_ABI) and checksums in build/release-VERSION. Pushes nothing.
# release.sh --prepare VERSION: the commit and the tag alone.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
fail() { echo "release.sh: $1" >&2; exit 1; }
prepare_only=no
[ "${1:-}" != --prepare ] || { prepare_only=yes; shift; }
version=${1:-} old_abi=${2:-}
echo "$version" | grep -qxE '(0|[1-9][0-9]*)(\.(0|[1-9][0-9]*)){2}' ||
    { echo "usage: release.sh [--prepare] MAJOR.MINOR.PATCH [OLD_ABI]" >&2; exit 2; }

cd "$root"
[ -z "$(git status --porcelain)" ] || fail "there are changes that are not committed: git status"
! git rev-parse -q --verify "refs/tags/v$version" >/dev/null || fail "the tag v$version is there already"
now=$(sed -n 's/^project(FrankenShader VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
newest=$(printf '%s\n%s\n' "$now" "$version" | sort -V | tail -n 1)
[ "$newest" = "$version" ] || fail "$version comes before the present version, $now"
unreleased=$(awk '/^## /{ on = ($2 == "Unreleased"); next } on && /^- /' CHANGELOG.md)
[ -n "$unreleased" ] || fail "CHANGELOG.md has nothing below \"## Unreleased\""

sed -i "s/^project(FrankenShader VERSION $now /project(FrankenShader VERSION $version /" CMakeLists.txt
sed -i "s/^## Unreleased\$/## Unreleased\n\n## $version, $(date -u +%F)/" CHANGELOG.md
git commit -q -m "Release $version" CMakeLists.txt CHANGELOG.md
git tag -a -m "FrankenShader $version" "v$version"
echo "tagged v$version; git push --follow-tags publishes it"
[ "$prepare_only" = no ] || exit 0

out=$root/build/release-$version
rm -rf "$out"
mkdir -p "$out"
toolchains/packages.sh >/dev/null
mv build/packages/*.deb "$out"
git archive --format=tar --prefix="frankenshader-$version/" "v$version" | xz -9 >"$out/frankenshader-$version.tar.xz"
# shellcheck disable=SC2086
toolchains/abi.sh "$out/abi" $old_abi || [ $? = 77 ] || fail "the interface could not be dumped, or breaks programs: see above"
cd "$out"
find . -type f ! -name SHA256SUMS | LC_ALL=C sort | xargs sha256sum >SHA256SUMS
cat SHA256SUMS
