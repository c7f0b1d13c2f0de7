#!/bin/sh
# SPDX-License-Identifier: MIT
# release_test.sh SOURCE_DIR WORK_DIR: what release.sh commits and tags, and what it refuses, in a small repository.
set -eu
source=$1 work=$2/$$
command -v git >/dev/null || { echo "skipped: git is missing: apt-get install git"; exit 77; }
rm -rf "$work"
mkdir -p "$work/toolchains"
cp "$source/CMakeLists.txt" "$work"
cp "$source/toolchains/release.sh" "$work/toolchains"
cd "$work"
export GIT_CONFIG_GLOBAL=/dev/null GIT_AUTHOR_NAME=A GIT_AUTHOR_EMAIL=a@b.c GIT_COMMITTER_NAME=A GIT_COMMITTER_EMAIL=a@b.c
printf '# Changelog\n\nIntroduction.\n\n## Unreleased\n\n- A thing.\n' >CHANGELOG.md
git init -q
git add .
git commit -q -m "All"
failed=0
refused() { # WHAT TEXT ARGUMENT...
    what=$1 text=$2
    shift 2
    before=$(git rev-parse HEAD)
    if toolchains/release.sh --prepare "$@" >"$work.out" 2>&1; then echo "FAILED: $what was taken"; failed=1; fi
    grep -q -- "$text" "$work.out" || { echo "FAILED: $what: '$text' is not in:"; cat "$work.out"; failed=1; }
    rm "$work.out"
    [ "$(git rev-parse HEAD)" = "$before" ] && git diff --quiet || { echo "FAILED: $what changed something"; failed=1; }
}
expect() { # WHAT COMMAND...
    what=$1
    shift
    "$@" >/dev/null || { echo "FAILED: $what"; failed=1; }
}

refused "no version" "usage" ""
refused "a word as version" "usage" 1.2
refused "an older version" "comes before" 0.0.9
touch stray
refused "an untidy checkout" "not committed" 9.8.7
rm stray

toolchains/release.sh --prepare 9.8.7 >/dev/null
expect "the version in CMakeLists.txt" grep -q '^project(FrankenShader VERSION 9.8.7 LANGUAGES' CMakeLists.txt
expect "the heading in CHANGELOG.md" grep -qE '^## 9\.8\.7, [0-9]{4}-[0-9]{2}-[0-9]{2}$' CHANGELOG.md
expect "the tag" git rev-parse --verify 'refs/tags/v9.8.7^{commit}'
expect "nothing else was changed" sh -c '[ "$(git show --format= --name-only | sort | tr "\n" " ")" = "CHANGELOG.md CMakeLists.txt " ]'
refused "the same version again" "is there already" 9.8.7
refused "a release of nothing" "has nothing" 9.8.8
cd /
[ $failed = 0 ] && rm -rf "$work"
exit $failed
