#!/bin/bash
# SPDX-License-Identifier: MIT
# measure.sh CAPTURES SEED > peers.tsv
#   CAPTURES  the folder that capture.mjs wrote
#   SEED      the seed page's program up to its number of suns: SEED1.vert, SEED1.frag, SEED4.vert, SEED4.frag
# The compilers are ../toolchain.sh's.
set -euo pipefail

if [[ $# -ne 2 ]]; then
  sed -n '3,6s/^# //p' "$0" >&2
  exit 2
fi
captures=$1
seed=$2
here=$(dirname "$(readlink -f "$0")")
stats=$("$here/../toolchain.sh")/bin/qpu-stats
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A browser hands the driver programs whose variables all start at zero; PlayCanvas relies on it. Mesa takes this as an option.
export glsl_zero_init=true

# resolve FILE STAGE SUNS: the text with its preprocessor lines carried out.
resolve() {
  glslangValidator -E -S "$2" "-DSUNS=$3" "$1" | grep -v '^[[:space:]]*$' > "$work/program.$2"
}

# The drivers print a stage again each time they compile it; the last line is the one of the draw.
figures() {
  awk '
    /SHADER_FRAGMENT shader:/ { match($0, /[0-9]+ inst/); fragment = substr($0, RSTART, RLENGTH) + 0
                                match($0, /[0-9]+ threads/); threads = substr($0, RSTART, RLENGTH) + 0 }
    /SHADER_VERTEX shader:/   { match($0, /[0-9]+ inst/); vertex = substr($0, RSTART, RLENGTH) + 0 }
    /^(does not compile|does not link|out of registers|no figures)/ { outcome = $0; sub(/:.*/, "", outcome) }
    END {
      if (!outcome && !(fragment && vertex)) outcome = "no figures"
      if (outcome) fragment = threads = vertex = "-"
      print fragment "\t" threads "\t" vertex "\t" (outcome ? outcome : "ok")
    }' "$1"
}

# measure ENGINE VERSION SUNS EXTENSIONS VERT FRAG: three rows, one a GPU.
measure() {
  resolve "$5" vert "$3"
  resolve "$6" frag "$3"
  for gpu in vc4 v3d42 v3d71; do
    "$stats" "$gpu" "$work/program.vert" "$work/program.frag" > "$work/lines" 2>&1 || true
    printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$1" "$2" "$3" "$4" "$gpu" "$(figures "$work/lines")"
  done
}

printf 'engine\tversion\tlights\textensions\tgpu\tfragment instructions\tfragment threads\tvertex instructions\toutcome\n'
for suns in 1 4; do
  measure seed - "$suns" none "$seed$suns.vert" "$seed$suns.frag"
  measure seed-optimised - "$suns" none "$seed$suns.vert" "$here/seed_optimised.frag"
done
tail -n +2 "$captures/captures.tsv" | while IFS=$'\t' read -r engine version suns extensions name _; do
  measure "$engine" "$version" "$suns" "$extensions" "$captures/$name.vert" "$captures/$name.frag"
done
