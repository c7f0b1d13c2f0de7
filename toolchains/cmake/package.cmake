# SPDX-License-Identifier: MIT
# cmake --install: headers, libraries, programs with manual pages and completions, snippets, examples, the licence, and
# the CMake package FrankenShader with the components base, generator, programs, assets, renderer, runtime and platform.
# Everything is found relative to the package's own folder, so that the prefix may be moved. Static and shared
# libraries may be installed beside each other, from two build trees. What belongs to which Debian package is the
# COMPONENT of each rule (debian.cmake).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/FrankenShader)
set(data_dir ${CMAKE_INSTALL_DATADIR}/frankenshader)
set(linkage static)
if(BUILD_SHARED_LIBS)
    set(linkage shared)
endif()

function(franken_export name)
    install(TARGETS franken_${name} EXPORT FrankenShader-${linkage}-${name}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT FrankenShader-${linkage}-${name} NAMESPACE FrankenShader::
        DESTINATION ${package_dir} COMPONENT development)
endfunction()

# franken_pkg_config(NAME DESCRIPTION [REQUIRES name...] [PRIVATE text]): frankenshader-NAME.pc. PRIVATE is what a static
# library is linked with besides.
function(franken_pkg_config name description)
    cmake_parse_arguments(PARSE_ARGV 2 ARG "" "PRIVATE" "REQUIRES")
    file(RELATIVE_PATH prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    list(JOIN ARG_REQUIRES " " requires)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/pkgconfig/frankenshader-${name}.pc @ONLY CONTENT
"prefix=\${pcfiledir}/${prefix}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: frankenshader-${name}
Description: ${description}
Version: ${PROJECT_VERSION}
Requires: ${requires}
Cflags: -I\${includedir}
Libs: -L\${libdir} -lfranken_${name}
Libs.private: ${ARG_PRIVATE}
")
    install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/frankenshader-${name}.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()

# A shared library of ours says which version of the interface it is, and finds the others beside it.
function(franken_library name source_dir)
    set_target_properties(franken_${name} PROPERTIES
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    if(BUILD_SHARED_LIBS)
        set_target_properties(franken_${name} PROPERTIES INSTALL_RPATH $ORIGIN)
    endif()
    install(DIRECTORY ${source_dir}/include/franken DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
    franken_export(${name})
endfunction()

franken_library(base lib/base)
franken_library(generator generator)
franken_pkg_config(base "Results, files and text that all of FrankenShader shares" PRIVATE "-lstdc++")
franken_pkg_config(generator "From a permutation to the text of a GLSL ES 1.00 program" REQUIRES frankenshader-base)
if(FRANKEN_PROGRAMS)
    franken_library(programs lib/programs)
    franken_pkg_config(programs "Programs on a GPU: compiled, cached, proved and warmed up" REQUIRES frankenshader-generator)
endif()
if(FRANKEN_RUNTIME)
    franken_library(assets lib/assets)
    franken_library(renderer lib/renderer)
    franken_export(runtime)
    set(parsers "-ltinygltf -pthread")
    if(TARGET tinyexr)
        string(APPEND parsers " -ltinyexr")
    endif()
    franken_pkg_config(assets "Models and skies as plain data" REQUIRES frankenshader-generator PRIVATE "${parsers}")
    franken_pkg_config(renderer "Draws models with composed programs" REQUIRES frankenshader-programs frankenshader-assets)
endif()
if(FRANKEN_PLATFORM)
    franken_library(platform platform)
    franken_pkg_config(platform "Contexts, screens, buttons and touch" REQUIRES frankenshader-base
        PRIVATE "${FRANKEN_PLATFORM_LINKED}")
endif()

# franken_program(TARGET COMPONENT [PAGE command...]): installed as frankenshader-TARGET, because the plain names are too
# general for a folder that all programs share; with what PAGE... prints as its manual page, and its completions.
function(franken_program target component)
    cmake_parse_arguments(PARSE_ARGV 2 ARG "" "" "PAGE;COMPLETIONS;DEPENDS")
    set(name frankenshader-${target})
    if(target STREQUAL frankenshader)
        set(name frankenshader)
    endif()
    if(BUILD_SHARED_LIBS)
        file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
        set_target_properties(${target} PROPERTIES INSTALL_RPATH $ORIGIN/${bin_to_lib})
    endif()
    install(TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component})
    if(NOT name STREQUAL target)
        set(bin "\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}")
        install(CODE "file(RENAME \"${bin}/${target}\" \"${bin}/${name}\")
list(TRANSFORM CMAKE_INSTALL_MANIFEST_FILES REPLACE \"/${target}\$\" \"/${name}\")" COMPONENT ${component})
    endif()

    # Programs for another processor print where there is an emulator.
    if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
        message(STATUS "${name}: no manual page and no completions without an emulator")
        return()
    endif()
    set(out ${PROJECT_BINARY_DIR}/manual/${name})
    file(MAKE_DIRECTORY ${out})
    set(made ${out}/${name}.1)
    set(commands COMMAND ${target} ${ARG_PAGE} >${out}/${name}.1)
    foreach(shell bash zsh fish)
        list(APPEND made ${out}/${shell})
        list(APPEND commands COMMAND ${target} ${ARG_COMPLETIONS} ${shell} >${out}/${shell})
    endforeach()
    add_custom_command(OUTPUT ${made} ${commands} DEPENDS ${target} ${ARG_DEPENDS} COMMENT "Manual page of ${name}")
    add_custom_target(manual_${target} ALL DEPENDS ${made})
    install(FILES ${out}/${name}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component})
    foreach(place "bash:bash-completion/completions/${name}" "zsh:zsh/vendor-completions/_${name}"
            "fish:fish/vendor_completions.d/${name}.fish")
        string(REPLACE ":" ";" place ${place})
        list(GET place 0 shell)
        list(GET place 1 file)
        cmake_path(GET file PARENT_PATH folder)
        cmake_path(GET file FILENAME file)
        install(FILES ${out}/${shell} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} RENAME ${file} COMPONENT ${component})
    endforeach()
endfunction()

if(FRANKEN_CLI)
    set(page ${PROJECT_SOURCE_DIR}/generator/cli/frankenshader.1.in)
    franken_program(frankenshader tools PAGE manual ${page} COMPLETIONS completions DEPENDS ${page})
endif()
foreach(program viewer bake)
    if(TARGET ${program})
        franken_program(${program} tools PAGE --manual COMPLETIONS --completions)
    endif()
endforeach()
if(TARGET kiosk)
    franken_program(kiosk kiosk PAGE --manual COMPLETIONS --completions)
    install(FILES examples/kiosk/kiosk.toml examples/kiosk/README.md examples/kiosk/kiosk.png
        examples/kiosk/kiosk-turned.png examples/kiosk/loading.png examples/kiosk/loading-turned.png DESTINATION ${data_dir}/kiosk COMPONENT kiosk)
    install(DIRECTORY examples/kiosk/appliance DESTINATION ${data_dir}/kiosk USE_SOURCE_PERMISSIONS COMPONENT kiosk)
endif()
# To be read by those who write snippets and effects of their own; and what `frankenshader cost` needs.
install(DIRECTORY generator/glsl DESTINATION ${data_dir} COMPONENT tools)
install(DIRECTORY examples/effects/ DESTINATION ${data_dir}/effects COMPONENT tools)
install(PROGRAMS tests/qpu/toolchain.sh DESTINATION ${data_dir}/qpu COMPONENT tools)
install(FILES tests/qpu/qpu_stats.cpp DESTINATION ${data_dir}/qpu COMPONENT tools)
install(DIRECTORY tests/qpu/mesa DESTINATION ${data_dir}/qpu COMPONENT tools USE_SOURCE_PERMISSIONS)

install(CODE "set(SOURCE_DIR \"${PROJECT_SOURCE_DIR}\")
set(DOC_DIR \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}\")
include(\"${CMAKE_CURRENT_LIST_DIR}/documentation.cmake\")" COMPONENT documentation)
# The site, where the target docs was built before.
install(DIRECTORY ${PROJECT_BINARY_DIR}/docs/site/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/html COMPONENT documentation OPTIONAL)
install(DIRECTORY examples/embed DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT documentation)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/FrankenShaderConfig.cmake.in
    ${PROJECT_BINARY_DIR}/FrankenShaderConfig.cmake INSTALL_DESTINATION ${package_dir}
    PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/FrankenShaderConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/FrankenShaderConfig.cmake ${PROJECT_BINARY_DIR}/FrankenShaderConfigVersion.cmake
    ${CMAKE_CURRENT_LIST_DIR}/FrankenShaderShaders.cmake DESTINATION ${package_dir} COMPONENT development)
include(${CMAKE_CURRENT_LIST_DIR}/debian.cmake)
