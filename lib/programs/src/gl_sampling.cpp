// SPDX-License-Identifier: MIT
#include "franken/gl_sampling.h"

namespace franken {
namespace {

GLint toGl(Wrap wrap) {
    switch (wrap) {
    case Wrap::Repeat:
        return GL_REPEAT;
    case Wrap::ClampToEdge:
        return GL_CLAMP_TO_EDGE;
    case Wrap::MirroredRepeat:
        return GL_MIRRORED_REPEAT;
    }
    return GL_REPEAT;
}

GLint toGl(Filter filter) {
    switch (filter) {
    case Filter::Nearest:
        return GL_NEAREST;
    case Filter::Linear:
        return GL_LINEAR;
    case Filter::NearestMipmapNearest:
        return GL_NEAREST_MIPMAP_NEAREST;
    case Filter::LinearMipmapNearest:
        return GL_LINEAR_MIPMAP_NEAREST;
    case Filter::NearestMipmapLinear:
        return GL_NEAREST_MIPMAP_LINEAR;
    case Filter::LinearMipmapLinear:
        return GL_LINEAR_MIPMAP_LINEAR;
    }
    return GL_LINEAR;
}

} // namespace

void setSampling(const Gl& gl, GLenum target, Wrap wrapS, Wrap wrapT, Filter magFilter, Filter minFilter) {
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, toGl(wrapS));
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, toGl(wrapT));
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, toGl(magFilter));
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, toGl(minFilter));
}

} // namespace franken
