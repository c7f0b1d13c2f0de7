#!/bin/sh
# SPDX-License-Identifier: MIT
# examples/web/serve.sh [PORT]: from nothing to the playground in a browser of this machine: installs what is missing,
# builds, and serves it on the loopback interface until it is stopped.
set -eu
[ $# -le 1 ] || { echo "usage: examples/web/serve.sh [PORT]" >&2; exit 2; }
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.." && pwd -P)
"$root/toolchains/install-packages.sh" build
"$root/toolchains/install-packages.sh" web
cd "$root"
echo "Building what writes the model and the sky"
cmake --preset release >/dev/null
cmake --build --preset release --target make_model
echo "Building the page, which takes a minute or two"
"$root/examples/web/build.sh" "$root/out/web" "$root/build/release/bin"
exec python3 "$root/examples/web/serve.py" "$root/out/web" "${1:-8080}"
