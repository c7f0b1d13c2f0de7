#!/bin/bash
# SPDX-License-Identifier: MIT
# build.sh VERSION WORK PREFIX: Mesa with nothing but its vc4 and v3d drivers and their no-op DRM shims, from Debian 13's
# source package; on Debian 12 or later. Exits with 77 where the machine lacks something, and says what.
# Unoptimised: the counts are the same, and the build takes half the time.
set -euo pipefail
version=$1 work=$2 prefix=$3
here=$(dirname -- "$(readlink -f -- "$0")")
declare -A digests=([25.0.7]=592272df3cf01e85e7db300c449df5061092574d099da275d19e97ef0510f8a6)
packages="dpkg-dev gcc g++ pkg-config ninja-build bison flex libdrm-dev libexpat1-dev zlib1g-dev libelf-dev python3-venv
  xz-utils patch"

skip() {
  echo "build.sh: skipped: $*" >&2
  exit 77
}

# Nothing is installed from within the tests: tests/run.sh does it before.
check_packages() {
  local missing=() package
  for package in $packages; do
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  [[ ${#missing[@]} == 0 ]] || skip "these packages are missing: ${missing[*]} (toolchains/install-packages.sh test)"
}

# Through a source list of our own: the machine's is left as it is. The address is the one it has for Debian.
download() {
  local uri
  uri=$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' | head -n 1)
  [[ -n $uri ]] || skip "apt knows no Debian to fetch Mesa's source from (run apt-get update)"
  mkdir -p apt/lists/partial apt/cache/archives/partial
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $uri trixie main" > apt/sources.list
  local options=(-qq -o "Dir::Etc::SourceList=$work/apt/sources.list" -o Dir::Etc::SourceParts=-
    -o "Dir::State::Lists=$work/apt/lists" -o "Dir::Cache=$work/apt/cache" -o Debug::NoLocking=1 -o APT::Sandbox::User=root)
  apt-get "${options[@]}" update || skip "Debian cannot be reached"
  apt-get "${options[@]}" source --download-only mesa/trixie || skip "Mesa's source cannot be fetched"
  [[ -f mesa_$version.orig.tar.xz ]] ||
    skip "Debian's archive has $(echo mesa_*.orig.tar.*) now, and the counts are those of Mesa $version"
  echo "${digests[$version]}  mesa_$version.orig.tar.xz" | sha256sum --check --quiet ||
    skip "Mesa's source is not the one that the counts are of"
}

command -v apt-get >/dev/null || skip "this is no Debian"
cd "$work"
check_packages
download
/usr/bin/python3 -m venv venv
venv/bin/pip -q --retries 1 --timeout 10 install meson==1.6.1 mako==1.4.3 pyyaml==6.0.3 packaging==26.3 || skip "meson and mako cannot be fetched"
tar xf "mesa_$version.orig.tar.xz"
patch -d "mesa-$version" -p1 < "$here/shims.patch"
export PATH=$work/venv/bin:/usr/bin:/bin
meson setup build "mesa-$version" --prefix="$prefix" --libdir=lib --buildtype=plain -Dc_args=-w -Dcpp_args=-w \
  -Db_ndebug=true -Dtools=drm-shim -Dgallium-drivers=vc4,v3d -Dvulkan-drivers= -Dplatforms= -Dglx=disabled -Dglvnd=disabled \
  -Degl=enabled -Dgbm=enabled -Dopengl=false -Dgles1=disabled -Dgles2=enabled -Dllvm=disabled -Dshader-cache=enabled \
  -Dzstd=disabled -Dvalgrind=disabled -Dlibunwind=disabled -Dlmsensors=disabled -Dvideo-codecs= -Dbuild-tests=false \
  -Dgallium-vdpau=disabled -Dgallium-va=disabled -Dgallium-xa=disabled
nice ninja -C build -j"$(nproc)" install
find "$prefix" -name '*.so*' -type f -exec strip --strip-unneeded {} +
