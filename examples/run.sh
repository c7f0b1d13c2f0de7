#!/bin/sh
# SPDX-License-Identifier: MIT
# examples/run.sh [MODEL.gltf|MODEL.glb]: from nothing to a picture, on a machine without a GPU. Installs
# what is missing, builds, prints the shader that this library is named after, and renders a model of our
# own under a sky of our own, and one by others (or MODEL), all of it: not as its file's camera cuts it off. Exit
# codes: those of the viewer.
set -eu
[ $# -le 1 ] || { echo "usage: examples/run.sh [MODEL.gltf|MODEL.glb]" >&2; exit 2; }
[ $# = 0 ] || [ -f "$1" ] || { echo "examples/run.sh: $1: no such file" >&2; exit 3; }
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
bin=$root/build/release/bin
out=$root/out
model=$(realpath -m -- "${1:-/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb}")

"$root/toolchains/install-packages.sh" build
cd "$root"
"$root/toolchains/build.sh" release

echo "The FrankenShader: normal map, ambient colour, one sun"
echo
"$bin/frankenshader" dump normal.basecolor+ambient+sun1+seed+decode-none+linear

mkdir -p "$out"
[ -f "$out/model.glb" ] || "$bin/make_model" "$out/model.glb"
[ -f "$out/lake.hdr" ] || "$bin/make_model" "$out/lake.hdr"
[ "$out/lake.sky" -nt "$bin/bake" ] || "$bin/bake" "$out/lake.hdr" --sun --skybox-size 2048 -o "$out/lake.sky"
"$bin/viewer" "$out/model.glb" --skybox "$out/lake.sky" --tone-map neutral --energy -o "$out/model.png" --size 800x600 --supersample
"$bin/viewer" "$model" --frame -o "$out/$(basename "${model%.*}").png" --size 800x600 --supersample

echo
echo "Pictures:"
echo "  $out/model.png"
echo "  $out/$(basename "${model%.*}").png"
