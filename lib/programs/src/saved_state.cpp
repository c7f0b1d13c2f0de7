// SPDX-License-Identifier: MIT
#include "franken/saved_state.h"

#include "franken/attribute_format.h"

#include <algorithm>
#include <string_view>

namespace franken {
namespace {

static_assert(kAttributeFormats.size() <= SavedState::kArrays);

// Names of OpenGL ES 3.0, which <GLES2/gl2.h> does not have.
constexpr GLenum kReadFramebuffer = 0x8CA8, kReadFramebufferBinding = 0x8CAA;
constexpr GLenum kPackBuffer = 0x88EB, kPackBufferBinding = 0x88ED;
constexpr GLenum kUnpackBuffer = 0x88EC, kUnpackBufferBinding = 0x88EF;
constexpr std::array<GLenum, 6> kPixelStore = {
    0x0D02, 0x0D03, 0x0D04, // GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS
    0x0CF2, 0x0CF3, 0x0CF4, // GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS
};

/// "OpenGL ES 3.1 Mesa", "3.3 (Compatibility Profile)": whether it is 3.0 at least.
bool isNewer(const Gl& gl) {
    const GLubyte* text = gl.GetString(GL_VERSION);
    const std::string_view version = text == nullptr ? "" : reinterpret_cast<const char*>(text);
    const std::size_t digit = version.find_first_of("0123456789");
    return digit != std::string_view::npos && version[digit] >= '3';
}

GLint integer(const Gl& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

SavedState::Array arrayOf(const Gl& gl, GLuint location) {
    SavedState::Array array;
    gl.GetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &array.enabled);
    gl.GetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &array.buffer);
    gl.GetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_SIZE, &array.size);
    gl.GetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_TYPE, &array.type);
    gl.GetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, &array.normalized);
    gl.GetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_STRIDE, &array.stride);
    gl.GetVertexAttribPointerv(location, GL_VERTEX_ATTRIB_ARRAY_POINTER, &array.pointer);
    return array;
}

void askObjects(const Gl& gl, SavedState& state) {
    state.program = integer(gl, GL_CURRENT_PROGRAM);
    state.framebuffer = integer(gl, GL_FRAMEBUFFER_BINDING);
    state.renderbuffer = integer(gl, GL_RENDERBUFFER_BINDING);
    state.arrayBuffer = integer(gl, GL_ARRAY_BUFFER_BINDING);
    state.elementBuffer = integer(gl, GL_ELEMENT_ARRAY_BUFFER_BINDING);
    state.activeTexture = integer(gl, GL_ACTIVE_TEXTURE);
    for (GLenum unit = 0; unit < SavedState::kUnits; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        state.textures[unit] = {integer(gl, GL_TEXTURE_BINDING_2D), integer(gl, GL_TEXTURE_BINDING_CUBE_MAP)};
    }
    gl.ActiveTexture(static_cast<GLenum>(state.activeTexture));
    for (GLuint location = 0; location < SavedState::kArrays; ++location)
        state.arrays[location] = arrayOf(gl, location);
}

SavedState::Newer newerOf(const Gl& gl) {
    SavedState::Newer newer{integer(gl, kReadFramebufferBinding), integer(gl, kPackBufferBinding),
                            integer(gl, kUnpackBufferBinding)};
    std::transform(kPixelStore.begin(), kPixelStore.end(), newer.pixelStore.begin(),
                   [&](GLenum name) { return integer(gl, name); });
    return newer;
}

void setTransfers(const Gl& gl, const SavedState::Newer& newer) {
    gl.BindBuffer(kPackBuffer, static_cast<GLuint>(newer.packBuffer));
    gl.BindBuffer(kUnpackBuffer, static_cast<GLuint>(newer.unpackBuffer));
    for (std::size_t i = 0; i < kPixelStore.size(); ++i)
        gl.PixelStorei(kPixelStore[i], newer.pixelStore[i]);
}

void restoreObjects(const Gl& gl, const SavedState& state) {
    for (GLuint location = 0; location < SavedState::kArrays; ++location) {
        const SavedState::Array& array = state.arrays[location];
        gl.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(array.buffer));
        gl.VertexAttribPointer(location, array.size, static_cast<GLenum>(array.type),
                               static_cast<GLboolean>(array.normalized), array.stride, array.pointer);
        array.enabled != 0 ? gl.EnableVertexAttribArray(location) : gl.DisableVertexAttribArray(location);
    }
    for (GLenum unit = 0; unit < SavedState::kUnits; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        gl.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(state.textures[unit][0]));
        gl.BindTexture(GL_TEXTURE_CUBE_MAP, static_cast<GLuint>(state.textures[unit][1]));
    }
    gl.ActiveTexture(static_cast<GLenum>(state.activeTexture));
    gl.UseProgram(static_cast<GLuint>(state.program));
    gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(state.framebuffer));
    gl.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(state.renderbuffer));
    gl.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(state.arrayBuffer));
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(state.elementBuffer));
}

} // namespace

SavedState SavedState::of(const Gl& gl) {
    SavedState state;
    for (std::size_t i = 0; i < kCapabilities.size(); ++i)
        state.capabilities[i] = gl.IsEnabled(kCapabilities[i]);
    askObjects(gl, state);
    state.depthFunction = integer(gl, GL_DEPTH_FUNC);
    state.culledFace = integer(gl, GL_CULL_FACE_MODE);
    state.frontFace = integer(gl, GL_FRONT_FACE);
    state.blendEquations = {integer(gl, GL_BLEND_EQUATION_RGB), integer(gl, GL_BLEND_EQUATION_ALPHA)};
    state.blendFactors = {integer(gl, GL_BLEND_SRC_RGB), integer(gl, GL_BLEND_DST_RGB),
                          integer(gl, GL_BLEND_SRC_ALPHA), integer(gl, GL_BLEND_DST_ALPHA)};
    gl.GetBooleanv(GL_COLOR_WRITEMASK, state.colorMask.data());
    gl.GetBooleanv(GL_DEPTH_WRITEMASK, &state.depthMask);
    gl.GetFloatv(GL_COLOR_CLEAR_VALUE, state.clearColor.data());
    gl.GetFloatv(GL_DEPTH_RANGE, state.depthRange.data());
    gl.GetFloatv(GL_DEPTH_CLEAR_VALUE, &state.clearDepth);
    gl.GetIntegerv(GL_VIEWPORT, state.viewport.data());
    gl.GetIntegerv(GL_SCISSOR_BOX, state.scissorBox.data());
    state.packAlignment = integer(gl, GL_PACK_ALIGNMENT);
    state.unpackAlignment = integer(gl, GL_UNPACK_ALIGNMENT);
    if (isNewer(gl))
        state.newer = newerOf(gl);
    return state;
}

void SavedState::takeOver(const Gl& gl) const {
    if (newer)
        setTransfers(gl, {});
}

void SavedState::restore(const Gl& gl) const {
    const auto name = [](GLint value) { return static_cast<GLenum>(value); };
    for (std::size_t i = 0; i < kCapabilities.size(); ++i)
        capabilities[i] != GL_FALSE ? gl.Enable(kCapabilities[i]) : gl.Disable(kCapabilities[i]);
    restoreObjects(gl, *this);
    gl.DepthFunc(name(depthFunction));
    gl.CullFace(name(culledFace));
    gl.FrontFace(name(frontFace));
    gl.BlendEquationSeparate(name(blendEquations[0]), name(blendEquations[1]));
    gl.BlendFuncSeparate(name(blendFactors[0]), name(blendFactors[1]), name(blendFactors[2]),
                         name(blendFactors[3]));
    gl.ColorMask(colorMask[0], colorMask[1], colorMask[2], colorMask[3]);
    gl.DepthMask(depthMask);
    gl.ClearColor(clearColor[0], clearColor[1], clearColor[2], clearColor[3]);
    gl.DepthRangef(depthRange[0], depthRange[1]);
    gl.ClearDepthf(clearDepth);
    gl.Viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    gl.Scissor(scissorBox[0], scissorBox[1], scissorBox[2], scissorBox[3]);
    gl.PixelStorei(GL_PACK_ALIGNMENT, packAlignment);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, unpackAlignment);
    if (newer) {
        gl.BindFramebuffer(kReadFramebuffer, static_cast<GLuint>(newer->readFramebuffer));
        setTransfers(gl, *newer);
    }
}

} // namespace franken
