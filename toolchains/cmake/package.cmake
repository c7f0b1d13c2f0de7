# SPDX-License-Identifier: MIT
# cmake --install: headers, libraries, the program with its manual, the licence, and the CMake package
# FrankenShader with the components base, generator, programs, assets, renderer, runtime and platform. Everything is found
# relative to the package's own folder, so that the prefix may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/FrankenShader)

function(franken_export name)
    install(TARGETS franken_${name} EXPORT FrankenShader-${name}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT FrankenShader-${name} NAMESPACE FrankenShader:: DESTINATION ${package_dir})
endfunction()

# A shared library of ours says which version of the interface it is, and finds the others beside it.
function(franken_library name source_dir)
    set_target_properties(franken_${name} PROPERTIES
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    if(BUILD_SHARED_LIBS)
        set_target_properties(franken_${name} PROPERTIES INSTALL_RPATH $ORIGIN)
    endif()
    install(DIRECTORY ${source_dir}/include/franken DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    franken_export(${name})
endfunction()

franken_library(base lib/base)
franken_library(generator generator)
if(FRANKEN_PROGRAMS)
    franken_library(programs lib/programs)
endif()
if(FRANKEN_RUNTIME)
    franken_library(assets lib/assets)
    franken_library(renderer lib/renderer)
    franken_export(runtime)
endif()
if(FRANKEN_PLATFORM)
    franken_library(platform platform)
endif()
if(FRANKEN_CLI)
    if(BUILD_SHARED_LIBS)
        file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
        set_target_properties(frankenshader PROPERTIES INSTALL_RPATH $ORIGIN/${bin_to_lib})
    endif()
    install(TARGETS frankenshader RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(FILES generator/cli/frankenshader.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
# To be read by those who write snippets and effects of their own.
install(DIRECTORY generator/glsl DESTINATION ${CMAKE_INSTALL_DATADIR}/frankenshader)
install(DIRECTORY examples/effects/ DESTINATION ${CMAKE_INSTALL_DATADIR}/frankenshader/effects)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/FrankenShaderConfig.cmake.in
    ${PROJECT_BINARY_DIR}/FrankenShaderConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/FrankenShaderConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/FrankenShaderConfig.cmake
    ${PROJECT_BINARY_DIR}/FrankenShaderConfigVersion.cmake DESTINATION ${package_dir})
