#!/bin/bash
# SPDX-License-Identifier: MIT
# guest.sh [-r] [-t SECONDS] [-m MODE] COMMAND [ARGUMENT...]: boots a user-mode kernel with a screen (vkms), buttons (gpio-sim) and
# input devices (uinput), runs the command in it, prints what it printed and exits with its code.
#   -r          in real time. Without it the guest's clock moves only when the guest is idle: waiting takes no time, and each
#               run sees the same times whatever the machine's load.
#   -t SECONDS  ends it after so much real time (570: just before CTest does)
#   -m MODE     the screen's mode, as the kernel's video= has it (160x120@60, the smallest: in place of a smaller one, the
#               kernel's list has 1024x768, which has 41 times as many pixels, and takes softpipe minutes)
# Exits with 77 where there can be no guest, and says why; with 125 where the guest died. The folder of the host that the
# guest may write is in GUEST_FOLDER of the command's environment; what is left in it goes to $GUEST_KEEP, if that is set.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
time=time-travel=inf-cpu seconds=570 mode=160x120@60
while getopts rt:m: option; do
  case $option in
  r) time= ;;
  t) seconds=$OPTARG ;;
  m) mode=$OPTARG ;;
  *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))

skip() { echo "guest.sh: skipped: $*" >&2; exit 77; }
[[ $(id -u) == 0 ]] || skip "the guest's root has to be root here: mounting the host's files needs it"
command -v busybox >/dev/null || skip "busybox is not installed"
kernel=$("$here/kernel.sh")

folder=$(mktemp -d "${TMPDIR:-/var/tmp}/frankenshader-guest.XXXXXX")
trap 'rm -rf "$folder"' EXIT
printf 'cd %q; ' "$PWD" >"$folder/command"
printf '%q ' "$@" >>"$folder/command"
{
  env | grep -E '^(GALLIUM_DRIVER|LIBGL_ALWAYS_SOFTWARE|MESA_[A-Z_]*|GTEST_[A-Z_]*|FRANKEN_[A-Z_]*)=' | sed 's/^/export /' || true
  echo "export GUEST_FOLDER=/run/host"
} >"$folder/environment"

# Memory that is a file in /dev/shm is the fastest that the kernel knows. random.trust_cpu: Mesa would wait for random numbers.
TMPDIR=/dev/shm timeout -k 5 "$seconds" "$kernel" mem=768M root=/dev/root rootfstype=hostfs rootflags=/ ro quiet loglevel=4 \
  panic=-1 random.trust_cpu=on uml_dir="$folder" umid=guest con=null con0=null,fd:1 "video=Virtual-1:$mode" $time \
  init="$here/init.sh" guest.host="$folder" </dev/null >"$folder/console" 2>&1 || true
[[ -f $folder/output ]] && cat "$folder/output"
if [[ -n ${GUEST_KEEP:-} ]]; then
  mkdir -p "$GUEST_KEEP"
  find "$folder" -maxdepth 1 -type f \( -name '*.ppm' -o -name '*.png' -o -name '*.txt' \) -exec cp {} "$GUEST_KEEP" \;
fi
if [[ ! -f $folder/code ]]; then
  echo "guest.sh: the guest died, or took more than $seconds s. Its console ends with:" >&2
  tail -20 "$folder/console" >&2
  exit 125
fi
exit "$(cat "$folder/code")"
