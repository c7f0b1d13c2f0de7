# SPDX-License-Identifier: MIT
# Run by CPack between installing and packaging: what Debian wants of each package besides the files that are installed
# everywhere. Manual pages and changelogs are compressed, without a name or a time in them, and each package has a
# copyright file.
cmake_minimum_required(VERSION 3.22)
execute_process(COMMAND date -u -R -d @$ENV{SOURCE_DATE_EPOCH} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component})
    set(doc ${root}/usr/share/doc/${name})
    file(MAKE_DIRECTORY ${doc})
    if(EXISTS ${root}/usr/share/doc/FrankenShader)
        file(GLOB files ${root}/usr/share/doc/FrankenShader/*)
        file(COPY ${files} DESTINATION ${doc})
        file(REMOVE_RECURSE ${root}/usr/share/doc/FrankenShader)
        # The licence is in the copyright file below.
        file(REMOVE ${doc}/LICENSE)
        file(READ ${doc}/README.md page)
        string(REPLACE "(LICENSE)" "(copyright)" page "${page}")
        file(WRITE ${doc}/README.md "${page}")
        file(RENAME ${doc}/CHANGELOG.md ${doc}/changelog)
    endif()
    file(READ ${CMAKE_CURRENT_LIST_DIR}/../../LICENSE licence)
    string(REGEX REPLACE "\n+$" "" licence "${licence}")
    string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)" ignored "${licence}")
    set(holder ${CMAKE_MATCH_1})
    string(REGEX REPLACE "^MIT License\n\nCopyright[^\n]*\n\n" "" licence "${licence}")
    string(REPLACE "\n\n" "\n.\n" licence "${licence}")
    string(REPLACE "\n" "\n " licence "${licence}")
    file(WRITE ${doc}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: FrankenShader

Files: *
Copyright: ${holder}
License: Expat
 ${licence}
")
    file(WRITE ${doc}/changelog.Debian "frankenshader (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) stable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}: the changelog in frankenshader-doc says what changed.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}
")
    file(GLOB pages ${root}/usr/share/man/man*/*[0-9])
    file(GLOB changelogs ${doc}/changelog ${doc}/changelog.Debian)
    execute_process(COMMAND gzip -9nf ${pages} ${changelogs} COMMAND_ERROR_IS_FATAL ANY)
    # Not as the checkout's owner keeps files from others.
    execute_process(COMMAND chmod -R u=rwX,go=rX ${root} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
