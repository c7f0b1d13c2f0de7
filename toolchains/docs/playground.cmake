# SPDX-License-Identifier: MIT
# cmake -DSOURCE_DIR= -DTREE= -DPROGRAMS= -DSITE= -DPARTS= -P playground.cmake: the playground for the site: built in TREE, copied
# to SITE/playground, and PARTS/playground.md, which leads to it. Where its compiler is missing, that says so.
set(build ${SOURCE_DIR}/examples/web/build.sh)
execute_process(COMMAND ${build} ${TREE} ${PROGRAMS} RESULT_VARIABLE result)
if(result EQUAL 77)
    file(WRITE ${PARTS}/playground.md "This documentation was built without the page, because clang 14 with WASI's libraries was missing.\n")
elseif(result EQUAL 0)
    file(COPY ${TREE}/ DESTINATION ${SITE}/playground)
    file(WRITE ${PARTS}/playground.md "**[Open the playground](playground/index.html)**, which is part of this documentation. Where that is read from a disk, the page says how to serve it.\n")
else()
    message(FATAL_ERROR "${build}: ${result}")
endif()
