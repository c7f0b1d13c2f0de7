#!/bin/sh
# SPDX-License-Identifier: MIT
# hardening_test.sh PACKAGES_DIR: reads off the programs and libraries of the packages that they are position
# independent, that nothing of what the loader fills in stays writable (full RELRO), that the stack is guarded and not
# executable, and that the C library's checked functions are called (FORTIFY).
set -eu
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
for package in "$1"/*.deb; do dpkg-deb -x "$package" "$work"; done
failed=0 count=0
hold() { # FILE WHAT COMMAND...
    file=$1 what=$2
    shift 2
    "$@" >/dev/null || { echo "FAILED: $(basename "$file"): $what"; failed=1; }
}
has() { printf '%s\n' "$1" | grep -qE "$2"; }
fortified=0 guarded=0
for file in "$work"/usr/bin/* $(find "$work/usr/lib" -type f -name 'libfranken_*.so.*'); do
    count=$((count + 1))
    header=$(readelf -hW "$file") segments=$(readelf -lW "$file") dynamic=$(readelf -dW "$file")
    symbols=$(readelf --dyn-syms -W "$file")
    hold "$file" "position independent" has "$header" 'Type: +DYN'
    hold "$file" "RELRO" has "$segments" 'GNU_RELRO'
    hold "$file" "bound at once" has "$dynamic" 'BIND_NOW|FLAGS.*NOW'
    hold "$file" "stack not executable" has "$segments" 'GNU_STACK +[x0-9a-f ]+ RW '
    hold "$file" "no path to libraries" sh -c '! printf "%s\n" "$1" | grep -qE "RPATH|RUNPATH"' - "$dynamic"
    has "$symbols" '__stack_chk_fail' && guarded=$((guarded + 1))
    has "$symbols" '_chk@' && fortified=$((fortified + 1))
done
# What has no array on its stack has no guard, and what copies no memory calls no checked function.
echo "$count files: $guarded with a guarded stack, $fortified with checked functions"
[ "$count" -ge 10 ] || { echo "FAILED: only $count files"; failed=1; }
[ "$guarded" = "$count" ] || { echo "FAILED: a stack is not guarded"; failed=1; }
[ "$fortified" -ge 1 ] || { echo "FAILED: checked functions are missing"; failed=1; }
exit $failed
