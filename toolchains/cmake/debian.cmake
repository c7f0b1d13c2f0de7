# SPDX-License-Identifier: MIT
# The Debian packages that toolchains/packages.sh has CPack make: a component of the install rules each.
set(FRANKEN_MAINTAINER "The FrankenShader authors <frankenshader@packages.example>" CACHE STRING
    "Who a Debian package names as its maintainer")
set(FRANKEN_DEBIAN_REVISION 1 CACHE STRING "Of the Debian packages: behind the dash of their version")
set(FRANKEN_STATIC_TREE "" CACHE PATH "A build tree of the same with static libraries, for the package -dev")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL library development tools documentation)
if(TARGET kiosk)
    list(APPEND CPACK_COMPONENTS_ALL kiosk)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};${PROJECT_NAME};ALL;/")
if(FRANKEN_STATIC_TREE)
    set(CPACK_COMPONENTS_STATIC development)
    list(APPEND CPACK_INSTALL_CMAKE_PROJECTS ${FRANKEN_STATIC_TREE} ${PROJECT_NAME} STATIC /)
endif()
# Files as a package wants them; then what each of them depends on.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_files.cmake)

set(version ${PROJECT_VERSION}-${FRANKEN_DEBIAN_REVISION})
set(library_package libfrankenshader${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${FRANKEN_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_RELEASE ${FRANKEN_DEBIAN_REVISION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE frankenshader)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# dpkg-shlibdeps reads dependencies off the binaries; libraries of ours stand in another component.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(dirs)
foreach(library base generator programs assets renderer platform)
    if(TARGET franken_${library})
        get_target_property(dir franken_${library} BINARY_DIR)
        list(APPEND dirs ${dir})
    endif()
endforeach()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${dirs})

# franken_debian(COMPONENT NAME SECTION DEPENDS DESCRIPTION)
macro(franken_debian component name section depends description)
    string(TOUPPER ${component} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
endmacro()

set(about "FrankenShader composes, at run time, the one single-pass GLSL ES 1.00
program that a material and its lights need, for Raspberry Pi class GPUs,
and draws glTF models with it.")
franken_debian(library ${library_package} libs ""
    "Single-pass GLSL ES programs for Raspberry Pi GPUs: libraries\n${about}\n.\nThis package holds the shared libraries.")
franken_debian(development libfrankenshader-dev libdevel "${library_package} (= ${version}), libglm-dev, libgles-dev"
    "Single-pass GLSL ES programs for Raspberry Pi GPUs: development\n${about}\n.\nThis package holds headers, static libraries, the CMake package and\nfiles for pkg-config.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS
    "frankenshader, frankenshader-doc, libtinygltf-dev, libtinyexr-dev, libegl-dev, libgbm-dev, libdrm-dev, libgpiod-dev, libinput-dev, libudev-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
franken_debian(tools frankenshader graphics "${library_package} (= ${version})"
    "Single-pass GLSL ES programs for Raspberry Pi GPUs: programs\n${about}\n.\nThis package holds the programs that write, explain, check and price\nshaders, draw models to pictures, and filter skies.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "libgl1-mesa-dri, libosmesa6, libegl-mesa0")
# What follows g++ is for the Pi's compilers, which toolchain.sh builds: `frankenshader cost`, `viewer --price`.
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS
    "glslang-tools, g++, libegl-dev, libgles-dev, libgbm-dev, dpkg-dev, pkg-config, ninja-build, bison, flex, libdrm-dev, libexpat1-dev, zlib1g-dev, libelf-dev, python3-venv, xz-utils, patch")
franken_debian(kiosk frankenshader-kiosk graphics "${library_package} (= ${version})"
    "Single-pass GLSL ES programs for Raspberry Pi GPUs: kiosk\n${about}\n.\nThis package holds a program that shows models on a screen\nwithout a window system, for months.")
set(CPACK_DEBIAN_KIOSK_PACKAGE_RECOMMENDS "libgl1-mesa-dri, libegl-mesa0, fonts-dejavu-core")
franken_debian(documentation frankenshader-doc doc ""
    "Single-pass GLSL ES programs for Raspberry Pi GPUs: documentation\n${about}\n.\nThis package holds the documentation, and examples of engines that\nembed it.")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/../debian/triggers)
include(CPack)
