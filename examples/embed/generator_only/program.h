// SPDX-License-Identifier: MIT
#pragma once

#include <franken/generator/compose.h>
#include <franken/generator/pack.h>

#include <GLES2/gl2.h>

/// The values of the four blocks, by franken::Block.
struct Values {
    franken::FrameBlock frame{};
    franken::LightsBlock lights{};
    franken::MaterialBlock material{};
    franken::ObjectBlock object{};
};

/// Compiles and links what the composer wrote, with attributes where its interface has them, and puts the
/// program to use. Fails with the driver's log, in which each line names the snippet that it is about.
franken::Result<GLuint> makeProgram(const franken::Composed& composed);

/// Sets every uniform and sampler of the interface. The program must be in use.
void setUniforms(GLuint program, const franken::Interface& interface, const Values& values);
