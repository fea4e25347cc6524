# SPDX-License-Identifier: MIT
# Targets that look at the code instead of building it: analyze, analyze-deep, site, coverage.
find_package(Python3 3.9 COMPONENTS Interpreter)

if(Python3_FOUND)
  set(analyze ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/analyze.py --source ${PROJECT_SOURCE_DIR} --build ${PROJECT_BINARY_DIR})
  add_custom_target(analyze COMMAND ${analyze} USES_TERMINAL VERBATIM
    COMMENT "cppcheck, clang-tidy, clang-format: warnings are errors")
  add_custom_target(analyze-deep COMMAND ${analyze} --only tidy --max-nodes 225000 USES_TERMINAL VERBATIM
    COMMENT "clang-tidy, with all the nodes that clang's analyzer gives a function: warnings are errors")
  add_custom_target(archives
    COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/packages/packages.py make ${PROJECT_SOURCE_DIR}/build/packages
    USES_TERMINAL VERBATIM
    COMMENT "Archives for Arduino, PlatformIO, ESP-IDF, Zephyr, CMSIS-Pack, and of the sources")
  add_custom_target(site
    COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/site.py ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/build/site
            ${PROJECT_VERSION}
    USES_TERMINAL VERBATIM
    COMMENT "Pages, notes and reference, by Doxygen: what is undocumented or broken is an error")
endif()

find_program(BATUTA_GCOVR gcovr)
mark_as_advanced(BATUTA_GCOVR)
if(BATUTA_GCOVR)
  # Needs a tree built with --coverage, whose tests have run: the workflow preset `coverage`. Without early inlining: the
  # counters come after that pass, and would count a branch of an inline function anew wherever it went.
  set(gcovr ${BATUTA_GCOVR} --root ${PROJECT_SOURCE_DIR})
  set(counts ${PROJECT_BINARY_DIR}/coverage.json)
  add_custom_target(coverage
    COMMAND ${gcovr} --object-directory ${PROJECT_BINARY_DIR}
            --filter ${PROJECT_SOURCE_DIR}/src/ --filter ${PROJECT_SOURCE_DIR}/include/
            --exclude-throw-branches --exclude-unreachable-branches --json ${counts}
    COMMAND ${gcovr} --add-tracefile ${counts} --branches --output ${PROJECT_BINARY_DIR}/coverage-branches.txt
    COMMAND ${gcovr} --add-tracefile ${counts} --print-summary --fail-under-line 98 --fail-under-branch 92
    USES_TERMINAL VERBATIM
    COMMENT "Line and branch coverage of src and include")
endif()
