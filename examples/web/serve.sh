#!/bin/sh
# SPDX-License-Identifier: MIT
# examples/web/serve.sh [PORT]: from nothing to the playground in a browser of this machine: installs what is missing,
# builds, and serves it on the loopback interface until it is stopped.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.." && pwd -P)
port=${1:-8080}
"$root/toolchains/install-packages.sh" build
"$root/toolchains/install-packages.sh" web
cd "$root"
cmake --preset release >/dev/null
cmake --build --preset release --target make_model
"$root/examples/web/build.sh" "$root/out/web" "$root/build/release/bin"
echo "The playground: http://127.0.0.1:$port/"
exec python3 -m http.server --bind 127.0.0.1 --directory "$root/out/web" "$port" >/dev/null 2>&1
