// SPDX-License-Identifier: MIT
//
// OSMesa is opened at run time and kept to ourselves (RTLD_LOCAL). It exports all of desktop GL: linked, it
// would catch the gl* calls that an application, SDL or a foreign engine means for another driver. And a
// kiosk need not install it. RTLD_DEEPBIND is not needed (it binds its own gl* calls to itself), and
// AddressSanitizer refuses it. It is never closed: Mesa leaves thread-local data and exit handlers behind.
//
// What differs from a GLES2 context of the same Mesa, beyond what open() evens out: GL_VERSION does not begin
// with "OpenGL ES", and GL_EXTENSIONS lacks the OES names of what desktop GL has in its core (32-bit indices,
// derivatives, textures of any size with mipmaps, float and depth textures), though all of it works. Programs
// of #version 100 are compiled by the same rules, with the same macros.
#include "backends.h"
#include "shared_library.h"

#include <GL/osmesa.h>

#include <cstdint>
#include <vector>

namespace franken::platform {

namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";
constexpr const char* kInstall = "install the Debian package libosmesa6, or choose another backend";

struct Library {
    decltype(&::OSMesaCreateContextExt) createContext = nullptr;
    decltype(&::OSMesaDestroyContext) destroyContext = nullptr;
    decltype(&::OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&::OSMesaGetProcAddress) getProcAddress = nullptr;

    static Result<Library> open();
};

Result<Library> Library::open() {
    Result<SharedLibrary> file = SharedLibrary::open(kLibrary, kInstall);
    if (!file)
        return file.error();
    Library library;
    file->find(library.createContext, "OSMesaCreateContextExt");
    file->find(library.destroyContext, "OSMesaDestroyContext");
    file->find(library.makeCurrent, "OSMesaMakeCurrent");
    file->find(library.getProcAddress, "OSMesaGetProcAddress");
    if (Result<void> found = file->found(); !found)
        return found.error();
    return library;
}

class OsMesaSurface final : public ImmediateSurface {
public:
    OsMesaSurface(const Library& library, OSMesaContext context, Size size)
        : ImmediateSurface(Backend::OsMesa, size),
          m_library(library),
          m_context(context),
          m_pixels(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

    ~OsMesaSurface() override {
        letGo();
        m_library.destroyContext(m_context);
    }

    GetProcAddress getProcAddress() const override {
        return [find = m_library.getProcAddress](const char* name) {
            return reinterpret_cast<void*>(find(name));
        };
    }

    Result<void> open();

protected:
    Result<void> swap() override { return {}; }

    Result<void> bind() override {
        if (!m_library.makeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, m_size.width, m_size.height))
            return Error{"surface.driver", "OSMesaMakeCurrent", "the driver refuses the target",
                         "choose a smaller size"};
        return {};
    }

    void unbind() override { m_library.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

private:
    Library m_library;
    OSMesaContext m_context;
    std::vector<std::uint32_t> m_pixels; ///< RGBA8, row 0 at the bottom.
};

Result<void> OsMesaSurface::open() {
    if (Result<void> ready = makeReady(); !ready)
        return ready;
    const auto enable = reinterpret_cast<decltype(&::glEnable)>(m_library.getProcAddress("glEnable"));
    if (enable == nullptr)
        return Error{"surface.driver", "OSMesaGetProcAddress", "the library provides no GL functions",
                     kInstall};
    // Off at first in desktop GL, always on in a GLES context of Mesa (seamless cube maps: of 3.0 and up).
    enable(GL_POINT_SPRITE);
    enable(GL_VERTEX_PROGRAM_POINT_SIZE);
    enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    return {};
}

} // namespace

Result<std::unique_ptr<Surface>> createOsMesa(const SurfaceOptions& options) {
    const Result<Library> library = Library::open(); // Loaded once; where it failed, it is tried anew.
    if (!library)
        return library.error();
    const OSMesaContext context = library->createContext(OSMESA_RGBA, options.depthBits, 0, 0, nullptr);
    if (context == nullptr)
        return Error{"surface.driver", "OSMesaCreateContextExt",
                     "the driver refuses an RGBA8 compatibility context with " +
                         std::to_string(options.depthBits) + " bits of depth",
                     "ask for 24 bits or fewer"};
    auto surface = std::make_unique<OsMesaSurface>(*library, context, options.size);
    if (Result<void> opened = surface->open(); !opened)
        return opened.error();
    return std::unique_ptr<Surface>(std::move(surface));
}

} // namespace franken::platform
