# SPDX-License-Identifier: MIT
# cmake -DGLSL_DIR=... -DOUT=... -P embed.cmake: writes a C++ file that holds all snippets.
file(GLOB_RECURSE files RELATIVE ${GLSL_DIR} ${GLSL_DIR}/*.glsl)
list(SORT files)
set(rows "")
foreach(file IN LISTS files)
    file(READ ${GLSL_DIR}/${file} text)
    string(REGEX REPLACE "\\.glsl$" "" name ${file})
    string(APPEND rows "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUT} "// Generated from generator/glsl; edit the snippets instead.
#include \"snippet.h\"

namespace franken {
namespace {
constexpr SnippetFile kFiles[] = {
${rows}};
} // namespace
std::span<const SnippetFile> embeddedSnippets() { return kFiles; }
} // namespace franken
")
