#!/bin/sh
# SPDX-License-Identifier: MIT
# scripts_test.sh SOURCE_DIR WORK_DIR: what the scripts do where little is as they would like it: CDPATH is exported, they
# are run through a link, packages are missing and there is no sudo, or one that asks for a password. Nothing is
# installed or built: the programs that would do it are replaced by ones that only say so.
set -u
source=$1 work=$2/$$ # A run has its own.
mkdir -p "$work/bin" "$work/elsewhere"
failed=0
unset FRANKEN_WERROR # CI sets it, and would decide what the scripts are asked here.

replace() { printf '#!/bin/sh\n%s\n' "$2" >"$work/bin/$1" && chmod +x "$work/bin/$1"; }
expect() { # WHAT TEXT FILE
    grep -q -- "$2" "$3" || { echo "FAILED: $1: '$2' is not in:"; cat "$3"; failed=1; }
}

PATH=$work/bin:$PATH
export PATH
replace dpkg-query 'echo not-installed'
replace apt-get 'echo "apt-get $*" >>"'"$work"'/apt"'
replace id 'echo 1000'
replace sudo 'exit 1'
"$source/toolchains/install-packages.sh" build </dev/null >"$work/out" 2>&1 && failed=1
expect "a sudo that asks for a password" "apt-get install --no-install-recommends .*cmake" "$work/out"
[ -e "$work/apt" ] && { echo "FAILED: something was installed"; failed=1; }
replace sudo 'if [ "$1" = -n ]; then exit 0; fi; exec "$@"'
"$source/toolchains/install-packages.sh" build </dev/null >"$work/out" 2>&1 || failed=1
expect "a sudo that asks for nothing" "install -y .*cmake" "$work/apt"

replace dpkg-query 'echo installed'
replace cmake 'echo "cmake $PWD $*" >>"'"$work"'/cmake"; case $1 in --build) for i in 1 2 3 4 5 6 7 8 9 10; do echo "[$i/10] Building"; done; echo "note: from the compiler";; esac'
replace ctest 'while [ $# -gt 1 ]; do [ "$1" = --output-junit ] && printf "<testsuite tests=\"3\" failures=\"0\" skipped=\"1\" disabled=\"0\">\na.cpp:1: Skipped\nneeds a thing\n" >"$2"; shift; done'
for name in tests/run.sh examples/run.sh; do
    mkdir -p "$work/copy/$(dirname "$name")"
    cp "$source/$name" "$work/copy/$name"
done
cp -r "$source/toolchains" "$work/copy"
mkdir -p "$work/copy/build/dev"
ln -s "$work/copy/tests/run.sh" "$work/elsewhere/tests"
(cd "$work/copy" && CDPATH=/usr:/tmp:. && export CDPATH && sh tests/run.sh dev >"$work/out" 2>&1) || failed=1
expect "CDPATH" "cmake $work/copy --preset dev -DFRANKEN_WERROR=OFF" "$work/cmake"
expect "progress" "Building dev" "$work/out"
expect "progress" "5 of 10" "$work/out"
expect "the compiler's words" "note: from the compiler" "$work/out"
expect "reasons of skips" "1 needs a thing" "$work/out"
expect "the count" "2 passed, 0 failed, 1 skipped" "$work/out"
rm "$work/cmake"
(cd "$work/elsewhere" && FRANKEN_WERROR=ON ./tests dev >"$work/out" 2>&1) || failed=1
expect "a link" "cmake $work/copy --preset dev -DFRANKEN_WERROR=ON" "$work/cmake"
replace cmake 'case $1 in --build) echo "FAILED: a.o"; echo "a.cpp:1: error: no"; exit 1;; esac'
(cd "$work/copy" && sh tests/run.sh dev >"$work/out" 2>&1) && { echo "FAILED: a broken build is a success"; failed=1; }
expect "what the compiler says" "a.cpp:1: error: no" "$work/out"
[ $failed = 0 ] && rm -rf "$work"
exit $failed
