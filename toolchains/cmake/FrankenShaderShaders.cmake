# SPDX-License-Identifier: MIT
# frankenshader_add_shaders(TARGET target MANIFEST file [PROFILE profile...] [EFFECTS path...] [HEADER name | FOLDER name])
#
# Writes the programs that the manifest lists, a name a line, when TARGET is built, and anew when the manifest, an effect
# or the program frankenshader changes. HEADER (the default is frankenshader_programs.h): one header of C and C++, which
# TARGET can include by that name. FOLDER: NAME.vert, NAME.frag and manifest.json, in that folder of the build tree; the
# property FRANKENSHADER_FOLDER of TARGET is its path. A program that does not fit in the budget of a PROFILE (vc4, v3d,
# es2-minimum, software or all) fails the build.
function(frankenshader_add_shaders)
    cmake_parse_arguments(PARSE_ARGV 0 ARG "" "TARGET;MANIFEST;HEADER;FOLDER" "PROFILE;EFFECTS")
    if(ARG_UNPARSED_ARGUMENTS OR NOT ARG_TARGET OR NOT ARG_MANIFEST OR (ARG_HEADER AND ARG_FOLDER))
        message(FATAL_ERROR "frankenshader_add_shaders(TARGET target MANIFEST file [PROFILE profile...] "
            "[EFFECTS path...] [HEADER name | FOLDER name]): ${ARG_UNPARSED_ARGUMENTS}")
    endif()
    if(NOT TARGET FrankenShader::frankenshader)
        message(FATAL_ERROR "frankenshader_add_shaders() needs the program frankenshader: install it, or set FrankenShader_PROGRAM")
    endif()
    cmake_path(ABSOLUTE_PATH ARG_MANIFEST BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    set(effects)
    foreach(effect IN LISTS ARG_EFFECTS)
        cmake_path(ABSOLUTE_PATH effect BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
        list(APPEND effects --effects ${effect})
    endforeach()
    set(check)
    foreach(profile IN LISTS ARG_PROFILE)
        list(APPEND check --profile ${profile})
    endforeach()
    if(check)
        set(check COMMAND FrankenShader::frankenshader check --manifest ${ARG_MANIFEST} ${effects} ${check})
    endif()

    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${ARG_TARGET}_shaders)
    if(ARG_FOLDER)
        set(output ${folder}/${ARG_FOLDER}/manifest.json)
        set(written --format files -o ${folder}/${ARG_FOLDER})
        set_target_properties(${ARG_TARGET} PROPERTIES FRANKENSHADER_FOLDER ${folder}/${ARG_FOLDER})
    else()
        if(NOT ARG_HEADER)
            set(ARG_HEADER frankenshader_programs.h)
        endif()
        set(output ${folder}/${ARG_HEADER})
        set(written --format c -o ${output})
        target_include_directories(${ARG_TARGET} PRIVATE ${folder})
    endif()
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${output} ${check}
        COMMAND FrankenShader::frankenshader dump --manifest ${ARG_MANIFEST} ${effects} ${written} --depfile ${output}.d
        DEPENDS ${ARG_MANIFEST} FrankenShader::frankenshader DEPFILE ${output}.d VERBATIM
        COMMENT "Writing the shaders of ${ARG_TARGET}")
    target_sources(${ARG_TARGET} PRIVATE ${output})
endfunction()
