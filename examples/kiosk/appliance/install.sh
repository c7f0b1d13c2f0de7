#!/bin/sh
# SPDX-License-Identifier: MIT
# install.sh: makes a kiosk of this machine. As root, on Raspberry Pi OS Lite or Debian, after the package is installed.
# Nothing that is there already under these names is overwritten but the units and rules themselves.
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
# `kiosk settings` lists everything that can be set; `kiosk check FILE` says what is wrong.
[content]
folder = "/data/models"

[files]
state = "/data/state"
metrics = "/run/frankenshader-kiosk/kiosk.prom"
TOML
fi
[ -z "$root" ] || exit 0

systemd-sysusers
mkdir -p /data
systemd-tmpfiles --create frankenshader-kiosk.conf
udevadm control --reload
udevadm trigger
systemctl daemon-reload
systemctl restart systemd-journald
systemctl set-default multi-user.target
systemctl enable kiosk.service
echo "Copy models to /data/models, then: sudo systemctl start kiosk; frankenshader-kiosk doctor --config $config"
