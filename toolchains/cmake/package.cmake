# SPDX-License-Identifier: MIT
# cmake --install: headers, libraries, the programs, and the CMake package FrankenShader with the
# components generator, runtime and platform. Base comes with each.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/FrankenShader)

function(franken_component name source_dir)
    install(TARGETS franken_${name} EXPORT FrankenShader-${name}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(DIRECTORY ${source_dir}/include/franken DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT FrankenShader-${name} NAMESPACE FrankenShader:: DESTINATION ${package_dir})
endfunction()

franken_component(base lib/base)
franken_component(generator generator)
if(FRANKEN_RUNTIME)
    franken_component(runtime lib/runtime)
    franken_component(platform platform)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/FrankenShaderConfig.cmake.in
    ${CMAKE_BINARY_DIR}/FrankenShaderConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/FrankenShaderConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/FrankenShaderConfig.cmake
    ${CMAKE_BINARY_DIR}/FrankenShaderConfigVersion.cmake DESTINATION ${package_dir})
