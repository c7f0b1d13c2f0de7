// SPDX-License-Identifier: MIT
#include "franken/gl.h"

#include "franken/gl_object.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace franken {
namespace {

int somewhere = 0;

TEST(GlTable, IsFilledFromTheFullNames) {
    std::vector<std::string> asked;
    const Result<Gl> gl =
        Gl::load([&](const char* name) -> void* { return asked.push_back(name), &somewhere; });
    ASSERT_TRUE(gl);
    EXPECT_EQ(asked.size(), 142u); // Functions of OpenGL ES 2.0.
    EXPECT_EQ(asked.front(), "glActiveTexture");
    EXPECT_EQ(asked.back(), "glViewport");
    EXPECT_EQ(reinterpret_cast<void*>(gl->Viewport), &somewhere);
}

TEST(GlTable, NamesAllMissingFunctions) {
    const Result<Gl> gl = Gl::load([](const char* name) -> void* {
        const std::string_view text = name;
        return text == "glClearDepthf" || text == "glUseProgram" ? nullptr : &somewhere;
    });
    ASSERT_FALSE(gl);
    EXPECT_EQ(gl.error().code, "gl.missing-functions");
    EXPECT_EQ(gl.error().where, "glClearDepthf, glUseProgram");
    EXPECT_NE(gl.error().remedy.find("OpenGL ES 2.0"), std::string::npos);
}

std::vector<GLuint> deleted;

Gl recordingGl() {
    deleted.clear();
    Gl gl;
    gl.DeleteProgram = [](GLuint name) { deleted.push_back(name); };
    gl.DeleteTextures = [](GLsizei count, const GLuint* names) {
        deleted.insert(deleted.end(), names, names + count);
    };
    gl.GenTextures = [](GLsizei count, GLuint* names) { std::fill_n(names, count, 7u); };
    return gl;
}

TEST(GlObject, DeletesItsNameOnce) {
    const Gl gl = recordingGl();
    {
        const GlProgram program(gl, 3);
        GlTexture texture(gl, generate(gl.GenTextures));
        EXPECT_EQ(texture.name(), 7u);
        const GlTexture moved = std::move(texture);
        EXPECT_EQ(moved.name(), 7u);
    }
    EXPECT_EQ(deleted, (std::vector<GLuint>{7, 3}));
}

TEST(GlObject, DeletesWhatIsAssignedOver) {
    const Gl gl = recordingGl();
    GlTexture texture(gl, 1);
    texture = GlTexture(gl, 2);
    EXPECT_EQ(deleted, (std::vector<GLuint>{1}));
    EXPECT_EQ(texture.name(), 2u);
}

TEST(GlObject, DeletesNothingThatWasReleasedOrNeverMade) {
    const Gl gl = recordingGl();
    {
        const GlTexture none;
        EXPECT_FALSE(none);
        GlTexture lost(gl, 5);
        EXPECT_EQ(lost.release(), 5u);
    }
    EXPECT_TRUE(deleted.empty());
}

} // namespace
} // namespace franken
