// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <GLES2/gl2.h>

#include <functional>

/// All 142 functions of OpenGL ES 2.0 (Khronos, "OpenGL ES Common Profile Specification", version 2.0.25),
/// without the prefix "gl". FRANKEN_GL_FUNCTIONS(X) expands X(name) for each.
// clang-format off
#define FRANKEN_GL_FUNCTIONS(X)                                                                              \
    X(ActiveTexture) X(AttachShader) X(BindAttribLocation) X(BindBuffer) X(BindFramebuffer)                  \
    X(BindRenderbuffer) X(BindTexture) X(BlendColor) X(BlendEquation) X(BlendEquationSeparate) X(BlendFunc)  \
    X(BlendFuncSeparate) X(BufferData) X(BufferSubData) X(CheckFramebufferStatus) X(Clear) X(ClearColor)     \
    X(ClearDepthf) X(ClearStencil) X(ColorMask) X(CompileShader) X(CompressedTexImage2D)                     \
    X(CompressedTexSubImage2D) X(CopyTexImage2D) X(CopyTexSubImage2D) X(CreateProgram) X(CreateShader)       \
    X(CullFace) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram) X(DeleteRenderbuffers)               \
    X(DeleteShader) X(DeleteTextures) X(DepthFunc) X(DepthMask) X(DepthRangef) X(DetachShader) X(Disable)    \
    X(DisableVertexAttribArray) X(DrawArrays) X(DrawElements) X(Enable) X(EnableVertexAttribArray) X(Finish) \
    X(Flush) X(FramebufferRenderbuffer) X(FramebufferTexture2D) X(FrontFace) X(GenBuffers)                   \
    X(GenFramebuffers) X(GenRenderbuffers) X(GenTextures) X(GenerateMipmap) X(GetActiveAttrib)               \
    X(GetActiveUniform) X(GetAttachedShaders) X(GetAttribLocation) X(GetBooleanv) X(GetBufferParameteriv)    \
    X(GetError) X(GetFloatv) X(GetFramebufferAttachmentParameteriv) X(GetIntegerv) X(GetProgramInfoLog)      \
    X(GetProgramiv) X(GetRenderbufferParameteriv) X(GetShaderInfoLog) X(GetShaderPrecisionFormat)            \
    X(GetShaderSource) X(GetShaderiv) X(GetString) X(GetTexParameterfv) X(GetTexParameteriv)                 \
    X(GetUniformLocation) X(GetUniformfv) X(GetUniformiv) X(GetVertexAttribPointerv) X(GetVertexAttribfv)    \
    X(GetVertexAttribiv) X(Hint) X(IsBuffer) X(IsEnabled) X(IsFramebuffer) X(IsProgram) X(IsRenderbuffer)    \
    X(IsShader) X(IsTexture) X(LineWidth) X(LinkProgram) X(PixelStorei) X(PolygonOffset) X(ReadPixels)       \
    X(ReleaseShaderCompiler) X(RenderbufferStorage) X(SampleCoverage) X(Scissor) X(ShaderBinary)             \
    X(ShaderSource) X(StencilFunc) X(StencilFuncSeparate) X(StencilMask) X(StencilMaskSeparate) X(StencilOp) \
    X(StencilOpSeparate) X(TexImage2D) X(TexParameterf) X(TexParameterfv) X(TexParameteri) X(TexParameteriv) \
    X(TexSubImage2D) X(Uniform1f) X(Uniform1fv) X(Uniform1i) X(Uniform1iv) X(Uniform2f) X(Uniform2fv)        \
    X(Uniform2i) X(Uniform2iv) X(Uniform3f) X(Uniform3fv) X(Uniform3i) X(Uniform3iv) X(Uniform4f)            \
    X(Uniform4fv) X(Uniform4i) X(Uniform4iv) X(UniformMatrix2fv) X(UniformMatrix3fv) X(UniformMatrix4fv)     \
    X(UseProgram) X(ValidateProgram) X(VertexAttrib1f) X(VertexAttrib1fv) X(VertexAttrib2f)                  \
    X(VertexAttrib2fv) X(VertexAttrib3f) X(VertexAttrib3fv) X(VertexAttrib4f) X(VertexAttrib4fv)             \
    X(VertexAttribPointer) X(Viewport)
// clang-format on

namespace FRANKEN_API franken {

/// Returns the address of a GL function by its full name ("glClear"), or null. The signature is that of the
/// platform component's surfaces, of SDL_GL_GetProcAddress and of other engines' loaders.
using GetProcAddress = std::function<void*(const char* name)>;

/// The functions of one GLES2 context. The library calls GL through this table only and links no GL library,
/// so that EGL, OSMesa and WebGL are all just one more context, and two of them can live in one process.
///
/// Members have GL's own names without the prefix: `gl.DrawArrays(GL_TRIANGLES, 0, 3)`. The types are those
/// of the prototypes in <GLES2/gl2.h>, of which only the declarations are used. A table belongs to the
/// contexts of the driver from which it was loaded; the context must be current at each call. It is plain
/// data (about 1 KiB): copies and pointers are equally good.
struct Gl {
/// The member for one function; defined here alone.
#define FRANKEN_GL_MEMBER(name) decltype(&::gl##name) name = nullptr; // NOLINT(bugprone-macro-parentheses)
    FRANKEN_GL_FUNCTIONS(FRANKEN_GL_MEMBER)
#undef FRANKEN_GL_MEMBER

    /// Fills the whole table. Fails with `gl.missing-functions` where the context lacks any function, and
    /// names them all: a desktop OpenGL context needs version 4.1 or GL_ARB_ES2_compatibility. Some drivers
    /// (libglvnd) return an address for any name, so that success proves nothing about extensions.
    static Result<Gl> load(const GetProcAddress& getProcAddress);
};

} // namespace franken
