#!/bin/sh
# SPDX-License-Identifier: MIT
# links.sh FOLDER: holds that each file that an installed page of FOLDER leads to is there, and that there are pages.
set -eu
cd "$1"
links=$(grep -roE --include='*.md' '\]\([^)#:]+[)#]' . | sed -E 's/:\]\(/ /; s/[)#]$//')
failed=0
while read -r page link; do
    [ -e "$(dirname "$page")/$link" ] || { echo "FAILED: $page leads to $link, which is not there"; failed=1; }
done <<END
$links
END
count=$(printf '%s\n' "$links" | wc -l)
echo "$count links"
[ "$count" -ge 20 ] || { echo "FAILED: too few links"; failed=1; }
exit $failed
