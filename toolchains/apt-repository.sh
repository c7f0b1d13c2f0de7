#!/bin/sh
# SPDX-License-Identifier: MIT
# apt-repository.sh DIR KEY: makes the packages of build/packages an apt repository in DIR (a flat one, of this release and
# architecture, for any web server), signed with a key of yours: `gpg --quick-generate-key NAME`. Prints what a machine
# that uses it needs. Needs the packages apt-utils and gpg.
set -eu
[ $# = 2 ] || { echo "usage: apt-repository.sh DIR KEY" >&2; exit 2; }
root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
dir=$1 key=$2
for program in apt-ftparchive gpg; do
    command -v "$program" >/dev/null || { echo "apt-repository.sh: $program is missing: apt-get install apt-utils gpg" >&2; exit 4; }
done
ls "$root"/build/packages/*.deb >/dev/null 2>&1 || { echo "apt-repository.sh: no packages: toolchains/packages.sh makes them" >&2; exit 3; }
mkdir -p "$dir"
cp -- "$root"/build/packages/*.deb "$dir"
cd "$dir"
rm -f Release Release.gpg InRelease
apt-ftparchive packages . >Packages
gzip -9nk -f Packages
apt-ftparchive -o APT::FTPArchive::Release::Origin=FrankenShader release . >Release.new
mv Release.new Release
gpg --batch --yes --local-user "$key" --clearsign --output InRelease Release
gpg --batch --yes --export "$key" >frankenshader.gpg
echo "/etc/apt/sources.list.d/frankenshader.list, with frankenshader.gpg copied to /usr/share/keyrings:"
echo "deb [signed-by=/usr/share/keyrings/frankenshader.gpg] https://YOUR.SERVER/frankenshader ./"
