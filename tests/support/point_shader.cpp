// SPDX-License-Identifier: MIT
#include "support/point_shader.h"
#include "franken/gl_object.h"

#include <gtest/gtest.h>

namespace franken::test {
namespace {

constexpr GLsizei kWidth = 64;
constexpr GLint kRgba32F = 0x8814; // GL_RGBA32F, of OpenGL 3.0 and OpenGL ES 3.0

constexpr Float9 kIdentity3 = {1, 0, 0, 0, 1, 0, 0, 0, 1};
constexpr Float16 kIdentity4 = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
// The triangle covers its pixel whatever the model matrix is; in the world it is as good as a point.
constexpr float kTiny = 1.0f / 4096;
constexpr Float16 kPoint = {kTiny, 0, 0, 0, 0, kTiny, 0, 0, 0, 0, kTiny, 0, 0, 0, 0, 1};

/// A target of so many pixels, bound.
class FloatTarget {
public:
    FloatTarget(const Gl& gl, GLsizei height)
        : m_texture(gl, generate(gl.GenTextures)), m_framebuffer(gl, generate(gl.GenFramebuffers)) {
        gl.ActiveTexture(GL_TEXTURE7);
        gl.BindTexture(GL_TEXTURE_2D, m_texture.name());
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexImage2D(GL_TEXTURE_2D, 0, kRgba32F, kWidth, height, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture.name(), 0);
        EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    }

private:
    GlTexture m_texture;
    GlFramebuffer m_framebuffer;
};

void drawPoint(const Gl& gl, const ShadedPoint& point) {
    gl.VertexAttrib3fv(1, point.normal.data());
    gl.VertexAttrib4fv(2, point.tangent.data());
    gl.VertexAttrib2fv(3, point.uv.data());
    gl.VertexAttrib2fv(4, point.uv.data());
    gl.VertexAttrib4f(5, 1, 1, 1, 1);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace

ShadedPoint pointAt(const Float3& toCamera, const Float3& toLight, const MaterialFactors& factors,
                    Brdf brdf) {
    ShadedPoint point;
    point.frame.cameraPosition = toCamera;
    point.material = packMaterial(factors, brdf, 1);
    const Sun sun{.direction = {-toLight[0], -toLight[1], -toLight[2]}, .illuminance = 3.14159265f};
    packSun(point.lights, 0, sun, 1);
    return point;
}

std::vector<std::array<float, 4>> shade(const Gl& gl, const Permutation& permutation,
                                        const std::vector<ShadedPoint>& points) {
    ProgramCache cache(gl);
    const Result<ProgramHandle> program = cache.get(permutation);
    if (!program) {
        ADD_FAILURE() << toString(program.error());
        return {};
    }
    const auto rows = static_cast<GLsizei>(points.size() / kWidth + 1);
    const FloatTarget target(gl, rows);
    constexpr float kTriangle[] = {-1, -1, 0, 3, -1, 0, -1, 3, 0};
    const GlBuffer triangle(gl, generate(gl.GenBuffers));
    gl.BindBuffer(GL_ARRAY_BUFFER, triangle.name());
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(kTriangle), kTriangle, GL_STATIC_DRAW);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.EnableVertexAttribArray(0);
    gl.UseProgram((*program)->name());
    for (std::size_t i = 0; i < points.size(); ++i) {
        UniformBlock<FrameBlock> frame;
        UniformBlock<LightsBlock> lights;
        UniformBlock<MaterialBlock> material;
        UniformBlock<ObjectBlock> object;
        frame.edit() = points[i].frame;
        lights.edit() = points[i].lights;
        material.edit() = points[i].material;
        object.edit() = {kIdentity4, kPoint, kIdentity3, kIdentity3};
        (*program)->feed({frame.view(), lights.view(), material.view(), object.view()});
        gl.Viewport(static_cast<GLint>(i) % kWidth, static_cast<GLint>(i) / kWidth, 1, 1);
        drawPoint(gl, points[i]);
    }
    std::vector<std::array<float, 4>> pixels(static_cast<std::size_t>(rows) * kWidth);
    gl.ReadPixels(0, 0, kWidth, rows, GL_RGBA, GL_FLOAT, pixels.data());
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    pixels.resize(points.size());
    return pixels;
}

} // namespace franken::test
