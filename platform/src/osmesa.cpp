// SPDX-License-Identifier: MIT
//
// OSMesa is opened at run time and kept to ourselves (RTLD_LOCAL). It exports all of desktop GL: linked, it
// would catch the gl* calls that an application, SDL or a foreign engine means for another driver. And a
// kiosk need not install it. RTLD_DEEPBIND is not needed (it binds its own gl* calls to itself), and
// AddressSanitizer refuses it. It is never closed: Mesa leaves thread-local data and exit handlers behind.
#include "backends.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cstdint>
#include <vector>

namespace franken::platform {

namespace {

Error driverError(std::string where, std::string what) {
    return Error{"surface.driver", std::move(where), std::move(what),
                 "install the Debian package libosmesa6, or choose another backend"};
}

struct Library {
    decltype(&::OSMesaCreateContextAttribs) createContext = nullptr;
    decltype(&::OSMesaDestroyContext) destroyContext = nullptr;
    decltype(&::OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&::OSMesaGetProcAddress) getProcAddress = nullptr;

    static Result<Library> open();
};

Result<Library> Library::open() {
    void* handle = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr)
        return driverError("libOSMesa.so.8", dlerror());
    Library library;
    const char* missing = nullptr;
    const auto find = [&]<typename Function>(Function*& function, const char* name) {
        function = reinterpret_cast<Function*>(dlsym(handle, name));
        if (function == nullptr)
            missing = name;
    };
    find(library.createContext, "OSMesaCreateContextAttribs");
    find(library.destroyContext, "OSMesaDestroyContext");
    find(library.makeCurrent, "OSMesaMakeCurrent");
    find(library.getProcAddress, "OSMesaGetProcAddress");
    if (missing != nullptr)
        return driverError("libOSMesa.so.8", std::string("the library is too old: it has no ") + missing);
    return library;
}

class OsMesaSurface final : public Surface {
public:
    OsMesaSurface(const Library& library, OSMesaContext context, Size size)
        : Surface(size),
          m_library(library),
          m_context(context),
          m_pixels(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

    ~OsMesaSurface() override {
        const Detached detached(*this);
        m_library.destroyContext(m_context);
    }

    std::string_view backend() const override { return "osmesa"; }

    GetProcAddress getProcAddress() const override {
        return [find = m_library.getProcAddress](const char* name) {
            return reinterpret_cast<void*>(find(name));
        };
    }

    Result<void> present() override {
        m_finish();
        return {};
    }

    Result<void> open();

protected:
    Result<void> bind() override {
        if (!m_library.makeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, m_size.width, m_size.height))
            return driverError("OSMesaMakeCurrent", "the driver refuses a target of " +
                                                        std::to_string(m_size.width) + "x" +
                                                        std::to_string(m_size.height) + " pixels");
        return {};
    }

    void unbind() override { m_library.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

private:
    Library m_library;
    OSMesaContext m_context;
    std::vector<std::uint32_t> m_pixels; ///< RGBA8, row 0 at the bottom.
    void (*m_finish)() = nullptr;
};

Result<void> OsMesaSurface::open() {
    if (Result<void> ready = makeReady(); !ready)
        return ready;
    const auto enable = reinterpret_cast<decltype(&::glEnable)>(m_library.getProcAddress("glEnable"));
    m_finish = reinterpret_cast<decltype(&::glFinish)>(m_library.getProcAddress("glFinish"));
    if (enable == nullptr || m_finish == nullptr)
        return driverError("OSMesaGetProcAddress", "the library hands out no GL functions");
    // Always on in GLES2, off at first in desktop GL: gl_PointCoord and gl_PointSize.
    enable(GL_POINT_SPRITE);
    enable(GL_VERTEX_PROGRAM_POINT_SIZE);
    return {};
}

} // namespace

Result<std::unique_ptr<Surface>> createOsMesa(const SurfaceOptions& options) {
    static const Result<Library> library = Library::open();
    if (!library)
        return library.error();
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              options.depthBits,
                              OSMESA_STENCIL_BITS,
                              0,
                              OSMESA_ACCUM_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_COMPAT_PROFILE,
                              0};
    const OSMesaContext context = library->createContext(attributes, nullptr);
    if (context == nullptr)
        return driverError("OSMesaCreateContextAttribs", "the driver refuses an RGBA8 compatibility context");
    auto surface = std::make_unique<OsMesaSurface>(*library, context, options.size);
    if (Result<void> opened = surface->open(); !opened)
        return opened.error();
    return std::unique_ptr<Surface>(std::move(surface));
}

} // namespace franken::platform
