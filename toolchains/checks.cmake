# SPDX-License-Identifier: MIT
# Targets that look at the code instead of building it: analyze, coverage.
find_package(Python3 3.9 COMPONENTS Interpreter)

if(Python3_FOUND)
  add_custom_target(analyze
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/analyze.py
            --source ${PROJECT_SOURCE_DIR} --build ${PROJECT_BINARY_DIR}
    USES_TERMINAL VERBATIM
    COMMENT "cppcheck, clang-tidy, clang-format: warnings are errors")
endif()

find_program(BATUTA_GCOVR gcovr)
mark_as_advanced(BATUTA_GCOVR)
if(BATUTA_GCOVR)
  # Needs a tree built with --coverage, whose tests have run: the workflow preset `coverage`.
  add_custom_target(coverage
    COMMAND ${BATUTA_GCOVR} --root ${PROJECT_SOURCE_DIR} --object-directory ${PROJECT_BINARY_DIR}
            --filter ${PROJECT_SOURCE_DIR}/src/ --filter ${PROJECT_SOURCE_DIR}/include/
            --exclude-throw-branches --exclude-unreachable-branches
            --txt ${PROJECT_BINARY_DIR}/coverage-lines.txt --print-summary
    COMMAND ${BATUTA_GCOVR} --root ${PROJECT_SOURCE_DIR} --object-directory ${PROJECT_BINARY_DIR}
            --filter ${PROJECT_SOURCE_DIR}/src/ --filter ${PROJECT_SOURCE_DIR}/include/
            --exclude-throw-branches --exclude-unreachable-branches --branches
            --output ${PROJECT_BINARY_DIR}/coverage-branches.txt
    COMMAND ${CMAKE_COMMAND} -E cat ${PROJECT_BINARY_DIR}/coverage-lines.txt
    USES_TERMINAL VERBATIM
    COMMENT "Line and branch coverage of src and include")
endif()
