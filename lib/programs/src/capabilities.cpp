// SPDX-License-Identifier: MIT
#include "franken/capabilities.h"

#include "franken/generator/pack.h"
#include "franken/saved_state.h"
#include "precision_probe.h"

#include <algorithm>
#include <string_view>

namespace franken {
namespace {

std::string_view textOf(const Gl& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text == nullptr ? std::string_view() : reinterpret_cast<const char*>(text);
}

bool contains(std::string_view list, std::string_view word) {
    for (std::size_t end = 0; !list.empty(); list.remove_prefix(end)) {
        end = std::min(list.find(' '), list.size());
        if (list.substr(0, end) == word)
            return true;
        end = std::min(end + 1, list.size());
    }
    return false;
}

/// At least what OpenGL ES 2.0 promises.
int limitOf(const Gl& gl, GLenum name, int least) {
    GLint limit = 0;
    gl.GetIntegerv(name, &limit);
    return std::max<int>(limit, least);
}

float mostAnisotropy(const Gl& gl, std::string_view extensions) {
    constexpr GLenum kMaxTextureMaxAnisotropy = 0x84FF;
    GLfloat most = 1;
    if (contains(extensions, "GL_EXT_texture_filter_anisotropic"))
        gl.GetFloatv(kMaxTextureMaxAnisotropy, &most);
    return std::max(most, 1.0f);
}

/// What a vertex shader declares beside its palette: 32 vectors do for all but a few programs with effects or
/// many lights, which fall down the ladder to vertices that the CPU moves.
std::optional<Joints> roomiest(int uniformVectors) {
    constexpr int kBeside = 32, kRows = 3;
    std::optional<Joints> found;
    for (const Joints joints : {Joints::UpTo32, Joints::UpTo64, Joints::UpTo256})
        if (kRows * static_cast<int>(roomFor(joints)) + kBeside <= uniformVectors)
            found = joints;
    return found;
}

} // namespace

Capabilities Capabilities::query(const Gl& gl) {
    const KeptState kept(gl);
    const std::string_view version = textOf(gl, GL_VERSION);
    const std::string_view renderer = textOf(gl, GL_RENDERER);
    const std::string_view extensions = textOf(gl, GL_EXTENSIONS);
    // Desktop GL and GLES3 have in their core what GLES2 has as extensions.
    const bool core = !version.starts_with("OpenGL ES 2");
    return {.maxTextureSize = limitOf(gl, GL_MAX_TEXTURE_SIZE, 64),
            .maxCubeSize = limitOf(gl, GL_MAX_CUBE_MAP_TEXTURE_SIZE, 16),
            .anyTextureSize = core || contains(extensions, "GL_OES_texture_npot"),
            .wideIndices = core || contains(extensions, "GL_OES_element_index_uint"),
            .parallelCompile = contains(extensions, "GL_KHR_parallel_shader_compile"),
            .maxAnisotropy = mostAnisotropy(gl, extensions),
            .compilesForStaleTextures = renderer.starts_with("VC4") || renderer.starts_with("V3D"),
            .precision = measuredPrecision(gl, "highp"),
            .joints = roomiest(limitOf(gl, GL_MAX_VERTEX_UNIFORM_VECTORS, 128))};
}

} // namespace franken
