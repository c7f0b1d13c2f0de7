#!/bin/sh
# SPDX-License-Identifier: MIT
# install.sh: makes a kiosk of this machine. As root, on Raspberry Pi OS Lite or Debian, after the package is installed.
# It writes its files over those of an earlier run, but for the configuration, which stays as it is.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd -P)
root=${DESTDIR:-}
[ -n "$root" ] || [ "$(id -u)" = 0 ] || { echo "install.sh: only root may do this: sudo $0" >&2; exit 1; }

put() { install -D -m 644 "$here/$1" "$root/etc/$2"; }
put kiosk.service systemd/system/kiosk.service
put 60-frankenshader-kiosk.rules udev/rules.d/60-frankenshader-kiosk.rules
put sysusers.conf sysusers.d/frankenshader-kiosk.conf
put tmpfiles.conf tmpfiles.d/frankenshader-kiosk.conf
put journald.conf systemd/journald.conf.d/frankenshader-kiosk.conf
put watchdog.conf systemd/system.conf.d/watchdog.conf
config=$root/etc/frankenshader-kiosk/kiosk.toml
if [ ! -e "$config" ]; then
    install -D -m 644 /dev/null "$config"
    cat >"$config" <<'TOML'
# `frankenshader-kiosk settings` lists everything that can be set; `frankenshader-kiosk check FILE` says what is wrong.
[content]
folder = "/data/models"

[files]
state = "/data/state"
metrics = "/run/frankenshader-kiosk/kiosk.prom"
TOML
fi
[ -z "$root" ] || exit 0

systemd-sysusers
[ -z "${SUDO_USER:-}" ] || usermod -aG kiosk "$SUDO_USER" # May copy models, once logged in again.
mkdir -p /data
systemd-tmpfiles --create frankenshader-kiosk.conf
udevadm control --reload
udevadm trigger
systemctl daemon-reexec # Reads the units, and starts the hardware watchdog.
systemctl restart systemd-journald
systemctl set-default multi-user.target
systemctl enable kiosk.service
echo "Log in again, copy models to /data/models, then: sudo -u kiosk frankenshader-kiosk doctor --config $config"
