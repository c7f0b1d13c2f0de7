// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl.h"
#include "franken/image.h"
#include "franken/platform/surface.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace franken::test {

/// What a target holds.
struct ReadBack : Image {
    using Pixel = std::array<int, 4>;
    /// x from the left, y from the top.
    Pixel pixel(int x, int y) const;
};

/// A context to draw with in a test, and its functions.
struct Offscreen {
    std::unique_ptr<platform::Surface> surface;
    Gl gl;
};

/// Opens one, current and with the viewport of the whole target. Unless the environment says otherwise,
/// Mesa's softpipe draws, on both backends and whatever GPU there is: pictures are compared exactly under it.
Result<Offscreen> openOffscreen(platform::Backend backend, platform::Size size, int samples = 0);

/// What the target holds, as GL returns it (alpha included), or another framebuffer of its size. The surface
/// must be current.
ReadBack readBack(const Offscreen& offscreen);
ReadBack readBack(const Offscreen& offscreen, unsigned framebuffer);

/// A test that runs on every backend. It is skipped where the backend is not installed, and fails where it
/// does not work.
///
///     using Draw = OffscreenTest;
///     INSTANTIATE_TEST_SUITE_P(Backends, Draw, allBackends(), backendName);
///     TEST_P(Draw, ATriangle) { gl().Clear(...); EXPECT_EQ(readBack().pixel(0, 0), ...); }
class OffscreenTest : public testing::TestWithParam<platform::Backend> {
protected:
    explicit OffscreenTest(platform::Size size = {64, 64}) : m_size(size) {}
    void SetUp() override;

    const Gl& gl() const { return m_offscreen.gl; }
    platform::Surface& surface() { return *m_offscreen.surface; }
    /// Destroys the context and makes another one, which is current. Its table may be another one.
    void replaceContext(platform::Size size);
    ReadBack readBack() const { return test::readBack(m_offscreen); }

private:
    platform::Size m_size;
    Offscreen m_offscreen;
};

inline auto allBackends() {
    return testing::Values(platform::Backend::OsMesa, platform::Backend::EglSurfaceless);
}

inline std::string backendName(const testing::TestParamInfo<platform::Backend>& info) {
    return std::string(platform::toString(info.param));
}

} // namespace franken::test

namespace franken::platform {
/// For GoogleTest's messages.
inline void PrintTo(Backend backend, std::ostream* out) { *out << toString(backend); }
} // namespace franken::platform
