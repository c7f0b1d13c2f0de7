#!/bin/bash
# SPDX-License-Identifier: MIT
# break.sh [NUMBER...]: shows that the tests of the platform notice a fault. Below each numbered test it breaks one line of the
# code, builds and runs the test, and expects it to be red. Without numbers: all of them, in some minutes. The checkout stays as
# it is: all of this happens in a copy, build/broken. Exits with 0 where all were red.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
copy=$root/build/broken
log=$copy/break.log
export GALLIUM_DRIVER=softpipe MESA_SHADER_CACHE_DISABLE=true

# number|what is held|program|its tests|file|text, once in the file|what takes its place
faults="\
1|the scanned-out picture equals the offscreen one|vm_picture_test|*turned90_8888|platform/src/kms/kms_surface.cpp|m_rotation = layout.rotation;|m_rotation = Rotation::None;
2|no flip is missed|vm_screen_test|*Pace.*every2|platform/src/kms/screen.cpp|(refreshes - 1) * period()|refreshes * period()
3|no screen, unplugged and plugged|vm_screen_test|Screen.SurvivesUnplugs*|platform/src/kms/kms_surface.cpp|        if (changed)|        if (false)
4|errors of commits|vm_lifecycle_test|Life/CommitError*|platform/src/kms/commit_error.cpp|case EACCES:|case EISDIR:
5|a bouncing press is one|vm_gpio_test|Gpio.AThousand*|platform/src/gpio/inputs.cpp|settleAt = now + options.press.settle;|settleAt = now;
6|touch against picture and sensor|vm_input_test|InputTest.ATouch*|platform/src/rotation.cpp|return {1 - sensor.y, sensor.x};|return {sensor.y, sensor.x};
7|flips that are not answered end it|vm_lifecycle_test|Harmed.Faults*|platform/src/kms/screen.cpp|if (m_resets > 0)|if (m_resets > 9)
8|a start that fails leaves nothing acquired|vm_lifecycle_test|Life/StartUp*CreateWindow|platform/src/kms/gbm_target.cpp|eglTerminate(m_display);|(void)m_display;"

# Files that are the same keep their times, so that they are not built again.
copy_checkout() {
  local name
  mkdir -p "$copy"
  git -C "$root" ls-files -z | while IFS= read -r -d '' name; do
    [[ -f $root/$name ]] || continue
    cmp -s "$root/$name" "$copy/$name" || install -D "$root/$name" "$copy/$name"
  done
  (cd "$copy" && cmake --preset dev --log-level=WARNING) >"$log" 2>&1 || { cat "$log"; exit 2; }
}

build() { cmake --build "$copy/build/dev" --target "$1" harmed_kiosk >"$log" 2>&1; }

# The test's exit code; 77 and 125 are those of guest.sh.
run() { GTEST_FILTER=$2 "$here/guest.sh" -t 600 "$copy/build/dev/bin/$1" >"$log" 2>&1; }

failed() { echo "$*"; all=1; }

break_one() {
  local number=$1 held=$2 program=$3 tests=$4 file=$copy/$5 text=$6 broken=$7 before code=0
  before=$(cat "$file"; echo .) before=${before%.}
  [[ ${before/"$text"/} != "$before" && ${before/"$text"/} != *"$text"* ]] || { failed "$number: '$text' is not once in $5"; return; }
  printf '%s' "${before/"$text"/"$broken"}" >"$file"
  if build "$program"; then run "$program" "$tests" || code=$?; else code=build; fi
  printf '%s' "$before" >"$file"
  case $code in
  1) echo "$number red, as it should be: $held ($program $tests; $5: $text -> $broken)"
     grep -m 1 'FAILED  \]' "$log" | sed 's/^/    /' ;;
  0) failed "$number GREEN: $held ($program $tests; $5: $text -> $broken)" ;;
  77) failed "$number skipped: $(tail -n 1 "$log")" ;;
  *) failed "$number could not be tried ($code): $(tail -n 1 "$log")" ;;
  esac
}

all=0
copy_checkout
while IFS='|' read -r number rest; do
  [[ $# == 0 || " $* " == *" $number "* ]] || continue
  IFS='|' read -r held program tests file text broken <<<"$rest"
  break_one "$number" "$held" "$program" "$tests" "$file" "$text" "$broken"
done <<<"$faults"
exit $all
