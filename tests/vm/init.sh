#!/bin/sh
# SPDX-License-Identifier: MIT
# The first process of the guest. The host's root is its root, read-only; what it writes goes to memory (/run, /dev/shm), or to
# the one folder of the host that guest.sh named, mounted at /run/host. Runs the command in /run/host/command and leaves its
# exit code in /run/host/code: the kernel's own says nothing.
export PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/run LC_ALL=C XDG_RUNTIME_DIR=/run
mount -n -t proc proc /proc
mount -n -t sysfs sysfs /sys
mount -n -t devtmpfs dev /dev
# A kernel with virtual consoles opens none for its first process: the first files that a daemon opens would be taken for them.
exec </dev/null >/dev/null 2>&1
mkdir -p /dev/shm /dev/pts
mount -n -t tmpfs shm /dev/shm
mount -n -t devpts devpts /dev/pts
mount -n -t tmpfs run /run
mount -n -t configfs configfs /sys/kernel/config
host=$(sed -n 's/.*guest\.host=\([^ ]*\).*/\1/p' /proc/cmdline)
mkdir /run/host /run/tmp
mount -n -t hostfs none /run/host -o "$host"
export TMPDIR=/run/tmp

# It makes the device nodes' entries in /run/udev that libinput asks for, as on any Debian.
if [ -x /lib/systemd/systemd-udevd ]; then
    /lib/systemd/systemd-udevd --daemon >/run/host/udevd 2>&1
    udevadm trigger >/dev/null 2>&1
    udevadm settle --timeout=20 >/dev/null 2>&1
fi
cd /run/tmp || exit 1
. /run/host/environment
setsid sh /run/host/command >/run/host/output 2>&1 </dev/null
echo $? >/run/host/code.part
mv /run/host/code.part /run/host/code
sync
exec busybox poweroff -f
