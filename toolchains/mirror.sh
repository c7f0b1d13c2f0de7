#!/bin/sh
# SPDX-License-Identifier: MIT
# mirror.sh: prints the mirror of Debian that this machine's apt uses, or Debian's own where it uses none.
set -eu
mirror=$(sed -n 's/^URIs: *\([^ ]*\).*/\1/p; s/^deb \(\[[^]]*\] \)*\([^ ]*\) .*/\2/p' \
    /etc/apt/sources.list.d/*.sources /etc/apt/sources.list 2>/dev/null | grep -v security | head -n 1)
echo "${mirror:-http://deb.debian.org/debian}"
