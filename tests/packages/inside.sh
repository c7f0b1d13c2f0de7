#!/bin/sh
# SPDX-License-Identifier: MIT
# inside.sh FOLDER: in a system with the packages, as an ordinary user: runs the programs and builds the examples.
# FOLDER has urn.glb, lake.hdr, urn.png (what the build tree's viewer draws) and tests/packages/shaders.
set -eu
work=$1
cd "$work"
export HOME="$work" GALLIUM_DRIVER=softpipe LIBGL_ALWAYS_SOFTWARE=1 MESA_SHADER_CACHE_DISABLE=true
fail() { echo "FAILED: $1"; exit 1; }
[ "$(id -u)" != 0 ] || fail "run as root"

frankenshader --version
frankenshader check --profile vc4 basecolor.normal+ambient+sun1
frankenshader check --effects /usr/share/frankenshader/effects sun1+fog
frankenshader-viewer urn.glb -o drawn.png --size 160x120
cmp drawn.png urn.png || fail "the installed viewer draws another picture"
frankenshader-viewer urn.glb -o egl.png --size 160x120 --backend egl --snippets /usr/share/frankenshader/glsl
cmp egl.png urn.png || fail "EGL draws another picture"
frankenshader-bake lake.hdr --skybox-size 64 -o lake.sky
[ -s lake.sky ] || fail "no sky"
for program in frankenshader frankenshader-viewer frankenshader-bake; do
    gzip -t "/usr/share/man/man1/$program.1.gz"
    bash -n "/usr/share/bash-completion/completions/$program"
    [ -s "/usr/share/zsh/vendor-completions/_$program" ] && [ -s "/usr/share/fish/vendor_completions.d/$program.fish" ] ||
        fail "completions of $program"
done
offered=$(bash -c '. /usr/share/bash-completion/completions/frankenshader-viewer
    COMP_WORDS=(frankenshader-viewer --turn); COMP_CWORD=1; _frankenshader_viewer; echo ${COMPREPLY[*]}')
[ "$offered" = --turntable ] || fail "completion offers '$offered'"

build() { # NAME SOURCE [OPTION...]
    name=$1 source=$2
    shift 2
    cmake -G Ninja -S "$source" -B "$name" "$@" >"$name.log" 2>&1 && cmake --build "$name" >>"$name.log" 2>&1 ||
        { cat "$name.log"; fail "$name is not built"; }
}
examples=/usr/share/doc/frankenshader-doc/examples/embed
build engine "$examples/engine"
engine/engine engine.png
[ -s engine.png ] || fail "no picture by engine"
build static "$examples/generator_only" -DFrankenShader_STATIC=ON
build generator_only "$examples/generator_only"
static/generator_only static.png
generator_only/generator_only shared.png
cmp static.png shared.png || fail "static and shared libraries differ"
! ldd static/generator_only | grep franken || fail "the static example needs a shared library"
ldd generator_only/generator_only | grep -q 'libfranken_generator.so.0.1 ' || fail "the shared example does not"
build kiosk "$examples/kiosk"
build first "$examples/first"
code=0
first/first urn.glb 2>first.err || code=$?
[ "$code" = 1 ] && grep -qE 'libsdl2|start it on a desktop' first.err || fail "the first program without a window ends with $code"
build shaders shaders
[ "$(shaders/count)" = "2 programs" ] || fail "$(shaders/count) from the header"
[ "$(shaders/from_folder)" = "2 programs" ] || fail "$(shaders/from_folder) from the folder"
echo sun2 >>shaders/warm.txt
cmake --build shaders >/dev/null
[ "$(shaders/count)" = "3 programs" ] || fail "a longer manifest does not write the header anew"
echo '#include "franken/generator/compose.h"
int main() { return franken::compose(franken::Permutation{}).fragment.text.empty(); }' >text.cpp
# shellcheck disable=SC2046
g++ -std=c++20 text.cpp -o text $(pkg-config --cflags --libs frankenshader-generator)
./text
# shellcheck disable=SC2046
g++ -std=c++20 text.cpp -o text -static-libstdc++ $(pkg-config --cflags frankenshader-generator) -l:libfranken_generator.a -l:libfranken_base.a
./text
echo "programs run, examples built"
