# SPDX-License-Identifier: MIT
# Builds for WebAssembly with Debian's clang and WASI libraries, of whichever version is there (12: clang 14).
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
foreach(version 14 15 16 17 18 19 20 21)
    if(EXISTS /usr/lib/llvm-${version}/lib/wasm32-wasi/libc++.a AND EXISTS /usr/bin/clang++-${version})
        set(CMAKE_CXX_COMPILER /usr/bin/clang++-${version})
        set(CMAKE_AR /usr/bin/llvm-ar-${version} CACHE FILEPATH "")
        set(CMAKE_RANLIB /usr/bin/llvm-ranlib-${version} CACHE FILEPATH "")
    endif()
endforeach()
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_FLAGS_INIT "--sysroot=/usr")
